// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#if defined(__AVX2__)
#define GATUN_SIMD AVX2
#include "gatunNeighborSumLoops.h"
#include "gatunQuadraticLoops.h"
#else
#include "gatunNeighborSums.h"
#include "gatunQuadraticLanes.h"
#endif

namespace gatun
{
//------------------------------------------------------------------------------
std::optional<QuadraticKernels> GetAVX2QuadraticKernels()
{
#if defined(__AVX2__)
  return AVX2::GetQuadraticKernels();
#else
  return {};
#endif
}

//------------------------------------------------------------------------------
std::optional<NeighborSums> GetAVX2NeighborSums()
{
#if defined(__AVX2__)
  return AVX2::GetNeighborSums();
#else
  return {};
#endif
}
}
