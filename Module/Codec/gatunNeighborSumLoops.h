// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNeighborSumLoops_h
#define gatunNeighborSumLoops_h

// Compiled once for each instruction set; see gatunSimd.h. The order of all operations is that of
// Documentation/format.md, 10.10 and 10.11.

#include "gatunNeighborSums.h"
#include "gatunSimd.h"

#include <cstddef>

namespace gatun
{
namespace GATUN_SIMD
{
inline double PredictOne(const QuadraticFit::Neighbors& neighbors, const double* numbers)
{
  const Vertex* ids = neighbors.Ids;
  const double first = numbers[ids[0]];
  const auto all = SplatD(first);
  Double4 sums{};
  for (std::size_t i = 0; i < neighbors.Count; i += 4)
  {
    const Double4 four{ numbers[ids[i]], numbers[ids[i + 1]], numbers[ids[i + 2]],
      numbers[ids[i + 3]] };
    const auto weights = Load<Float4>(neighbors.Quadratic + i);
    sums += __builtin_convertvector(weights, Double4) * (four - all);
  }
  // The first number apart, so that a constant is predicted exactly.
  const double number = first + ((sums[0] + sums[1]) + (sums[2] + sums[3]));
  return __builtin_isfinite(number) ? number : first;
}

inline void PredictFour(
  const QuadraticFit::Neighbors& neighbors, const double* numbers, double* predicted)
{
  const Vertex* ids = neighbors.Ids;
  const auto load = [=](std::size_t i)
  { return Load<Double4>(numbers + 4 * static_cast<std::size_t>(ids[i])); };
  const auto first = load(0);
  Double4 a{}, b{}, c{}, d{};
  for (std::size_t i = 0; i < neighbors.Count; i += 4)
  {
    const float* weights = neighbors.Quadratic + i;
    a += SplatD(weights[0]) * (load(i) - first);
    b += SplatD(weights[1]) * (load(i + 1) - first);
    c += SplatD(weights[2]) * (load(i + 2) - first);
    d += SplatD(weights[3]) * (load(i + 3) - first);
  }
  const auto number = first + ((a + b) + (c + d));
  const auto zero = SplatD(0);
  Store(predicted, number - number == zero ? number : first); // NaN unless it is finite
}

template <bool IsCorrected>
GATUN_INLINE NeighborErrors SumAnyErrors(
  const QuadraticFit::Neighbors& neighbors, const double* numbers, const double* errors)
{
  using Double2 = double __attribute__((vector_size(16)));
  constexpr std::size_t stride = IsCorrected ? 8 : 4;
  const Vertex* ids = neighbors.Ids;
  const double first = numbers[ids[0]];
  Double2 fits{}, rest{};
  Double4 sums{};
  float shares = 0; // none is negative
  for (std::size_t i = 0; i < neighbors.Count; ++i)
  {
    const double difference = numbers[ids[i]] - first;
    const double* known = errors + stride * static_cast<std::size_t>(ids[i]);
    fits +=
      Double2{ neighbors.Quadratic[i], neighbors.Linear[i] } * Double2{ difference, difference };
    sums += SplatD(neighbors.Shares[i]) * Load<Double4>(known);
    shares += neighbors.Shares[i];
    if constexpr (IsCorrected)
    {
      rest += Double2{ neighbors.Shares[i], neighbors.Corrections[i] } * Load<Double2>(known + 4);
    }
  }
  return { fits[0], fits[1], { sums[0], sums[1], sums[2], sums[3] }, shares > 0, rest[0], rest[1] };
}

inline NeighborErrors SumErrors(
  const QuadraticFit::Neighbors& neighbors, const double* numbers, const double* errors)
{
  return SumAnyErrors<false>(neighbors, numbers, errors);
}

inline NeighborErrors SumCorrected(
  const QuadraticFit::Neighbors& neighbors, const double* numbers, const double* errors)
{
  return SumAnyErrors<true>(neighbors, numbers, errors);
}

inline NeighborSums GetNeighborSums()
{
  return { PredictOne, PredictFour, SumErrors, SumCorrected };
}
}
}

#endif
