// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Differences between the VTK versions that Gatun supports, from 9.1 on.

#ifndef vtkGatunCompat_h
#define vtkGatunCompat_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace gatun
{
/** Whether an abort of the algorithm was requested. Call it from the main thread only. */
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
