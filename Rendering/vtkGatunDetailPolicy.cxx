// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunDetailPolicy.h"

#include "vtkObjectFactory.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunDetailPolicy);

//------------------------------------------------------------------------------
void vtkGatunDetailPolicy::DeepCopy(vtkGatunDetailPolicy* other)
{
  if (other)
  {
    this->SetJustInTime(other->JustInTime);
    this->SetTimeBudget(other->TimeBudget);
    this->SetViewDependent(other->ViewDependent);
    this->SetPixelError(other->PixelError);
    this->SetSimplificationRatio(other->SimplificationRatio);
  }
}

//------------------------------------------------------------------------------
void vtkGatunDetailPolicy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "JustInTime: " << (this->JustInTime ? "On" : "Off") << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "ViewDependent: " << (this->ViewDependent ? "On" : "Off") << "\n";
  os << indent << "PixelError: " << this->PixelError << "\n";
  os << indent << "SimplificationRatio: " << this->SimplificationRatio << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
