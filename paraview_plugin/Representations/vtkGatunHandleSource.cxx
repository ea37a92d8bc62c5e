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
void vtkGatunHandleSource::SetFile(vtkGatunFileHandle* handle, vtkUnstructuredGrid* grid)
{
  if (handle != this->Handle || grid != this->Grid)
  {
    this->Handle = handle;
    this->Grid = grid;
    this->Modified();
  }
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
  auto* const output = vtkUnstructuredGrid::GetData(outputVector, 0);
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
