// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPointTree_h
#define gtnPointTree_h

// Space in compact regions with about the same number of points.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gtn
{
/** A kd-tree of a sample of points. Consecutive leaves are neighbors: those below any node are a
 * range. */
class PointTree
{
public:
  using Point = std::array<double, 3>;

  /** levels: the logarithm of the number of leaves. */
  PointTree(std::vector<Point> sample, unsigned levels);

  std::size_t CountLeaves() const { return std::size_t{ 1 } << this->Levels; }

  /** The leaf of a point, which may have coordinates that are not finite. */
  std::size_t Find(const Point& point) const
  {
    std::size_t node = 1;
    for (unsigned level = 0; level < this->Levels; ++level)
    {
      const Plane& plane = this->Planes[node];
      node = 2 * node + (point[plane.Axis] < plane.Place ? 0 : 1);
    }
    return node - this->CountLeaves();
  }

private:
  struct Plane
  {
    double Place = 0;
    unsigned Axis = 0;
  };

  void Divide(std::size_t node, std::span<Point> points);

  const unsigned Levels;
  std::vector<Plane> Planes; // the children of node i are 2 i and 2 i + 1
};

/**
 * Groups of consecutive leaves, each below one node, with limited weights.
 *
 * weights: of the leaves. most: the largest weight of a group, unless it is that of one leaf.
 * least: the number of groups to make, if there are as many leaves with a weight. Returns the first
 * leaf of each group, and behind them the number of leaves. The number of leaves is a power of two.
 */
std::vector<std::size_t> GroupLeaves(
  std::span<const std::uint64_t> weights, std::uint64_t most, std::size_t least);
}

#endif
