// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeOrder_h
#define gatunMergeOrder_h

#include "gatunMergeInput.h"
#include "gatunMergeTree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The order of points along a curve through their box; those of one place by number. */
std::vector<std::uint32_t> OrderByPlace(std::span<const std::array<double, 3>> points);

/** The order of cells by their lowest point; those of one point by number. places: of each point in
 * the order. */
template <std::size_t Corners>
std::vector<std::uint32_t> OrderByLowestPoint(
  std::span<const std::array<std::uint32_t, Corners>> cells, std::span<const std::uint32_t> places);

/** Where each element is in an order. */
std::vector<std::uint32_t> InvertOrder(std::span<const std::uint32_t> order);

/** A mesh whose points and cells are sorted spatially, so that neighbors are near each other in
 * memory. This makes algorithms that visit neighbors faster. Points of a surface at the same place
 * follow each other. */
template <std::size_t Corners>
class LocalMergeInput
{
public:
  using Input = BasicMergeInput<Corners>;

  explicit LocalMergeInput(const Input& input);

  /** Valid as long as this object exists. */
  const Input& Get() const { return this->Local; }

  /** Makes a tree for the given mesh from merges of the sorted points. isBound, rounds: see
   * MergeTree. */
  MergeTree MakeTree(
    std::vector<Merge> merges, std::vector<bool> isBound, std::vector<std::uint32_t> rounds) const;

private:
  void OrderCells(const Input& input);

  std::vector<std::uint32_t> Ids;
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<std::uint32_t, Corners>> Cells;
  std::vector<std::vector<double>> Values;
  std::vector<std::uint8_t> IsKept;
  Input Local;
};

extern template std::vector<std::uint32_t> OrderByLowestPoint<4>(
  std::span<const std::array<std::uint32_t, 4>> cells, std::span<const std::uint32_t> places);
extern template class LocalMergeInput<3>;
extern template class LocalMergeInput<4>;
}

#endif
