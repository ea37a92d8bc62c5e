// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMGatunDetailDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"
#include "vtkSMSourceProxy.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkSMGatunDetailDomain);

namespace
{
//------------------------------------------------------------------------------
/** The present value of an information property of a source, or of a proxy in it. */
int GetInformation(vtkSMProperty* property)
{
  property->GetParent()->UpdatePropertyInformation(property);
  return vtkSMPropertyHelper(property).GetAsInt();
}

//------------------------------------------------------------------------------
bool CanSimplify(vtkSMSourceProxy* source)
{
  vtkSMProperty* const isOnDemand = source->GetProperty("IsOnDemand");
  vtkSMProperty* const hasHierarchy = source->GetProperty("HasHierarchy");
  if (isOnDemand && hasHierarchy && GetInformation(isOnDemand) != 0)
  {
    return GetInformation(hasHierarchy) != 0;
  }
  return source->GetSession()->GetNumberOfProcesses(vtkPVSession::DATA_SERVER) == 1;
}
}

//------------------------------------------------------------------------------
void vtkSMGatunDetailDomain::Update(vtkSMProperty*)
{
  vtkSMProperty* const input = this->GetRequiredProperty("Input");
  auto* const source =
    input ? vtkSMSourceProxy::SafeDownCast(vtkSMPropertyHelper(input).GetAsProxy()) : nullptr;
  if (!source || !source->GetObjectsCreated() || !this->GetProperty())
  {
    return;
  }
  const int value = CanSimplify(source) ? 1 : 0;
  vtkSMPropertyHelper helper(this->GetProperty());
  if (helper.GetAsInt() != value)
  {
    helper.Set(value);
    this->DomainModified();
  }
}

//------------------------------------------------------------------------------
void vtkSMGatunDetailDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
