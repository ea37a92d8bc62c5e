// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHandleSource.h"

#include "vtkGatunFileHandle.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHandleSource);

//------------------------------------------------------------------------------
vtkGatunHandleSource::vtkGatunHandleSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkGatunHandleSource::~vtkGatunHandleSource() = default;

//------------------------------------------------------------------------------
void vtkGatunHandleSource::SetFile(vtkGatunFileHandle* handle, vtkDataSet* grid)
{
  if (handle != this->Handle || grid != this->Grid)
  {
    this->Handle = handle;
    this->Grid = grid;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkGatunHandleSource::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  vtkDataObject* const output = outInfo->Get(vtkDataObject::DATA_OBJECT());
  if (!this->Grid && !output)
  {
    vtkNew<vtkUnstructuredGrid> none;
    outInfo->Set(vtkDataObject::DATA_OBJECT(), none);
  }
  else if (this->Grid &&
    (!output || output->GetDataObjectType() != this->Grid->GetDataObjectType()))
  {
    const auto made = vtk::TakeSmartPointer(this->Grid->NewInstance());
    outInfo->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHandleSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  outInfo->Set(vtkGatunFileHandle::FILE_HANDLE(), this->Handle);
  outInfo->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHandleSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkDataObject* const output = vtkDataObject::GetData(outputVector, 0);
  output->Initialize();
  if (this->Grid)
  {
    output->ShallowCopy(this->Grid);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunHandleSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Handle: " << this->Handle.Get() << "\n";
  os << indent << "Grid: " << this->Grid.Get() << "\n";
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
