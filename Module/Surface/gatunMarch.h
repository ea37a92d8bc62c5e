// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMarch_h
#define gatunMarch_h

// Isosurfaces of tetrahedra: where they cross the edges, and the triangles in between.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Tetrahedra with a value at each point. */
struct MarchInput
{
  std::uint64_t Points = 0;
  const void* Connectivity = nullptr; ///< four point ids a tetrahedron
  bool WideIds = true;                ///< ids are std::int64_t, else std::int32_t
  const void* Values = nullptr;       ///< one a point
  bool WideValues = true;             ///< values are double, else float
};

/** Where an isosurface crosses an edge. */
struct Crossing
{
  std::uint32_t Low;  ///< the point whose value is below the isovalue
  std::uint32_t High; ///< the point whose value is not
  double Part;        ///< of the way from Low to High, above 0 and up to 1

  bool operator==(const Crossing&) const = default;
};

/** Isosurfaces in some tetrahedra, in the order of these. */
struct MarchedSurface
{
  std::vector<Crossing> Points;                        ///< no two on one edge for one isovalue
  std::vector<std::array<std::uint32_t, 3>> Triangles; ///< places in Points
  std::vector<std::uint32_t> Cells;                    ///< of each triangle: its tetrahedron
};

/**
 * Finds the isosurfaces of some values, finite and strictly ascending, in the tetrahedra first to
 * last - 1. The conventions are those of vtkTetra::Contour: a corner is inside if its value is not
 * below the isovalue; a section with four corners is cut along the diagonal that its table has; the
 * front of a triangle of a tetrahedron that is not turned over looks towards lower values. Of a
 * tetrahedron, isovalues come one after the other. A tetrahedron with a corner that is not finite
 * has no surface. Throws Error (InvalidInput) for ids of points that do not exist. Triangles whose
 * corners fall together have to be sorted out by the caller.
 */
MarchedSurface March(
  const MarchInput& mesh, std::uint64_t first, std::uint64_t last, std::span<const double> values);
}

#endif
