// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__AVX512BW__)
#define GATUN_HAS_AVX512
#define GATUN_SIMD AVX512
#include "gatunRayLoops.h"
#else
#include "gatunRayKernel.h"
#endif

namespace gatun
{
//------------------------------------------------------------------------------
const RayKernel* GetAVX512RayKernel()
{
#if defined(GATUN_HAS_AVX512)
  static constexpr RayKernel kernel = AVX512::MakeKernel("AVX-512");
  return &kernel;
#else
  return nullptr;
#endif
}
}
