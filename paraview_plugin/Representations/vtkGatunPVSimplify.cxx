// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunPVSimplify.h"

#include "gatunFilePiece.h"

#include "vtkObjectFactory.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunPVSimplify);

//------------------------------------------------------------------------------
vtkGatunPVSimplify::vtkGatunPVSimplify() = default;

vtkGatunPVSimplify::~vtkGatunPVSimplify() = default;

//------------------------------------------------------------------------------
vtkInformation* vtkGatunPVSimplify::GetFileInformation(vtkInformation* inInfo)
{
  vtkInformation* const source = gatun::FindSource(this);
  return source ? source : this->Superclass::GetFileInformation(inInfo);
}

//------------------------------------------------------------------------------
void vtkGatunPVSimplify::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
