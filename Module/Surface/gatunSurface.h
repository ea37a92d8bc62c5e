// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurface_h
#define gatunSurface_h

#include "gatunExport.h"
#include "gatunSurfacePart.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * Isosurfaces assembled from parts. Points with the same coordinates are merged into the first of
 * them. Degenerate triangles are removed, as are points without triangles. There are no cracks
 * between parts if their common edges have the same end points.
 *
 * The order is that of the parts. The result does not depend on the number of threads.
 */
class GATUN_EXPORT Surface
{
public:
  /** All parts must have been made with the same options and arrays. Only the gradients of the
   * parts in ghosts, ascending, are used. Throws Error (InvalidInput) for more than 2^32 - 1
   * points. */
  explicit Surface(std::vector<SurfacePart> parts, ScalarType coordinateType,
    const std::vector<std::size_t>& ghosts = {});

  std::size_t GetNumberOfPoints() const { return this->Points; }
  std::size_t GetNumberOfTriangles() const { return this->FirstTriangle.back(); }

  /** Writes three points for each triangle, as numbers of 64 bits if wideIds, else of 32. */
  void FillTriangles(void* to, bool wideIds) const;

  /** Returns three points for each triangle. */
  std::vector<std::array<std::uint32_t, 3>> GetTriangles() const;

  /** Writes three coordinates for each point, of the requested type. */
  void FillPoints(void* to) const;

  /** Writes the tuples of array i, each of tupleSize bytes. */
  void FillPointArray(std::size_t i, std::size_t tupleSize, void* to) const;
  void FillCellArray(std::size_t i, std::size_t tupleSize, void* to) const;

  /** Writes a unit vector towards lower values for each point, or 0, 0, 0 if there is none. */
  void FillNormals(float* to) const;

private:
  static constexpr std::uint32_t None = 0xffffffffu;

  void RemoveDegenerate(std::size_t part);
  void NumberPoints();

  /** Copies the tuples of the points of a part that are in the surface to their places. */
  void Copy(std::size_t part, const std::uint8_t* tuples, std::size_t tupleSize, void* to) const;

  // Points and triangles stay in their parts until they are written, because a list of all of them
  // would take as much memory as the result.
  std::vector<SurfacePart> Parts;
  ScalarType CoordinateType;
  std::vector<std::size_t> First;    // for each part: the number of its first point
  std::vector<std::uint32_t> Same;   // for each point of a part: the first with its coordinates
  std::vector<std::uint32_t> Places; // for each of these: its place in the surface, or None
  std::size_t Points = 0;
  std::vector<std::size_t> FirstTriangle; // for each part: the number of its first triangle
  std::vector<std::vector<std::uint32_t>>
    Kept; // for each part with cell arrays: its triangles left
};
}

#endif
