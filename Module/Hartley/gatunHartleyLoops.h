// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLoops_h
#define gatunHartleyLoops_h

// Compiled once for each instruction set; see gatunSimd.h.

#include "gatunHartleyCompositing.h"
#include "gatunHartleyKernel.h"
#include "gatunSimd.h"

namespace gatun
{
namespace GATUN_SIMD
{
//------------------------------------------------------------------------------
inline void Combine(
  const float* values, const HartleyShare* shares, std::size_t shareCount, float* sum)
{
  constexpr std::size_t vectors = HartleySegment / 8;
  Float8 total[vectors] = {};
  for (std::size_t i = 0; i < shareCount; ++i)
  {
    const float* const from = values + shares[i].First;
    const Float8 scale = Splat8(shares[i].Scale);
    for (std::size_t k = 0; k < vectors; ++k)
    {
      total[k] += scale * Load<Float8>(from + 8 * k);
    }
  }
  for (std::size_t k = 0; k < vectors; ++k)
  {
    Store(sum + 8 * k, total[k]);
  }
}

//------------------------------------------------------------------------------
inline float SumBands(const float* line, const HartleyBetween& between, const HartleyBand* across,
  const HartleyBand* down, std::size_t count, float least)
{
  // Makes frequencies positive, so that truncation rounds down. Even, to preserve the parity of the
  // period.
  constexpr int offset = 64;

  Float8 total{};
  for (std::size_t j = 0; j < count; ++j)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      float tent = across[i].Tent * down[j].Tent;
      if (tent < least)
      {
        continue;
      }
      const double along =
        -(between.ShearX * across[i].Frequency + between.ShearY * down[j].Frequency);
      const auto tentAt = static_cast<float>(along < 0 ? -along : along) * between.TentSteps;
      const auto tentStep = static_cast<std::int32_t>(tentAt);
      const float* const tents = between.Tents + tentStep;
      tent *= tents[0] + (tentAt - static_cast<float>(tentStep)) * (tents[1] - tents[0]);
      if (tent < least)
      {
        continue;
      }
      const auto period = static_cast<std::int32_t>(along + offset);
      const auto at = static_cast<float>((along - (period - offset)) * between.Points);
      const auto point = static_cast<std::int32_t>(at);
      const float stepAt = (at - static_cast<float>(point)) * between.Steps;
      const auto step = static_cast<std::int32_t>(stepAt);
      const float* const weights = between.Weights + static_cast<std::size_t>(step) * 8;
      const Float8 one = Load<Float8>(weights);
      const Float8 two = Load<Float8>(weights + 8);
      const Float8 mixed = one + Splat8(stepAt - static_cast<float>(step)) * (two - one);
      tent = between.Alternates && period % 2 != 0 ? -tent : tent;
      total += Splat8(tent) * mixed * Load<Float8>(line + point);
    }
  }
  float sum = 0;
  for (int k = 0; k < 8; ++k)
  {
    sum += total[k];
  }
  return sum;
}

//------------------------------------------------------------------------------
template <std::size_t Groups>
inline void ProjectGroups(
  const float* values, const HartleyTap* taps, std::size_t tapCount, float* sum)
{
  Float8 even[Groups] = {}, odd[Groups] = {};
  for (std::size_t i = 0; i < tapCount; ++i)
  {
    const float* const from = values + taps[i].Place;
    const Float8 one = Splat8(taps[i].Even), two = Splat8(taps[i].Odd);
    for (std::size_t k = 0; k < Groups; ++k)
    {
      const Float8 value = Load<Float8>(from + 8 * k);
      even[k] += one * value;
      odd[k] += two * value;
    }
  }
  for (std::size_t k = 0; k < Groups; ++k)
  {
    Store(sum + 16 * k, __builtin_shufflevector(even[k], odd[k], 0, 8, 1, 9, 2, 10, 3, 11));
    Store(sum + 16 * k + 8, __builtin_shufflevector(even[k], odd[k], 4, 12, 5, 13, 6, 14, 7, 15));
  }
}

inline void Project(
  const float* values, const HartleyTap* taps, std::size_t tapCount, std::size_t groups, float* sum)
{
  switch (groups)
  {
    case 1:
      return ProjectGroups<1>(values, taps, tapCount, sum);
    case 2:
      return ProjectGroups<2>(values, taps, tapCount, sum);
    case 3:
      return ProjectGroups<3>(values, taps, tapCount, sum);
    default:
      return ProjectGroups<4>(values, taps, tapCount, sum);
  }
}

//------------------------------------------------------------------------------
constexpr HartleyKernelLoops MakeHartleyKernel()
{
  return { Combine, SumBands, Project, AddBlock, AddSlab };
}
}
}

#endif
