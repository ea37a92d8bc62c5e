// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBoundaryFaces_h
#define gatunBoundaryFaces_h

// The boundary of a mesh: the faces that only one of its 3D cells has, and its cells of a lower
// dimension. Nonlinear cells count as the linear ones with their corners.

#include "gatunMeshAccess.h"
#include "gatunSurfaceCells.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** A face of a 3D cell. Faces with the same points are equal. */
struct BoundaryFace
{
  std::array<std::uint32_t, 3> Least{}; ///< the numbers of the least points, ascending
  std::uint32_t Rest = 0;               ///< the fourth point, or a hash of all others
  std::uint32_t Cell = 0;
  std::uint16_t Number = 0; ///< within the cell
  std::uint16_t Size = 0;   ///< of all different points
  bool IsShared = false;    ///< whether cells elsewhere may have all of its points

  bool IsSame(const BoundaryFace& other) const
  {
    return this->Least == other.Least && this->Rest == other.Rest && this->Size == other.Size;
  }
};

/**
 * The faces of some 3D cells that may be on the boundary of the mesh that they are part of. Faces
 * without at least three different points are left out, as are all faces of convex point sets and
 * of cells with a wrong number of points.
 *
 * numberOf: the number of a point in the whole mesh. isShared: whether cells of the mesh that are
 * not among these may have a point.
 */
std::vector<BoundaryFace> FindOpenFaces(const MeshAccess& mesh,
  std::span<const std::uint32_t> cells, const std::function<std::uint32_t(std::uint32_t)>& numberOf,
  const std::function<bool(std::uint32_t)>& isShared);

/** Leaves what may be on the boundary of all of the mesh, of the open faces of a part of it, with
 * IsShared for cells of other parts. */
void KeepOpenFaces(std::vector<BoundaryFace>& faces);

/** Leaves the faces that occur once, of the open faces of all parts of a mesh. */
void KeepSingleFaces(std::vector<BoundaryFace>& faces);

/** Gets the corners of a face. */
void FindCorners(
  const MeshAccess& mesh, const BoundaryFace& face, std::vector<std::uint32_t>& corners);

/** Gets the corners of a cell of a lower dimension and the list of a surface that it belongs to;
 * nothing if it is none. */
std::optional<SurfaceList> FindSurfaceCell(
  const MeshAccess& mesh, std::uint64_t cell, std::vector<std::uint32_t>& corners);
}

#endif
