// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#define GATUN_SIMD Portable
#include "gatunHartleyLaneLoops.h"
#include "gatunHartleyLoops.h"

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace gatun
{
namespace
{
//------------------------------------------------------------------------------
bool HasAVX2()
{
#if defined(__x86_64__)
  // Not all compilers have a name for F16C in __builtin_cpu_supports.
  unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
    __get_cpuid(1, &eax, &ebx, &ecx, &edx) != 0 && (ecx & bit_F16C) != 0;
#else
  return false;
#endif
}
}

//------------------------------------------------------------------------------
const HartleyKernelLoops& GetPortableHartleyKernel()
{
  static constexpr HartleyKernelLoops kernel = Portable::MakeHartleyKernel();
  return kernel;
}

//------------------------------------------------------------------------------
const HartleyKernelLoops& GetBestHartleyKernel()
{
  static const HartleyKernelLoops* const avx2 = HasAVX2() ? GetAVX2HartleyKernel() : nullptr;
  return avx2 ? *avx2 : GetPortableHartleyKernel();
}

//------------------------------------------------------------------------------
const HartleyLaneLoops& GetPortableHartleyLanes()
{
  static constexpr HartleyLaneLoops loops = Portable::MakeHartleyLanes();
  return loops;
}

//------------------------------------------------------------------------------
const HartleyLaneLoops& GetBestHartleyLanes()
{
  static const HartleyLaneLoops* const avx2 = HasAVX2() ? GetAVX2HartleyLanes() : nullptr;
  return avx2 ? *avx2 : GetPortableHartleyLanes();
}
}
