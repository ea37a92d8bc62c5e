// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshAccess_h
#define gatunMeshAccess_h

#include "gatunCellSplitter.h"
#include "gatunMeshInput.h"
#include "gatunPrefetch.h"
#include "gatunTypes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gatun
{

/** Reads coordinates and connectivity of a MeshInput of any type. */
class MeshAccess
{
public:
  explicit MeshAccess(const MeshInput& mesh)
    : Mesh(mesh)
  {
  }

  double GetCoordinate(std::uint64_t point, unsigned axis) const
  {
    return this->Mesh.CoordinateType == ScalarType::Float32
      ? static_cast<double>(static_cast<const float*>(this->Mesh.Coordinates)[3 * point + axis])
      : static_cast<const double*>(this->Mesh.Coordinates)[3 * point + axis];
  }

  /** Whether all cells are tetrahedra. */
  bool IsTetrahedral() const { return this->Mesh.Types == nullptr; }

  std::uint8_t GetType(std::uint64_t cell) const
  {
    return this->IsTetrahedral() ? TetraType : this->Mesh.Types[cell];
  }

  /** The positions of a cell's point ids in the connectivity. */
  std::uint64_t GetBegin(std::uint64_t cell) const
  {
    return this->IsTetrahedral() ? 4 * cell : this->Read(this->Mesh.Offsets, cell);
  }
  std::uint64_t GetEnd(std::uint64_t cell) const { return this->GetBegin(cell + 1); }

  /** A point id of the connectivity. It is unsigned, so that negative ids are out of range. */
  std::uint64_t GetId(std::uint64_t position) const
  {
    return this->Read(this->Mesh.Connectivity, position);
  }

  /** A point id of a tetrahedron, if all cells are tetrahedra. */
  std::uint64_t GetTetId(std::uint64_t tet, unsigned corner) const
  {
    return this->GetId(4 * tet + corner);
  }

  /** The faces of a polyhedron: for each face the number of its points and their ids. Empty for
   * other cells. CheckCells has found them to be right. */
  std::span<const std::int64_t> GetFaces(std::uint64_t cell) const
  {
    if (this->GetType(cell) != PolyhedronType || !this->Mesh.FaceLocations ||
      this->Mesh.FaceLocations[cell] < 0)
    {
      return {};
    }
    const std::int64_t* const begin = this->Mesh.Faces + this->Mesh.FaceLocations[cell] + 1;
    const std::int64_t* end = begin;
    for (std::int64_t faces = begin[-1]; faces > 0; --faces)
    {
      end += *end + 1;
    }
    return { begin, end };
  }

  /** Begins to load the point ids of one of some cells, for a loop over them. */
  void FetchAhead(std::span<const std::uint32_t> cells, std::size_t at) const
  {
    if (this->IsTetrahedral() && at + Ahead < cells.size())
    {
      Fetch(this->Mesh.Connectivity, cells[at + Ahead], 4 * (this->Mesh.WideIds ? 8 : 4));
    }
  }

  /** The same of the coordinates of a cell's points. */
  void FetchPointsAhead(std::span<const std::uint32_t> cells, std::size_t at) const
  {
    for (unsigned i = 0; i < 4 && this->IsTetrahedral() && at + Ahead < cells.size(); ++i)
    {
      Fetch(this->Mesh.Coordinates, this->GetTetId(cells[at + Ahead], i),
        3 * SizeOf(this->Mesh.CoordinateType));
    }
  }

  /** Calls use with each point id of a cell, and with those of a polyhedron's faces again. */
  template <typename Use>
  void ForEachPoint(std::uint64_t cell, Use&& use) const
  {
    if (this->IsTetrahedral())
    {
      use(this->GetTetId(cell, 0));
      use(this->GetTetId(cell, 1));
      use(this->GetTetId(cell, 2));
      use(this->GetTetId(cell, 3));
      return;
    }
    const std::uint64_t end = this->GetEnd(cell);
    for (std::uint64_t i = this->GetBegin(cell); i < end; ++i)
    {
      use(this->GetId(i));
    }
    const auto faces = this->GetFaces(cell);
    for (std::size_t at = 0; at < faces.size();)
    {
      for (auto points = faces[at++]; points > 0; --points)
      {
        use(static_cast<std::uint64_t>(faces[at++]));
      }
    }
  }

  /** Approximate number of tetrahedra of the cells, from their numbers of points. */
  std::uint64_t EstimateTets() const
  {
    const std::uint64_t cells = this->Mesh.Cells;
    return this->IsTetrahedral() || cells == 0
      ? cells
      : std::max(cells, this->GetBegin(cells) - std::min(3 * cells, this->GetBegin(cells)));
  }

  /** The same of some of the cells. */
  std::uint64_t EstimateTets(std::span<const std::uint32_t> cells) const
  {
    std::uint64_t tets = 0;
    for (const auto cell : cells)
    {
      const auto points = this->GetEnd(cell) - this->GetBegin(cell);
      tets += std::max<std::uint64_t>(points, 4) - 3;
    }
    return tets;
  }

  /** Adds the finite coordinates of a point to a box. */
  void Include(Bounds& box, std::uint64_t point) const
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const double x = this->GetCoordinate(point, axis);
      if (std::isfinite(x))
      {
        box[axis].Include(x);
      }
    }
  }

  const MeshInput& GetMesh() const { return this->Mesh; }

private:
  static constexpr std::size_t Ahead = 16; // cells are fetched by so many

  /** Begins to load an item of an array, which may be in two lines of the cache. */
  static void Fetch(const void* items, std::uint64_t item, std::size_t size)
  {
    const auto* const begin = static_cast<const std::uint8_t*>(items) + size * item;
    Prefetch(begin);
    Prefetch(begin + size - 1);
  }

  std::uint64_t Read(const void* ids, std::uint64_t position) const
  {
    return this->Mesh.WideIds ? static_cast<const std::uint64_t*>(ids)[position]
                              : static_cast<std::uint64_t>(static_cast<std::int64_t>(
                                  static_cast<const std::int32_t*>(ids)[position]));
  }

  const MeshInput Mesh;
};
}

#endif
