// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunPVMergeBlocks.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunPVMergeBlocks);

//------------------------------------------------------------------------------
vtkGatunPVMergeBlocks::vtkGatunPVMergeBlocks()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkGatunPVMergeBlocks::~vtkGatunPVMergeBlocks() = default;

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
