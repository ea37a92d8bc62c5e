// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeOrder.h"

#include "gatunMorton.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
using Coded = std::pair<std::uint64_t, std::uint32_t>; // a place on the curve, and the point

/** Calls sort with the codes of all points, and returns the points in the order that it makes. */
template <typename Sort>
std::vector<std::uint32_t> OrderByCode(std::span<const std::array<double, 3>> points, Sort&& sort)
{
  Bounds box;
  for (const auto& point : points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::isfinite(point[axis]))
      {
        box[axis].Include(point[axis]);
      }
    }
  }
  std::vector<Coded> codes;
  codes.reserve(points.size());
  for (const auto& point : points)
  {
    codes.emplace_back(GetMortonCode(box, point), static_cast<std::uint32_t>(codes.size()));
  }
  sort(codes);
  std::vector<std::uint32_t> order;
  order.reserve(codes.size());
  for (const auto& code : codes)
  {
    order.push_back(code.second);
  }
  return order;
}

/** The same with points of a surface at one place one after the other. */
std::vector<std::uint32_t> OrderWithSeams(std::span<const std::array<double, 3>> points)
{
  // Negative zero becomes zero; bits have an order, even those of NaN.
  const auto getBits = [&](std::uint32_t id)
  {
    const auto& p = points[id];
    return std::bit_cast<std::array<std::uint64_t, 3>>(
      std::array<double, 3>{ p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 });
  };
  const auto isBefore = [&](const Coded& a, const Coded& b)
  {
    if (a.first != b.first)
    {
      return a.first < b.first;
    }
    const auto bitsA = getBits(a.second);
    const auto bitsB = getBits(b.second);
    return bitsA != bitsB ? bitsA < bitsB : a.second < b.second;
  };
  return OrderByCode(
    points, [&](std::vector<Coded>& codes) { std::sort(codes.begin(), codes.end(), isBefore); });
}
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> OrderByPlace(std::span<const std::array<double, 3>> points)
{
  return OrderByCode(
    points, [](std::vector<Coded>& codes) { std::sort(codes.begin(), codes.end()); });
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
std::vector<std::uint32_t> OrderByLowestPoint(
  std::span<const std::array<std::uint32_t, Corners>> cells, std::span<const std::uint32_t> places)
{
  std::vector<std::size_t> starts(places.size() + 1, 0);
  const auto getLowest = [&](const auto& cell)
  {
    std::uint32_t lowest = places[cell[0]];
    for (const auto corner : cell)
    {
      lowest = std::min(lowest, places[corner]);
    }
    return lowest;
  };
  for (const auto& cell : cells)
  {
    ++starts[getLowest(cell) + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<std::uint32_t> order(cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i)
  {
    order[starts[getLowest(cells[i])]++] = i;
  }
  return order;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> InvertOrder(std::span<const std::uint32_t> order)
{
  std::vector<std::uint32_t> places(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    places[order[i]] = i;
  }
  return places;
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
LocalMergeInput<Corners>::LocalMergeInput(const Input& input)
{
  this->Ids = Corners == 3 ? OrderWithSeams(input.Points) : OrderByPlace(input.Points);
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
void LocalMergeInput<Corners>::OrderCells(const Input& input)
{
  const auto places = InvertOrder(this->Ids);
  this->Cells.reserve(input.Cells.size());
  for (const auto cell : OrderByLowestPoint<Corners>(input.Cells, places))
  {
    auto& sorted = this->Cells.emplace_back();
    std::transform(input.Cells[cell].begin(), input.Cells[cell].end(), sorted.begin(),
      [&](std::uint32_t id) { return places[id]; });
  }
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
MergeTree LocalMergeInput<Corners>::MakeTree(
  std::vector<Merge> merges, std::vector<bool> isBound, std::vector<std::uint32_t> rounds) const
{
  for (Merge& merge : merges)
  {
    merge.Point = this->Ids[merge.Point];
    merge.Into = this->Ids[merge.Into];
  }
  return { static_cast<std::uint32_t>(this->Ids.size()), std::move(merges), std::move(isBound),
    std::move(rounds) };
}

template std::vector<std::uint32_t> OrderByLowestPoint<4>(
  std::span<const std::array<std::uint32_t, 4>> cells, std::span<const std::uint32_t> places);
template class LocalMergeInput<3>;
template class LocalMergeInput<4>;
}
