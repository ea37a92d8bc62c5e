// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMGatunArrayListDomain.h"

#include "gatunArrayToShow.h"

#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkSMGatunArrayListDomain);

//------------------------------------------------------------------------------
int vtkSMGatunArrayListDomain::SetDefaultValues(vtkSMProperty* property, bool unchecked)
{
  vtkPVDataInformation* const data = this->GetInputDataInformation("Input");
  const auto place = data ? gatun::FindArrayToShow(*this, *data) : std::nullopt;
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(unchecked);
  if (!place || helper.GetNumberOfElements() != 5)
  {
    return this->Superclass::SetDefaultValues(property, unchecked);
  }
  helper.SetInputArrayToProcess(this->GetFieldAssociation(*place), this->GetString(*place));
  return 1;
}

//------------------------------------------------------------------------------
void vtkSMGatunArrayListDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
