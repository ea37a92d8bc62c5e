// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunPVContour.h"

#include "gatunFilePiece.h"

#include "vtkObjectFactory.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunPVContour);

//------------------------------------------------------------------------------
vtkGatunPVContour::vtkGatunPVContour() = default;

vtkGatunPVContour::~vtkGatunPVContour() = default;

//------------------------------------------------------------------------------
vtkInformation* vtkGatunPVContour::GetFileInformation(vtkInformation* inInfo)
{
  vtkInformation* const source = gatun::FindSource(this);
  return source ? source : this->Superclass::GetFileInformation(inInfo);
}

//------------------------------------------------------------------------------
void vtkGatunPVContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
