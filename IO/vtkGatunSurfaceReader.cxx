// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSurfaceReader.h"

#include "gatunFileReader.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <new>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunSurfaceReader);

vtkGatunSurfaceReader::vtkGatunSurfaceReader() = default;
vtkGatunSurfaceReader::~vtkGatunSurfaceReader() = default;

//------------------------------------------------------------------------------
vtkPolyData* vtkGatunSurfaceReader::GetOutput()
{
  return this->GetOutput(0);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkGatunSurfaceReader::GetOutput(int port)
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(port));
}

//------------------------------------------------------------------------------
int vtkGatunSurfaceReader::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunSurfaceReader::CanReadFile(const char* name)
{
  try
  {
    return name && gatun::FileReader::IsSurfaceFile(name) ? 1 : 0;
  }
  catch (const std::bad_alloc&)
  {
    return 0; // there is not even memory for the name
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
