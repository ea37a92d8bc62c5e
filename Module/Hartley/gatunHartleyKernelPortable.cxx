// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#define GATUN_SIMD Portable
#include "gatunHartleyLoops.h"

namespace gatun
{
//------------------------------------------------------------------------------
const HartleyKernelLoops& GetPortableHartleyKernel()
{
  static constexpr HartleyKernelLoops kernel = Portable::MakeHartleyKernel();
  return kernel;
}

//------------------------------------------------------------------------------
const HartleyKernelLoops& GetBestHartleyKernel()
{
#if defined(__x86_64__)
  const HartleyKernelLoops* const avx2 = GetAVX2HartleyKernel();
  if (avx2 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    return *avx2;
  }
#endif
  return GetPortableHartleyKernel();
}
}
