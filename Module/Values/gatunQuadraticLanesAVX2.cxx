// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#if defined(__AVX2__)
#define GATUN_SIMD AVX2
#include "gatunQuadraticLoops.h"
#else
#include "gatunQuadraticLanes.h"
#endif

namespace gatun
{
//------------------------------------------------------------------------------
FindQuadraticWeights GetAVX2QuadraticWeights()
{
#if defined(__AVX2__)
  return AVX2::FindWeights;
#else
  return nullptr;
#endif
}
}
