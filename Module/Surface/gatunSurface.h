// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurface_h
#define gatunSurface_h

#include "gatunSurfacePart.h"
#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Isosurfaces put together from parts. Points with the same coordinates become one, the first of
 * them; triangles with two corners in one point go, as do points that no triangle is left of. So
 * parts fit without cracks if the same edges have the same ends in all of them.
 *
 * Order: that of the parts. The result does not depend on the number of threads.
 */
class VTKGATUNCORE_EXPORT Surface
{
public:
  /** Parts must all have been made with the same options and arrays. Of the parts in ghosts,
   * ascending, only the gradients are taken. Throws Error (InvalidInput) for more than 2^32 - 1
   * points. */
  explicit Surface(std::vector<SurfacePart> parts, ScalarType coordinateType,
    const std::vector<std::size_t>& ghosts = {});

  std::size_t GetNumberOfPoints() const { return this->Points; }
  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }

  /** Three places of points a triangle. */
  const std::vector<std::array<std::uint32_t, 3>>& GetTriangles() const { return this->Triangles; }

  /** Three values a point, of the type that was asked for. */
  void FillPoints(void* to) const;

  /** Array number i, and bytes of a tuple of it. */
  void FillPointArray(std::size_t i, std::size_t tupleSize, void* to) const;
  void FillCellArray(std::size_t i, std::size_t tupleSize, void* to) const;

  /** Three values a point: unit vectors towards lower values, or 0, 0, 0 where there are none. */
  void FillNormals(float* to) const;

private:
  static constexpr std::uint32_t None = 0xffffffffu;

  void Copy(std::size_t tupleSize, void* to,
    const std::vector<std::uint8_t>& (*from)(const SurfacePart&, std::size_t), std::size_t i) const;

  std::vector<SurfacePart> Parts;
  ScalarType CoordinateType;
  std::vector<std::size_t> First;    // of each part: number of its first point
  std::vector<std::uint32_t> Same;   // of each point of a part: the first with its coordinates
  std::vector<std::uint32_t> Places; // of each of these first ones: place in the surface, or None
  std::size_t Points = 0;
  std::vector<std::array<std::uint32_t, 3>> Triangles;
  std::vector<std::vector<std::uint32_t>> Kept; // of each part with cell arrays: its triangles left
};
}

#endif
