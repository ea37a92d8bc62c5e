// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPointOrder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <numeric>

namespace gatun
{
namespace
{
// The number of points of a cell of the curve, about.
constexpr std::size_t CellPoints = 4;
constexpr unsigned MostBits = 5; // of cells along an axis

/** The bits of numbers below 2^MostBits, three apart. */
constexpr auto Spread = []
{
  std::array<std::uint16_t, 1u << MostBits> spread{};
  for (unsigned number = 0; number < spread.size(); ++number)
  {
    for (unsigned bit = 0; bit < MostBits; ++bit)
    {
      spread[number] |= static_cast<std::uint16_t>((number >> bit & 1) << 3 * bit);
    }
  }
  return spread;
}();
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SortAlongCurve(
  const MeshAccess& mesh, std::span<const std::uint32_t> points)
{
  Bounds box;
  for (const auto point : points)
  {
    mesh.Include(box, point);
  }
  const auto bits =
    std::min(MostBits, static_cast<unsigned>(std::bit_width(points.size() / CellPoints)) / 3);
  const auto cells = static_cast<double>(1u << bits);
  std::array<double, 3> scales{};
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    scales[axis] = cells / (box[axis].Max - box[axis].Min);
  }
  std::vector<std::uint16_t> codes(points.size());
  std::vector<std::uint32_t> starts((std::size_t{ 1 } << 3 * bits) + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    unsigned code = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const double place = (mesh.GetCoordinate(points[i], axis) - box[axis].Min) * scales[axis];
      // NaN counts as 0.
      code |= unsigned{ Spread[place > 0 ? static_cast<unsigned>(std::min(place, cells - 1)) : 0] }
        << axis;
    }
    codes[i] = static_cast<std::uint16_t>(code);
    ++starts[code + std::size_t{ 1 }];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<std::uint32_t> sorted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    sorted[starts[codes[i]]++] = points[i];
  }
  return sorted;
}
}
