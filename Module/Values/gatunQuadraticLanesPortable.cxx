// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#define GATUN_SIMD Portable
#include "gatunQuadraticLoops.h"

namespace gatun
{
//------------------------------------------------------------------------------
FindQuadraticWeights GetPortableQuadraticWeights()
{
  return Portable::FindWeights;
}

//------------------------------------------------------------------------------
FindQuadraticWeights GetBestQuadraticWeights()
{
#if defined(__x86_64__)
  static const auto best = __builtin_cpu_supports("avx2") ? GetAVX2QuadraticWeights() : nullptr;
  return best ? best : GetPortableQuadraticWeights();
#else
  return GetPortableQuadraticWeights();
#endif
}
}
