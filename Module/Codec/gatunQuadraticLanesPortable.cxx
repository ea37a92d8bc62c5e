// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#define GATUN_SIMD Portable
#include "gatunQuadraticLoops.h"

namespace gatun
{
//------------------------------------------------------------------------------
const QuadraticKernels& GetPortableQuadraticKernels()
{
  return Portable::Kernels;
}

//------------------------------------------------------------------------------
const QuadraticKernels& GetBestQuadraticKernels()
{
#if defined(__x86_64__)
  static const auto* best = __builtin_cpu_supports("avx2") ? GetAVX2QuadraticKernels() : nullptr;
  return best ? *best : GetPortableQuadraticKernels();
#else
  return GetPortableQuadraticKernels();
#endif
}
}
