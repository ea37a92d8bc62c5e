// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnWriteGatun.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnProgress.h"

#include "vtkGatunErrorCode.h"
#include "vtkGatunHartleyWriter.h"
#include "vtkGatunWriter.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"

namespace gtn
{
//------------------------------------------------------------------------------
template <typename Writer>
void RunWriter(Writer* writer, const std::string& inputName, Progress& progress)
{
  progress.Watch(writer);
  const bool good = writer->Write() != 0;
  CheckInterrupt();
  const std::vector<std::string> errors = TakeErrors();
  if (good && errors.empty())
  {
    return;
  }
  const std::string file = writer->GetFileName();
  const std::string reason = errors.empty() ? "cannot write" : errors.front();
  const unsigned long code = writer->GetErrorCode();
  const bool inputIsToBlame = code == vtkGatunErrorCode::InvalidInputError ||
    (code == vtkErrorCode::UnknownError && !reason.starts_with(file));
  if (inputIsToBlame && reason.starts_with(file + ": "))
  {
    throw Failure(inputName, reason.substr(file.size() + 2));
  }
  throw Failure(inputIsToBlame ? inputName : file, reason);
}

template void RunWriter(vtkGatunWriter*, const std::string&, Progress&);
template void RunWriter(vtkGatunHartleyWriter*, const std::string&, Progress&);

//------------------------------------------------------------------------------
void WriteGatun(vtkDataObject* mesh, const std::string& file, Progress& progress)
{
  vtkNew<vtkGatunWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(file.c_str());
  RunWriter(writer.Get(), file, progress);
}
}
