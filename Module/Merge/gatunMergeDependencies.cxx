// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMergeDependencies.h"

#include "gatunError.h"
#include "gatunMergeRings.h"

#include <algorithm>
#include <unordered_map>

namespace gatun
{
namespace
{
/** Does merges one after the other and notes which cells each of them changes. */
template <std::size_t Corners>
class MergeReplay
{
public:
  using Cell = std::array<std::uint32_t, Corners>;

  MergeReplay(std::uint32_t points, std::span<const Cell> cells)
    : Mesh(points, cells)
    , Last(cells.size(), None)
    , IsBared(cells.size(), false)
  {
  }

  /** Does a merge. Returns what it depends on, until the next call. */
  std::span<const std::uint32_t> Do(std::uint32_t number, const Merge& merge)
  {
    this->FindAround(merge.Point);
    this->FindEarlier();
    for (std::size_t i = 0; i < this->Ring.size(); ++i)
    {
      if (this->IsBared[this->Ring[i]])
      {
        this->Bared.erase(this->Ring[i]); // the merge depends on these already
        this->IsBared[this->Ring[i]] = false;
      }
      if (Rings::HasCorner(this->Around[i], merge.Into))
      {
        this->PassBoundaryOn(number, i, merge);
      }
      else
      {
        this->Last[this->Ring[i]] = number;
      }
    }
    this->Mesh.MergeLazily(merge.Point, merge.Into);
    return this->Earlier;
  }

private:
  using Rings = MergeRings<Corners>;
  static constexpr std::uint32_t None = 0xffffffffu;

  /** The cells of a point that have not been removed. */
  void FindAround(std::uint32_t point)
  {
    this->Ring.clear();
    this->Around.clear();
    for (const auto cell : this->Mesh.GetRing(point))
    {
      const Cell& corners = this->Mesh.GetCell(cell);
      if (corners[0] != None)
      {
        this->Ring.push_back(cell);
        this->Around.push_back(corners);
      }
    }
  }

  void FindEarlier()
  {
    this->Earlier.clear();
    for (const auto cell : this->Ring)
    {
      if (this->Last[cell] != None)
      {
        this->Earlier.push_back(this->Last[cell]);
      }
      if (this->IsBared[cell])
      {
        const auto& bared = this->Bared[cell];
        this->Earlier.insert(this->Earlier.end(), bared.begin(), bared.end());
      }
    }
    std::sort(this->Earlier.begin(), this->Earlier.end());
    this->Earlier.erase(
      std::unique(this->Earlier.begin(), this->Earlier.end()), this->Earlier.end());
  }

  /** A cell that vanishes has two sides that become one: that of the point and that of the one that
   * it is merged into. If the first is on the boundary, the cell behind the second gets there
   * without being changed. */
  void PassBoundaryOn(std::uint32_t number, std::size_t vanishing, const Merge& merge)
  {
    const Cell corners = this->Around[vanishing];
    const auto hasRest = [&](const Cell& cell)
    {
      bool has = true;
      for (const auto corner : corners)
      {
        has &= corner == merge.Point || corner == merge.Into || Rings::HasCorner(cell, corner);
      }
      return has;
    };
    for (std::size_t i = 0; i < this->Around.size(); ++i)
    {
      if (i != vanishing && hasRest(this->Around[i]))
      {
        return;
      }
    }
    for (const auto cell : this->Mesh.GetRing(merge.Into))
    {
      const Cell& other = this->Mesh.GetCell(cell);
      if (other[0] != None && hasRest(other) && !Rings::HasCorner(other, merge.Point))
      {
        this->Bared[cell].push_back(number);
        this->IsBared[cell] = true;
      }
    }
  }

  Rings Mesh;
  std::vector<std::uint32_t> Ring; // the cells around the point of the merge
  std::vector<Cell> Around;        // their corners
  std::vector<std::uint32_t> Last; // the merge that changed each cell last
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> Bared; // since then, by cells
  std::vector<bool> IsBared; // whether each cell has some, which is faster to ask for
  std::vector<std::uint32_t> Earlier;
};
}

//------------------------------------------------------------------------------
/** Adds merges of which none is done without the others, if all are wanted: each depends on what
 * any of them depends on, and on those before it. */
void MergeDependencies::AddTogether(
  std::span<const std::uint32_t> merges, std::vector<std::uint32_t>& earlier)
{
  std::sort(earlier.begin(), earlier.end());
  earlier.erase(std::unique(earlier.begin(), earlier.end()), earlier.end());
  earlier.erase(std::lower_bound(earlier.begin(), earlier.end(), merges.front()), earlier.end());
  for (const std::uint32_t merge : merges)
  {
    this->Add(earlier);
    earlier.push_back(merge);
  }
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
void MergeDependencies::Replay(const MergeTree& tree,
  std::span<const std::array<std::uint32_t, Corners>> cells,
  const std::function<bool(double)>& progress)
{
  for (const auto& cell : cells)
  {
    if (*std::max_element(cell.begin(), cell.end()) >= tree.GetNumberOfPoints())
    {
      throw Error(ErrorCode::InvalidInput, "a cell refers to a point outside the hierarchy");
    }
  }
  const auto& merges = tree.GetMerges();
  MergeReplay<Corners> replay(tree.GetNumberOfPoints(), cells);
  this->First.reserve(merges.size() + 1);
  const auto isBound = [&](std::size_t merge)
  { return !tree.GetBonds().empty() && tree.GetBonds()[merge]; };
  std::vector<std::uint32_t> together; // merges that belong together
  std::vector<std::uint32_t> earlier;  // what they depend on
  for (std::size_t i = 0; i < merges.size(); ++i)
  {
    if (progress && i % MergeDependencies::MergesBetweenProgress == 0 &&
      !progress(static_cast<double>(i) / static_cast<double>(merges.size())))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
    const auto number = static_cast<std::uint32_t>(i);
    const auto needed = replay.Do(number, merges[i]);
    if (together.empty() && !isBound(i))
    {
      this->Add(needed);
      continue;
    }
    together.push_back(number);
    earlier.insert(earlier.end(), needed.begin(), needed.end());
    if (!isBound(i))
    {
      this->AddTogether(together, earlier);
      together.clear();
      earlier.clear();
    }
  }
  this->Earlier.shrink_to_fit();
}

//------------------------------------------------------------------------------
MergeDependencies::MergeDependencies(const MergeTree& tree,
  std::span<const std::array<std::uint32_t, 4>> cells, const std::function<bool(double)>& progress)
{
  this->Replay(tree, cells, progress);
}

//------------------------------------------------------------------------------
MergeDependencies::MergeDependencies(const MergeTree& tree,
  std::span<const std::array<std::uint32_t, 3>> cells, const std::function<bool(double)>& progress)
{
  this->Replay(tree, cells, progress);
}
}
