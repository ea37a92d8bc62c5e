// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// What differs between VTK 9.1, ParaView 5.11's VTK and later ones.

#ifndef vtkGatunCompat_h
#define vtkGatunCompat_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace gatun
{
/** Whether somebody asked the algorithm to stop. To be called from the main thread. */
inline bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20221118)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}
}

#endif
// VTK-HeaderTest-Exclude: vtkGatunCompat.h
