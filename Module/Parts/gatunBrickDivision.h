// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunBrickDivision_h
#define gatunBrickDivision_h

#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Divides bricks into groups of neighbors that fit into memory, each time by other walls. Points at
 * the walls of groups cannot be merged, so that walls part few neighbors, and rarely those that the
 * walls before have parted.
 */
class BrickDivision
{
public:
  /** boxes: of all bricks. Bricks whose boxes meet are neighbors. */
  explicit BrickDivision(std::vector<Bounds> boxes);

  using Group = std::vector<std::uint32_t>; ///< bricks, ascending

  /** Divides by bisection until a group has at most so many tetrahedra, or a single brick. tets: of
   * each brick. */
  std::vector<Group> Divide(std::span<const std::uint64_t> tets, std::uint64_t most);

private:
  struct Neighbor
  {
    std::uint32_t Brick;
    bool WasParted = false;
  };

  void Sort(Group& bricks) const;
  std::size_t FindCut(const Group& bricks, std::span<const std::uint64_t> tets) const;

  std::vector<Bounds> Boxes;
  std::vector<std::vector<Neighbor>> Neighbors;
};
}

#endif
