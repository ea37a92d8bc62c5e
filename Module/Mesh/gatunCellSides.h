// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellSides_h
#define gatunCellSides_h

#include "gatunCellNodes.h"
#include "gatunCellShapes.h"
#include "gatunEncoderMarks.h"
#include "gatunMeshAccess.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Lists the sides of cells: the faces of 3D cells, the edges of 2D cells and the ends of 1D cells,
 * by their corners. Nonlinear cells have the sides of the linear ones with their corners. Not
 * thread safe.
 */
class CellSides
{
public:
  static constexpr unsigned MostNumber = 0xffff; ///< of sides of a cell, and of corners of a side

  explicit CellSides(const MeshAccess& mesh)
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

  const MeshAccess& Mesh;
  std::vector<std::uint32_t> Corners;
};
}

#endif
