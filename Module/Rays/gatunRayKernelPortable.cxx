// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#define GATUN_SIMD Portable
#include "gatunRayLoops.h"

namespace gatun
{
//------------------------------------------------------------------------------
const RayKernel& GetPortableRayKernel()
{
  static constexpr RayKernel kernel = Portable::MakeKernel("portable");
  return kernel;
}

//------------------------------------------------------------------------------
const RayKernel& GetRayKernel([[maybe_unused]] RayInstructions instructions)
{
#if defined(__x86_64__)
  const bool hasAVX2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool hasAVX512 = hasAVX2 && __builtin_cpu_supports("avx512f") &&
    __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
    __builtin_cpu_supports("avx512bw");
  const RayKernel* const avx512 = GetAVX512RayKernel();
  if (instructions >= RayInstructions::AVX512 && hasAVX512 && avx512)
  {
    return *avx512;
  }
  const RayKernel* const avx2 = GetAVX2RayKernel();
  if (instructions >= RayInstructions::AVX2 && hasAVX2 && avx2)
  {
    return *avx2;
  }
#endif
  return GetPortableRayKernel();
}
}
