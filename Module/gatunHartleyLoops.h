// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLoops_h
#define gatunHartleyLoops_h

// Compiled once for each set of instructions; see gatunSimd.h.

#include "gatunHartleyKernel.h"
#include "gatunSimd.h"

namespace gatun
{
namespace GATUN_SIMD
{
//------------------------------------------------------------------------------
inline void Combine(
  const HartleyShare* shares, std::size_t shareCount, std::size_t count, float* sum)
{
  // Sums stay in registers while all shares pass.
  std::size_t i = 0;
  for (; i + 32 <= count; i += 32)
  {
    Float8 a{}, b{}, c{}, d{};
    for (std::size_t k = 0; k < shareCount; ++k)
    {
      const float* const values = shares[k].Values + i;
      const Float8 scale = Splat8(shares[k].Scale);
      a += scale * Load<Float8>(values);
      b += scale * Load<Float8>(values + 8);
      c += scale * Load<Float8>(values + 16);
      d += scale * Load<Float8>(values + 24);
    }
    Store(sum + i, a);
    Store(sum + i + 8, b);
    Store(sum + i + 16, c);
    Store(sum + i + 24, d);
  }
  for (; i < count; ++i)
  {
    float total = 0;
    for (std::size_t k = 0; k < shareCount; ++k)
    {
      total += shares[k].Scale * shares[k].Values[i];
    }
    sum[i] = total;
  }
}

//------------------------------------------------------------------------------
/** R. G. Keys: Cubic convolution interpolation for digital image processing. IEEE Transactions on
 * Acoustics, Speech, and Signal Processing 29(6), 1981. */
GATUN_INLINE Float4 GetCubicWeights(float x)
{
  const float y = 1 - x;
  return Float4{ -0.5f * x * y * y, 1 + x * x * (1.5f * x - 2.5f), 1 + y * y * (1.5f * y - 2.5f),
    -0.5f * y * x * x };
}

//------------------------------------------------------------------------------
inline void Interpolate(const float* first, std::size_t nextRow, float x, float y, float* channels)
{
  const Float4 across = GetCubicWeights(x);
  const Float4 down = GetCubicWeights(y);
  Float4 sum{};
  for (int row = 0; row < 4; ++row, first += nextRow)
  {
    const Float4 mixed = Splat4(across[0]) * Load<Float4>(first) +
      Splat4(across[1]) * Load<Float4>(first + 4) + Splat4(across[2]) * Load<Float4>(first + 8) +
      Splat4(across[3]) * Load<Float4>(first + 12);
    sum += Splat4(down[row]) * mixed;
  }
  Store(channels, sum);
}

//------------------------------------------------------------------------------
constexpr HartleyKernelLoops MakeHartleyKernel()
{
  return { Combine, Interpolate };
}
}
}

#endif
