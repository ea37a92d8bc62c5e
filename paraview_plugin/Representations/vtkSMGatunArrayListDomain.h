// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMGatunArrayListDomain
 * @brief A list of arrays whose default is not an array of ids or ghost types.
 *
 * ParaView's list takes the first array in alphabetical order if there are no active scalars, which
 * often is GlobalNodeId or the like. This one takes such an array only if there is no other.
 * ParaView prescribes the prefix of the name: GatunArrayListDomain in XML.
 */

#ifndef vtkSMGatunArrayListDomain_h
#define vtkSMGatunArrayListDomain_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkSMArrayListDomain.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class VTKGATUNPARAVIEW_EXPORT vtkSMGatunArrayListDomain : public vtkSMArrayListDomain
{
public:
  static vtkSMGatunArrayListDomain* New();
  vtkTypeMacro(vtkSMGatunArrayListDomain, vtkSMArrayListDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int SetDefaultValues(vtkSMProperty* property, bool unchecked) override;

protected:
  vtkSMGatunArrayListDomain() = default;
  ~vtkSMGatunArrayListDomain() override = default;

private:
  vtkSMGatunArrayListDomain(const vtkSMGatunArrayListDomain&) = delete;
  void operator=(const vtkSMGatunArrayListDomain&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
