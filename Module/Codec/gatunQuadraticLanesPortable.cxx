// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#define GATUN_SIMD Portable
#include "gatunNeighborSumLoops.h"
#include "gatunQuadraticLoops.h"

namespace gatun
{
namespace
{
bool HasAVX2()
{
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}
}

//------------------------------------------------------------------------------
QuadraticKernels GetPortableQuadraticKernels()
{
  return Portable::GetQuadraticKernels();
}

//------------------------------------------------------------------------------
const QuadraticKernels& GetBestQuadraticKernels()
{
  static const auto best = (HasAVX2() ? GetAVX2QuadraticKernels() : std::nullopt)
                             .value_or(GetPortableQuadraticKernels());
  return best;
}

//------------------------------------------------------------------------------
NeighborSums GetPortableNeighborSums()
{
  return Portable::GetNeighborSums();
}

//------------------------------------------------------------------------------
const NeighborSums& GetBestNeighborSums()
{
  static const auto best =
    (HasAVX2() ? GetAVX2NeighborSums() : std::nullopt).value_or(GetPortableNeighborSums());
  return best;
}
}
