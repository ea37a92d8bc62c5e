// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#if defined(__AVX2__) && defined(__FMA__)
#define GATUN_SIMD AVX2
#include "gatunHartleyLaneLoops.h"
#include "gatunHartleyLoops.h"
#else
#include "gatunHartleyKernel.h"
#include "gatunHartleyLanes.h"
#endif

namespace gatun
{
//------------------------------------------------------------------------------
const HartleyKernelLoops* GetAVX2HartleyKernel()
{
#if defined(__AVX2__) && defined(__FMA__)
  static constexpr HartleyKernelLoops kernel = AVX2::MakeHartleyKernel();
  return &kernel;
#else
  return nullptr;
#endif
}

//------------------------------------------------------------------------------
const HartleyLaneLoops* GetAVX2HartleyLanes()
{
#if defined(__AVX2__) && defined(__FMA__) && defined(__F16C__)
  static constexpr HartleyLaneLoops loops = AVX2::MakeHartleyLanes();
  return &loops;
#else
  return nullptr;
#endif
}
}
