// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunUpdateResult_h
#define vtkGatunUpdateResult_h

#include "vtkVersionMacros.h" // For VTK_VERSION_NUMBER

/** What vtkAlgorithm::Update returns: nothing, or since VTK 9.7 whether the update succeeded. */
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 20251127)
#define VTK_GATUN_UPDATE_RESULT bool
#else
#define VTK_GATUN_UPDATE_RESULT void
#endif

#endif
// VTK-HeaderTest-Exclude: vtkGatunUpdateResult.h
