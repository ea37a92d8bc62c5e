// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunPVMergeBlocks
 * @brief Merges blocks in ParaView, on all processes of the data server.
 *
 * Differs from vtkGatunMergeBlocks in its Controller, which is the global one.
 *
 * @sa vtkGatunMergeBlocks vtkGatunPVWriter
 */

#ifndef vtkGatunPVMergeBlocks_h
#define vtkGatunPVMergeBlocks_h

#include "vtkGatunMergeBlocks.h"
#include "vtkGatunParaViewModule.h" // For export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class VTKGATUNPARAVIEW_EXPORT vtkGatunPVMergeBlocks : public vtkGatunMergeBlocks
{
public:
  static vtkGatunPVMergeBlocks* New();
  vtkTypeMacro(vtkGatunPVMergeBlocks, vtkGatunMergeBlocks);

protected:
  vtkGatunPVMergeBlocks();
  ~vtkGatunPVMergeBlocks() override;

private:
  vtkGatunPVMergeBlocks(const vtkGatunPVMergeBlocks&) = delete;
  void operator=(const vtkGatunPVMergeBlocks&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
