// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunIntervalTree_h
#define gatunIntervalTree_h

#include "gatunExport.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Finds the ranges of values that an isosurface passes through, in time O(log n + k) for k of n
 * ranges (Edelsbrunner's interval tree; for isosurfaces: Cignoni, Marino, Montani, Puppo, Scopigno
 * 1997).
 *
 * An isosurface passes through a range if Min < value <= Max, because a corner whose value is the
 * isovalue counts as one above it.
 */
class GATUN_EXPORT IntervalTree
{
public:
  /** Ranges without values, where Min > Max, are never found. */
  explicit IntervalTree(std::span<const Range> ranges);

  /** Calls use(range) for each range that the isosurface passes through, in no order. */
  template <typename Use>
  void Find(double value, Use&& use) const
  {
    for (std::int32_t n = this->Root; n >= 0;)
    {
      const Node& node = this->Nodes[static_cast<std::size_t>(n)];
      if (value <= node.Center)
      {
        for (std::size_t i = node.Begin; i < node.End && this->ByMin[i].Bound < value; ++i)
        {
          use(this->ByMin[i].Index);
        }
        n = node.Below;
      }
      else
      {
        for (std::size_t i = node.Begin; i < node.End && this->ByMax[i].Bound >= value; ++i)
        {
          use(this->ByMax[i].Index);
        }
        n = node.Above;
      }
    }
  }

  /** Returns the ranges that isosurfaces of any of the values pass through, ascending. */
  std::vector<std::uint32_t> FindAny(std::span<const double> values) const;

private:
  /** The ranges with Min < Center <= Max; all others are below or above it. */
  struct Node
  {
    double Center = 0;
    std::size_t Begin = 0; // in ByMin and ByMax
    std::size_t End = 0;
    std::int32_t Below = -1;
    std::int32_t Above = -1;
  };

  struct Entry
  {
    double Bound;
    std::uint32_t Index;
  };

  std::int32_t Build(std::span<const Range> ranges, std::vector<std::uint32_t> members);

  std::size_t Count;
  std::int32_t Root = -1;
  std::vector<Node> Nodes;
  std::vector<Entry> ByMin; // of each node: ascending
  std::vector<Entry> ByMax; // of each node: descending
};
}

#endif
