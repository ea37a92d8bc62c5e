// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunReader.h"

#include "gatunFileReader.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <new>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunReader);

vtkGatunReader::vtkGatunReader() = default;
vtkGatunReader::~vtkGatunReader() = default;

//------------------------------------------------------------------------------
void vtkGatunReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplitCells: " << (this->SplitCells ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* vtkGatunReader::GetOutput()
{
  return this->GetOutput(0);
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* vtkGatunReader::GetOutput(int port)
{
  return vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(port));
}

//------------------------------------------------------------------------------
int vtkGatunReader::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunReader::CanReadFile(const char* name)
{
  try
  {
    return name && gatun::FileReader::CanRead(name) && !gatun::FileReader::IsSurfaceFile(name) ? 1
                                                                                               : 0;
  }
  catch (const std::bad_alloc&)
  {
    return 0; // there is not even memory for the name
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
