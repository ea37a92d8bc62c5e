// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMGatunColoringDomain
 * @brief Colors a representation by an array when a representation type without solid colors is
 * chosen.
 *
 * A volume needs an array. ParaView selects one only for the type "Volume". This domain does so for
 * the type that the attribute "representation" names: when that type is chosen, in the client or by
 * a script, and nothing is selected to color by, the array is that of gatun::FindArrayToShow.
 * Transfer functions that are new get the range of the array; others stay as they are. Nothing
 * happens while a state file is loaded, as it has the colors, too.
 *
 * With parallel_projection="1", a parallel projection of the views is turned on, too, which shows
 * as much as before.
 *
 * It belongs to a property of a representation and has the required property Representation.
 * ParaView prescribes the prefix of the name: GatunColoringDomain in XML.
 */

#ifndef vtkSMGatunColoringDomain_h
#define vtkSMGatunColoringDomain_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkSMDomain.h"

#include <string> // For std::string

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkSMPVRepresentationProxy;
class vtkSMProxy;

class VTKGATUNPARAVIEW_EXPORT vtkSMGatunColoringDomain : public vtkSMDomain
{
public:
  static vtkSMGatunColoringDomain* New();
  vtkTypeMacro(vtkSMGatunColoringDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* requestingProperty) override;

protected:
  vtkSMGatunColoringDomain() = default;
  ~vtkSMGatunColoringDomain() override = default;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMGatunColoringDomain(const vtkSMGatunColoringDomain&) = delete;
  void operator=(const vtkSMGatunColoringDomain&) = delete;

  static void ColorByArray(vtkSMPVRepresentationProxy* representation);
  static void MakeParallel(vtkSMProxy* representation);

  std::string RepresentationType;
  bool NeedsParallelProjection = false;
  bool IsChosen = false; // whether it was at the last update
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
