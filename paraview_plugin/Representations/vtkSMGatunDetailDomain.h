// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMGatunDetailDomain
 * @brief Tells the panel of a representation whether its input can be simplified.
 *
 * Sets its property to 1 if Gatun Volume can draw the input as a coarser mesh, and to 0 otherwise:
 * for a reader on demand whose file has no hierarchy, and for meshes in memory of several
 * processes. The properties that simplify are greyed out by it. The required property is Input.
 * ParaView prescribes the prefix of the name: GatunDetailDomain in XML.
 */

#ifndef vtkSMGatunDetailDomain_h
#define vtkSMGatunDetailDomain_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkSMDomain.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class VTKGATUNPARAVIEW_EXPORT vtkSMGatunDetailDomain : public vtkSMDomain
{
public:
  static vtkSMGatunDetailDomain* New();
  vtkTypeMacro(vtkSMGatunDetailDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* requestingProperty) override;

protected:
  vtkSMGatunDetailDomain() = default;
  ~vtkSMGatunDetailDomain() override = default;

private:
  vtkSMGatunDetailDomain(const vtkSMGatunDetailDomain&) = delete;
  void operator=(const vtkSMGatunDetailDomain&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
