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
const RayKernel& GetBestRayKernel()
{
#if defined(__x86_64__)
  const RayKernel* const avx2 = GetAVX2RayKernel();
  if (avx2 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    return *avx2;
  }
#endif
  return GetPortableRayKernel();
}
}
