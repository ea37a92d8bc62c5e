// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeOrder_h
#define gatunMergeOrder_h

#include "gatunMergeInput.h"
#include "gatunMergeTree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
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

  /** Makes a tree for the given mesh from merges of the sorted points. isBound: see MergeTree. */
  MergeTree MakeTree(std::vector<Merge> merges, std::vector<bool> isBound = {}) const;

private:
  void OrderPoints(const Input& input);
  void OrderCells(const Input& input);

  std::vector<std::uint32_t> Ids;
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<std::uint32_t, Corners>> Cells;
  std::vector<std::vector<double>> Values;
  std::vector<std::uint8_t> IsKept;
  Input Local;
};

extern template class LocalMergeInput<3>;
extern template class LocalMergeInput<4>;
}

#endif
