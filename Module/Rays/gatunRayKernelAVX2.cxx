// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#if defined(__AVX2__) && defined(__FMA__)
#define GATUN_SIMD AVX2
#include "gatunRayLoops.h"
#else
#include "gatunRayKernel.h"
#endif

namespace gatun
{
//------------------------------------------------------------------------------
const RayKernel* GetAVX2RayKernel()
{
#if defined(__AVX2__) && defined(__FMA__)
  static constexpr RayKernel kernel = AVX2::MakeKernel("AVX2");
  return &kernel;
#else
  return nullptr;
#endif
}
}
