// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMarch_h
#define gatunMarch_h

// Isosurfaces of tetrahedra: their intersections with edges, and their triangles.

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
  const void* Connectivity = nullptr; ///< four point ids for each tetrahedron
  bool WideIds = true;                ///< ids are std::int64_t, else std::int32_t
  const void* Values = nullptr;       ///< one for each point
  bool WideValues = true;             ///< values are double, else float
};

/** The intersection of an isosurface with an edge. */
struct Crossing
{
  std::uint32_t Low;  ///< the point whose value is below the isovalue
  std::uint32_t High; ///< the point whose value is not
  double Part;        ///< fraction of the way from Low to High, above 0 and up to 1

  bool operator==(const Crossing&) const = default;
};

/** Isosurfaces in some tetrahedra, in the order of the tetrahedra. */
struct MarchedSurface
{
  std::vector<Crossing> Points;                        ///< at most one for each edge and isovalue
  std::vector<std::array<std::uint32_t, 3>> Triangles; ///< places in Points
  std::vector<std::uint32_t> Cells;                    ///< the tetrahedron of each triangle
};

/**
 * Finds the isosurfaces of some values, finite and strictly ascending, in the tetrahedra first to
 * last - 1. The conventions are those of vtkTetra::Contour: a corner is inside if its value is not
 * below the isovalue; a section with four corners is cut along the diagonal of its table; the front
 * of a triangle of a tetrahedron with positive volume faces lower values. The isovalues of a
 * tetrahedron come one after the other. A tetrahedron with a value that is not finite has no
 * surface. Throws Error (InvalidInput) for ids of points that do not exist. The caller must remove
 * triangles with coinciding corners.
 */
MarchedSurface March(
  const MarchInput& mesh, std::uint64_t first, std::uint64_t last, std::span<const double> values);
}

#endif
