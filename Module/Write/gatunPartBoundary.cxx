// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartBoundary.h"

#include "gatunCellShapes.h"
#include "gatunCellSides.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <span>

namespace gatun
{
namespace
{
/** A face, edge or end of a cell. Those of two cells are equal if they have the same points, except
 * where faces overlap. */
struct Side
{
  std::array<std::uint32_t, 3> Least{}; // the least points, ascending
  std::uint16_t Size = 0;               // of all different points
  std::uint16_t Number = 0;             // within the cell
  std::uint32_t Cell = 0;

  bool IsSame(const Side& other) const
  {
    return this->Least == other.Least && this->Size == other.Size;
  }
  bool operator<(const Side& other) const
  {
    return this->Least != other.Least ? this->Least < other.Least : this->Size < other.Size;
  }
};

/** Finds the sides of single cells, first in each chunk and then in what is left of all. */
class BoundaryFinder
{
public:
  BoundaryFinder(const MeshAccess& mesh, const Partition& layout)
    : Mesh(mesh)
    , Layout(layout)
    , Marks(static_cast<std::size_t>(mesh.GetMesh().Points))
  {
  }

  std::vector<std::uint8_t> Find()
  {
    std::vector<std::vector<Side>> open(this->Layout.GetChunkCount());
    ParallelFor(open.size(), [&](std::size_t c) { open[c] = this->FindOpenSides(c); });
    std::vector<Side> all;
    for (auto& sides : open)
    {
      all.insert(all.end(), sides.begin(), sides.end());
      sides = {};
    }
    this->RemovePairs(all);
    CellSides finder(this->Mesh);
    for (const auto& side : all)
    {
      this->MarkSide(finder, side);
    }
    if (!this->Mesh.IsTetrahedral())
    {
      this->MarkSeams();
    }
    for (const auto point : this->Layout.UnusedPoints)
    {
      this->Mark(point);
    }
    std::vector<std::uint8_t> marks(this->Marks.size());
    std::transform(this->Marks.begin(), this->Marks.end(), marks.begin(),
      [](const auto& mark) { return mark.load(std::memory_order_relaxed); });
    return marks;
  }

private:
  void Mark(std::uint64_t point)
  {
    this->Marks[static_cast<std::size_t>(point)].store(1, std::memory_order_relaxed);
  }

  /** The sides of the cells of a chunk that no other one of its cells has. Called by several
   * threads. */
  std::vector<Side> FindOpenSides(std::size_t chunk)
  {
    CellSides finder(this->Mesh);
    std::vector<Side> sides;
    std::vector<std::uint32_t> sorted;
    for (auto i = this->Layout.ChunkStart[chunk]; i < this->Layout.ChunkStart[chunk + 1]; ++i)
    {
      const auto cell = this->Layout.Cells[i];
      const auto dimension = GetCellKind(this->Mesh.GetType(cell)).Dimension;
      const auto add = [&](std::uint16_t number, std::span<const std::uint32_t> corners)
      {
        sorted.assign(corners.begin(), corners.end());
        std::sort(sorted.begin(), sorted.end());
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        if (sorted.size() >= static_cast<std::size_t>(dimension))
        {
          auto& side = sides.emplace_back();
          std::copy_n(sorted.begin(), dimension, side.Least.begin());
          side.Size = static_cast<std::uint16_t>(sorted.size());
          side.Number = number;
          side.Cell = cell;
        }
      };
      if (!finder.ForEachSide(cell, add))
      {
        this->Mesh.ForEachPoint(cell, [&](std::uint64_t point) { this->Mark(point); });
      }
    }
    this->RemovePairs(sides);
    return { sides.begin(), sides.end() }; // without the room for the others
  }

  /** Sorts sides and removes those that come in twos. Of more than two, three remain. */
  static void RemovePairs(std::vector<Side>& sides)
  {
    std::sort(sides.begin(), sides.end());
    std::size_t kept = 0;
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
    {
      while (end < sides.size() && sides[end].IsSame(sides[begin]))
      {
        ++end;
      }
      const auto count = std::min<std::size_t>(end - begin, 3);
      for (std::size_t i = 0; i < count && count != 2; ++i)
      {
        sides[kept++] = sides[begin + i];
      }
    }
    sides.resize(kept);
  }

  void MarkSide(CellSides& finder, const Side& side)
  {
    finder.ForEachSide(side.Cell,
      [&](std::uint16_t number, std::span<const std::uint32_t> corners)
      {
        if (number == side.Number)
        {
          for (const auto corner : corners)
          {
            this->Mark(corner);
          }
          finder.ForEachNode(side.Cell, corners, [&](std::uint32_t node) { this->Mark(node); });
        }
      });
  }

  /** Marks the points of cells of different dimensions. */
  void MarkSeams()
  {
    const auto cells = this->Mesh.GetMesh().Cells;
    unsigned all = 0;
    std::vector<std::uint8_t> found(this->Marks.size(), 0);
    for (std::uint64_t cell = 0; cell < cells; ++cell)
    {
      const int dimension = GetCellKind(this->Mesh.GetType(cell)).Dimension;
      const auto bit = static_cast<std::uint8_t>(dimension < 0 ? 0x80 : 1 << dimension);
      all |= bit;
      this->Mesh.ForEachPoint(
        cell, [&](std::uint64_t point) { found[static_cast<std::size_t>(point)] |= bit; });
    }
    for (std::size_t point = 0; point < found.size() && (all & (all - 1)) != 0; ++point)
    {
      if ((found[point] & (found[point] - 1)) != 0)
      {
        this->Mark(point);
      }
    }
  }

  const MeshAccess& Mesh;
  const Partition& Layout;
  std::vector<std::atomic<std::uint8_t>> Marks;
};
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> FindPartBoundary(const MeshAccess& mesh, const Partition& layout)
{
  return BoundaryFinder(mesh, layout).Find();
}
}
