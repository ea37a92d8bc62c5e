// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceSource.h"

#include "vtkGatunFileHandle.h"
#include "vtkGatunHandleSource.h"
#include "vtkGatunMeshReader.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
vtkGatunFileHandle* GetHandle(vtkAlgorithm* source)
{
  return vtkGatunFileHandle::SafeDownCast(
    source->GetOutputInformation(0)->Get(vtkGatunFileHandle::FILE_HANDLE()));
}

//------------------------------------------------------------------------------
PieceSource::PieceSource(vtkSmartPointer<vtkGatunMeshReader> reader)
  : OtherFile(std::move(reader))
{
  this->OtherFile->SetLargeMesh(0);
}

PieceSource::~PieceSource() = default;

//------------------------------------------------------------------------------
vtkGatunFileHandle* PieceSource::FindFile(vtkAlgorithm* representation)
{
  this->HasInput = true;
  vtkGatunFileHandle* const handle = FindHandle(representation);
  this->Handle =
    handle && handle->GetCanReplaceOutput() && handle->GetIsOnDemand() ? handle : nullptr;
  return this->Handle;
}

//------------------------------------------------------------------------------
DrawnFile PieceSource::GetMark(vtkDataObject* piece) const
{
  return piece && (this->Handle || !this->HasInput) ? gatun::GetMark(piece) : DrawnFile();
}

//------------------------------------------------------------------------------
vtkAlgorithm* PieceSource::Connect(
  vtkAlgorithm* representation, vtkDataSet* piece, const DrawnFile& file)
{
  if (this->Handle)
  {
    // The reader may have opened the file again, or failed to, without an update of the
    // representation.
    vtkGatunFileHandle* const current = FindHandle(representation);
    if (!current || !current->GetIsOpen())
    {
      return nullptr;
    }
    this->Handle = current;
  }
  vtkAlgorithm* source = this->OtherFile;
  if (this->Handle && this->Handle->GetFileName() == file.Path &&
    this->Handle->GetNumberOfMerges() == file.Merges)
  {
    this->OwnFile->SetFile(this->Handle, piece);
    source = this->OwnFile;
  }
  else
  {
    this->OwnFile->SetFile(nullptr, nullptr);
    this->OtherFile->SetFileName(file.Path.c_str());
    this->OtherFile->SetSimplificationNumberOfPoints(0);
    this->OtherFile->UpdateInformation();
    vtkGatunFileHandle* const whole = GetHandle(this->OtherFile);
    if (!whole || !whole->GetIsOpen())
    {
      return nullptr;
    }
    if (file.Merges > 0)
    {
      this->OtherFile->SetSimplificationNumberOfPoints(whole->GetNumberOfPoints() - file.Merges);
    }
  }
  source->UpdateTimeStep(file.Time);
  return source->GetErrorCode() == vtkErrorCode::NoError ? source : nullptr;
}
}
