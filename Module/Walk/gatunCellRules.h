// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellRules_h
#define gatunCellRules_h

#include "gatunInline.h"
#include "gatunMeasure.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Weights of the vertices of a CellRecord, in units of 1/256. */
using CellRule = std::array<std::int16_t, CellRecord::Size>;

/** The rules that every chunk of cells has: parallelepipeds, parallelograms, rows, in the order of
 * preference. The last ones can be applied to all records but those of seeds. */
const std::vector<CellRule>& GetCellRules();

/** For each mask of a record, the first rule that has weights for vertices of the record only. */
const std::array<std::uint8_t, 1u << CellRecord::Size>& GetFirstRules();

/** Bit i is set if the rule has a weight for vertex i. */
inline unsigned GetMask(const CellRule& rule)
{
  unsigned mask = 0;
  for (unsigned k = 0; k < CellRecord::Size; ++k)
  {
    mask |= unsigned{ rule[k] != 0 } << k;
  }
  return mask;
}

/** Finds the place that the first rule for a record predicts. getPlace(vertex) returns a
 * LatticePoint. */
template <typename GetPlace>
LatticePoint PredictPlace(const CellRecord& record, GetPlace&& getPlace)
{
  const auto& weights = GetCellRules()[GetFirstRules()[record.GetMask()]];
  LatticePoint sum;
  for (unsigned k = 0; k < CellRecord::Size; ++k)
  {
    if (weights[k] != 0)
    {
      const auto weight = static_cast<float>(weights[k]);
      const auto& place = getPlace(record.Known[k]);
      sum.X += weight * place.X;
      sum.Y += weight * place.Y;
      sum.Z += weight * place.Z;
    }
  }
  constexpr float unit = 1.0F / 256.0F;
  return { sum.X * unit, sum.Y * unit, sum.Z * unit, 0 };
}

/** GetSpread of a single vertex, which has no differences to measure. */
constexpr unsigned NoSpread = ~0u;

/** Calls use(vertex) for the vertices of a record whose values tell how large differences are.
 * Returns their number. */
template <typename Use>
GATUN_INLINE unsigned ForEachInRange(const CellRecord& record, Use&& use)
{
  unsigned count = 0;
  for (unsigned k = 0; k < CellRecord::Size; ++k)
  {
    // Vertices beyond the cell count only where there is just one in it.
    if (record.Known[k] != NoVertex && (k < CellRecord::B1 || count < 2))
    {
      use(record.Known[k]);
      ++count;
    }
  }
  return count;
}

/** The number of bits of the range of the keys of a record's vertices in the cell. */
template <typename GetKey>
unsigned GetSpread(const CellRecord& record, GetKey&& getKey)
{
  std::uint64_t low = ~std::uint64_t{ 0 };
  std::uint64_t high = 0;
  const auto count = ForEachInRange(record,
    [&](Vertex v)
    {
      const std::uint64_t key = getKey(v);
      low = std::min(low, key);
      high = std::max(high, key);
    });
  return count < 2 ? NoSpread : static_cast<unsigned>(std::bit_width(high - low));
}
}

#endif
