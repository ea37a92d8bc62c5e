// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMGatunColoringDomain.h"

#include "gatunArrayToShow.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMArrayListDomain.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionProxy.h"

#include <cmath>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkSMGatunColoringDomain);

namespace
{
//------------------------------------------------------------------------------
vtkPVDataInformation* GetInputInformation(vtkSMProxy* representation)
{
  vtkSMPropertyHelper input(representation, "Input", /*quiet*/ true);
  auto* const source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  return source ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
}

//------------------------------------------------------------------------------
vtkSMProxy* GetFunction(vtkSMProxy* representation, const char* name)
{
  return vtkSMPropertyHelper(representation, name, /*quiet*/ true).GetAsProxy();
}

//------------------------------------------------------------------------------
bool HasRange(vtkSMProxy* function)
{
  return function && vtkSMPropertyHelper(function, "ScalarRangeInitialized", true).GetAsInt() != 0;
}
}

//------------------------------------------------------------------------------
int vtkSMGatunColoringDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  this->RepresentationType = element->GetAttributeOrEmpty("representation");
  int needsParallel = 0;
  this->NeedsParallelProjection =
    element->GetScalarAttribute("parallel_projection", &needsParallel) != 0 && needsParallel != 0;
  return this->Superclass::ReadXMLAttributes(property, element);
}

//------------------------------------------------------------------------------
void vtkSMGatunColoringDomain::Update(vtkSMProperty*)
{
  vtkSMProperty* const type = this->GetRequiredProperty("Representation");
  auto* const representation = vtkSMPVRepresentationProxy::SafeDownCast(
    this->GetProperty() ? this->GetProperty()->GetParent() : nullptr);
  if (!type || !representation)
  {
    return;
  }
  const char* const name = vtkSMPropertyHelper(type).GetAsString();
  const bool wasChosen = this->IsChosen;
  this->IsChosen = name && this->RepresentationType == name;
  if (!this->IsChosen || wasChosen || representation->GetSessionProxyManager()->GetInLoadXMLState())
  {
    return;
  }
  if (!representation->GetUsingScalarColoring())
  {
    ColorByArray(representation);
  }
  if (this->NeedsParallelProjection)
  {
    MakeParallel(representation);
  }
}

//------------------------------------------------------------------------------
/** In the views that show the representation. */
void vtkSMGatunColoringDomain::MakeParallel(vtkSMProxy* representation)
{
  for (unsigned int i = 0; i < representation->GetNumberOfConsumers(); ++i)
  {
    auto* const view = vtkSMRenderViewProxy::SafeDownCast(representation->GetConsumerProxy(i));
    if (!view || vtkSMPropertyHelper(view, "CameraParallelProjection").GetAsInt() != 0)
    {
      continue;
    }
    if (vtkCamera* const camera = view->GetActiveCamera())
    {
      vtkSMPropertyHelper(view, "CameraParallelScale")
        .Set(camera->GetDistance() *
          std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2));
    }
    vtkSMPropertyHelper(view, "CameraParallelProjection").Set(1);
    view->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkSMGatunColoringDomain::ColorByArray(vtkSMPVRepresentationProxy* representation)
{
  vtkSMProperty* const colors = representation->GetProperty("ColorArrayName");
  auto* const list = colors ? colors->FindDomain<vtkSMArrayListDomain>() : nullptr;
  vtkPVDataInformation* const data = GetInputInformation(representation);
  const auto place = list && data ? gatun::FindArrayToShow(*list, *data) : std::nullopt;
  if (!place ||
    !representation->SetScalarColoring(list->GetString(*place), list->GetFieldAssociation(*place)))
  {
    return;
  }
  // A script may have set up the functions before; the range would replace what it set.
  vtkSMProxy* const color = GetFunction(representation, "LookupTable");
  vtkSMProxy* const opacity = GetFunction(representation, "ScalarOpacityFunction");
  double range[2];
  if (!HasRange(color))
  {
    representation->RescaleTransferFunctionToDataRange(true);
  }
  else if (!HasRange(opacity) && vtkSMTransferFunctionProxy::GetRange(color, range))
  {
    vtkSMTransferFunctionProxy::RescaleTransferFunction(opacity, range[0], range[1]);
  }
}

//------------------------------------------------------------------------------
void vtkSMGatunColoringDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RepresentationType: " << this->RepresentationType << "\n";
  os << indent << "IsChosen: " << (this->IsChosen ? "true" : "false") << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
