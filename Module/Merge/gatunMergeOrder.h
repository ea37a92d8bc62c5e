// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeOrder_h
#define gatunMergeOrder_h

#include "gatunMergeInput.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A mesh with its points and tetrahedra in an order in which those that are near each other are
 * near in memory, too. Whatever walks from neighbour to neighbour is faster so, if they were not
 * before. */
class LocalMergeInput
{
public:
  explicit LocalMergeInput(const MergeInput& input);

  /** Valid for as long as this is. */
  const MergeInput& Get() const { return this->Local; }

  /** Which point of the given mesh each one is. */
  const std::vector<std::uint32_t>& GetIds() const { return this->Ids; }

private:
  void OrderPoints(const MergeInput& input);
  void OrderTets(const MergeInput& input);

  std::vector<std::uint32_t> Ids;
  std::vector<std::array<double, 3>> Points;
  std::vector<MergeTree::Tet> Tets;
  std::vector<std::vector<double>> Values;
  MergeInput Local;
};
}

#endif
