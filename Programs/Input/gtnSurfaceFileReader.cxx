// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSurfaceFileReader.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>

namespace gtn
{
vtkStandardNewMacro(SurfaceFileReader);

//------------------------------------------------------------------------------
SurfaceFileReader::SurfaceFileReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
void SurfaceFileReader::SetFile(const std::string& file, SurfaceFunction read)
{
  this->File = file;
  this->ReadSurface = read;
  this->Modified();
}

//------------------------------------------------------------------------------
int SurfaceFileReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  try
  {
    std::vector<std::string> leftOut;
    const auto progress = [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return this->GetAbortExecute() == 0;
    };
    vtkPolyData::GetData(outputVector)
      ->ShallowCopy(this->ReadSurface(this->File, progress, leftOut));
    if (!leftOut.empty())
    {
      vtkWarningMacro(<< "what is not read of the file: " << Join(leftOut));
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< ReasonOf(error));
    return 0;
  }
  return 1;
}
}
