// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPointTree.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace gtn
{
//------------------------------------------------------------------------------
PointTree::PointTree(std::vector<Point> sample, unsigned levels)
  : Levels(levels)
  , Planes(std::size_t{ 1 } << levels)
{
  this->Divide(1, sample);
}

//------------------------------------------------------------------------------
// Divides the points below a node at the median of the longest axis.
void PointTree::Divide(std::size_t node, std::span<Point> points)
{
  if (node >= this->Planes.size())
  {
    return;
  }
  Plane& plane = this->Planes[node];
  double longest = -1;
  for (unsigned axis = 0; axis < 3 && !points.empty(); ++axis)
  {
    const auto [least, most] = std::minmax_element(points.begin(), points.end(),
      [axis](const Point& l, const Point& r) { return l[axis] < r[axis]; });
    if ((*most)[axis] - (*least)[axis] > longest)
    {
      longest = (*most)[axis] - (*least)[axis];
      plane.Axis = axis;
    }
  }
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  if (!points.empty())
  {
    std::nth_element(points.begin(), middle, points.end(),
      [axis = plane.Axis](const Point& l, const Point& r) { return l[axis] < r[axis]; });
    plane.Place = (*middle)[plane.Axis];
  }
  this->Divide(2 * node, { points.begin(), middle });
  this->Divide(2 * node + 1, { middle, points.end() });
}

//------------------------------------------------------------------------------
std::vector<std::size_t> GroupLeaves(
  std::span<const std::uint64_t> weights, std::uint64_t most, std::size_t least)
{
  const std::size_t leaves = weights.size();
  std::vector<std::uint64_t> sums(2 * leaves);
  std::copy(weights.begin(), weights.end(), sums.begin() + static_cast<std::ptrdiff_t>(leaves));
  for (std::size_t node = leaves - 1; node > 0; --node)
  {
    sums[node] = sums[2 * node] + sums[2 * node + 1];
  }

  // The heaviest group is divided until all are light enough and there are enough of them.
  std::priority_queue<std::pair<std::uint64_t, std::size_t>> open;
  std::vector<std::size_t> done;
  std::size_t count = 1; // groups with a weight
  open.emplace(sums[1], 1);
  while (!open.empty())
  {
    const auto [weight, node] = open.top();
    open.pop();
    if (node >= leaves || weight == 0 || (weight <= most && count >= least))
    {
      done.push_back(node);
      continue;
    }
    count += sums[2 * node] > 0 && sums[2 * node + 1] > 0;
    open.emplace(sums[2 * node], 2 * node);
    open.emplace(sums[2 * node + 1], 2 * node + 1);
  }
  std::vector<std::size_t> firsts;
  for (std::size_t node : done)
  {
    if (sums[node] > 0)
    {
      while (node < leaves)
      {
        node *= 2;
      }
      firsts.push_back(node - leaves);
    }
  }
  std::sort(firsts.begin(), firsts.end());
  if (firsts.empty())
  {
    firsts.push_back(0);
  }
  firsts.front() = 0;
  firsts.push_back(leaves);
  return firsts;
}
}
