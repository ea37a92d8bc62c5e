// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkGatunPVSimplify
 * @brief Simplification in ParaView, where a vtkPVPostFilter is between a reader and its filters.
 *
 * The filter finds the file handle of a reader behind ParaView's vtkPVPostFilter, too, and then
 * works directly from the file. It asks for its input like any other filter, so that the
 * information that ParaView shows of the reader is the same as without this filter.
 *
 * @sa vtkGatunSimplify vtkGatunFileHandle
 */

#ifndef vtkGatunPVSimplify_h
#define vtkGatunPVSimplify_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkGatunSimplify.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class VTKGATUNPARAVIEW_EXPORT vtkGatunPVSimplify : public vtkGatunSimplify
{
public:
  static vtkGatunPVSimplify* New();
  vtkTypeMacro(vtkGatunPVSimplify, vtkGatunSimplify);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkGatunPVSimplify();
  ~vtkGatunPVSimplify() override;

  vtkInformation* GetFileInformation(vtkInformation* inInfo) override;

private:
  vtkGatunPVSimplify(const vtkGatunPVSimplify&) = delete;
  void operator=(const vtkGatunPVSimplify&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
