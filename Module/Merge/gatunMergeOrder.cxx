// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeOrder.h"

#include "gatunMorton.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
template <std::size_t Corners>
LocalMergeInput<Corners>::LocalMergeInput(const Input& input)
{
  this->OrderPoints(input);
  this->OrderCells(input);
  this->Points.reserve(this->Ids.size());
  for (const auto id : this->Ids)
  {
    this->Points.push_back(input.Points[id]);
  }
  this->Local = { this->Points, this->Cells, {} };
  this->Values.reserve(input.Fields.size());
  for (const auto& field : input.Fields)
  {
    auto& values = this->Values.emplace_back();
    values.reserve(this->Ids.size());
    for (const auto id : this->Ids)
    {
      values.push_back(field.Values[id]);
    }
    this->Local.Fields.push_back({ values, field.Weight });
  }
  if (!input.IsKept.empty())
  {
    this->IsKept.reserve(this->Ids.size());
    for (const auto id : this->Ids)
    {
      this->IsKept.push_back(input.IsKept[id]);
    }
    this->Local.IsKept = this->IsKept;
  }
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
void LocalMergeInput<Corners>::OrderPoints(const Input& input)
{
  Bounds box;
  for (const auto& point : input.Points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::isfinite(point[axis]))
      {
        box[axis].Include(point[axis]);
      }
    }
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> codes;
  codes.reserve(input.Points.size());
  for (const auto& point : input.Points)
  {
    codes.emplace_back(GetMortonCode(box, point), static_cast<std::uint32_t>(codes.size()));
  }
  if constexpr (Corners == 3)
  {
    // Negative zero becomes zero; bits have an order, even those of NaN.
    const auto getBits = [&](std::uint32_t id)
    {
      const auto& p = input.Points[id];
      return std::bit_cast<std::array<std::uint64_t, 3>>(
        std::array<double, 3>{ p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 });
    };
    std::sort(codes.begin(), codes.end(),
      [&](const auto& a, const auto& b)
      {
        if (a.first != b.first)
        {
          return a.first < b.first;
        }
        const auto bitsA = getBits(a.second);
        const auto bitsB = getBits(b.second);
        return bitsA != bitsB ? bitsA < bitsB : a.second < b.second;
      });
  }
  else
  {
    std::sort(codes.begin(), codes.end());
  }
  this->Ids.reserve(codes.size());
  for (const auto& code : codes)
  {
    this->Ids.push_back(code.second);
  }
}

//------------------------------------------------------------------------------
/** Sorts by the lowest point of each cell; the sort is stable. */
template <std::size_t Corners>
void LocalMergeInput<Corners>::OrderCells(const Input& input)
{
  std::vector<std::uint32_t> places(this->Ids.size());
  for (std::uint32_t i = 0; i < this->Ids.size(); ++i)
  {
    places[this->Ids[i]] = i;
  }
  std::vector<std::size_t> starts(this->Ids.size() + 1, 0);
  const auto getLowest = [&](const auto& cell)
  {
    std::uint32_t lowest = places[cell[0]];
    for (const auto corner : cell)
    {
      lowest = std::min(lowest, places[corner]);
    }
    return lowest;
  };
  for (const auto& cell : input.Cells)
  {
    ++starts[getLowest(cell) + 1];
  }
  for (std::size_t i = 1; i < starts.size(); ++i)
  {
    starts[i] += starts[i - 1];
  }
  this->Cells.resize(input.Cells.size());
  for (const auto& cell : input.Cells)
  {
    auto& sorted = this->Cells[starts[getLowest(cell)]++];
    std::transform(
      cell.begin(), cell.end(), sorted.begin(), [&](std::uint32_t id) { return places[id]; });
  }
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
MergeTree LocalMergeInput<Corners>::MakeTree(
  std::vector<Merge> merges, std::vector<bool> isBound) const
{
  for (Merge& merge : merges)
  {
    merge.Point = this->Ids[merge.Point];
    merge.Into = this->Ids[merge.Into];
  }
  return { static_cast<std::uint32_t>(this->Ids.size()), std::move(merges), std::move(isBound) };
}

template class LocalMergeInput<3>;
template class LocalMergeInput<4>;
}
