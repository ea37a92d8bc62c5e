// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartSkin.h"

#include "gatunCellNodes.h"
#include "gatunCellShapes.h"
#include "gatunMarkTruth.h"
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

/** Lists the sides of cells. */
class SideFinder
{
public:
  explicit SideFinder(const MeshAccess& mesh)
    : Mesh(mesh)
  {
  }

  /** Calls use(side number, corners) for each side of a cell. Returns false if they are not known.
   */
  template <typename Use>
  bool ForEachSide(std::uint64_t cell, Use&& use)
  {
    const auto type = this->Mesh.GetType(cell);
    const auto kind = GetCellKind(type);
    const auto size = static_cast<std::size_t>(this->Mesh.GetEnd(cell) - this->Mesh.GetBegin(cell));
    if (kind.Shape)
    {
      const bool isKnown =
        size == kind.Shape->Corners || (size > kind.Shape->Corners && CanFindCellNodes(type, size));
      return isKnown && this->UseFaces(cell, kind.Shape->Faces, use);
    }
    if (type == PolyhedronType)
    {
      return this->UseFaces(cell, this->Mesh.GetFaces(cell), use);
    }
    if (kind.Dimension == 2)
    {
      const auto corners = CountMarkCorners(type, static_cast<unsigned>(size));
      return corners >= 3 && HasAllNodes(type, corners, size) &&
        this->UseEdges(cell, type, corners, use);
    }
    if (kind.Dimension == 1 && size >= 2)
    {
      const std::size_t last = type == Polyline ? size - 1 : 1;
      this->Corners.assign(1, this->GetPoint(cell, 0));
      use(std::uint16_t{ 0 }, std::span<const std::uint32_t>(this->Corners));
      this->Corners.assign(1, this->GetPoint(cell, last));
      use(std::uint16_t{ 1 }, std::span<const std::uint32_t>(this->Corners));
      return true;
    }
    return false;
  }

  /** Calls use with each point of a side, whose corners are given, that is no corner. */
  template <typename Use>
  void ForEachNode(std::uint64_t cell, std::span<const std::uint32_t> corners, Use&& use) const
  {
    const auto type = this->Mesh.GetType(cell);
    const auto size = static_cast<std::size_t>(this->Mesh.GetEnd(cell) - this->Mesh.GetBegin(cell));
    if (this->Mesh.IsTetrahedral() || !HasNodes(type))
    {
      return;
    }
    const auto isOnSide = [&](std::uint16_t host)
    {
      return host == CellNode::None ||
        std::find(corners.begin(), corners.end(), this->GetPoint(cell, host)) != corners.end();
    };
    for (const auto& node : FindCellNodes(type, size).Nodes)
    {
      if (node.Where != CellNode::Kind::Inside && node.Host[0] != CellNode::None &&
        std::all_of(node.Host.begin(), node.Host.end(), isOnSide))
      {
        use(this->GetPoint(cell, node.Point));
      }
    }
  }

private:
  static constexpr std::uint8_t Polyline = 4;

  std::uint32_t GetPoint(std::uint64_t cell, std::size_t place) const
  {
    return static_cast<std::uint32_t>(this->Mesh.GetId(this->Mesh.GetBegin(cell) + place));
  }

  /** Faces by the places of corners in the cell. */
  template <typename Use>
  bool UseFaces(std::uint64_t cell, std::span<const std::uint8_t> faces, Use&& use)
  {
    return this->UseLists(
      faces, [&](std::uint8_t place) { return this->GetPoint(cell, place); }, use);
  }

  /** Faces of polyhedra. */
  template <typename Use>
  bool UseFaces(std::uint64_t, std::span<const std::int64_t> faces, Use&& use)
  {
    return this->UseLists(
      faces, [](std::int64_t point) { return static_cast<std::uint32_t>(point); }, use);
  }

  template <typename T, typename ToPoint, typename Use>
  bool UseLists(std::span<const T> faces, ToPoint&& toPoint, Use&& use)
  {
    unsigned number = 0;
    for (std::size_t at = 0; at < faces.size(); ++number)
    {
      this->Corners.clear();
      for (auto points = static_cast<std::size_t>(faces[at++]); points > 0; --points)
      {
        this->Corners.push_back(toPoint(faces[at++]));
      }
      if (number > MostNumber || this->Corners.size() > MostNumber)
      {
        return false;
      }
      use(static_cast<std::uint16_t>(number), std::span<const std::uint32_t>(this->Corners));
    }
    return true;
  }

  template <typename Use>
  bool UseEdges(std::uint64_t cell, std::uint8_t type, unsigned corners, Use&& use)
  {
    if (corners > MostNumber)
    {
      return false;
    }
    for (unsigned i = 0; i < corners; ++i)
    {
      const unsigned next = i + 1 < corners ? i + 1 : 0;
      this->Corners = { this->GetPoint(cell, GetMarkCorner(type, i)),
        this->GetPoint(cell, GetMarkCorner(type, next)) };
      use(static_cast<std::uint16_t>(i), std::span<const std::uint32_t>(this->Corners));
    }
    return true;
  }

  static constexpr unsigned MostNumber = 0xffff;

  const MeshAccess& Mesh;
  std::vector<std::uint32_t> Corners;
};

/** Finds the sides of single cells, first in each chunk and then in what is left of all. */
class SkinFinder
{
public:
  SkinFinder(const MeshAccess& mesh, const Partition& layout)
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
    SideFinder finder(this->Mesh);
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
    SideFinder finder(this->Mesh);
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

  void MarkSide(SideFinder& finder, const Side& side)
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
std::vector<std::uint8_t> FindSkin(const MeshAccess& mesh, const Partition& layout)
{
  return SkinFinder(mesh, layout).Find();
}
}
