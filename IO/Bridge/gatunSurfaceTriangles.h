// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceTriangles_h
#define gatunSurfaceTriangles_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h" // For vtkIdType

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCellArray;
class vtkPolyData;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Calls body(cell, count, ids) for each cell of an array of a surface that is no ghost cell.
 * first: the number of its first cell. Throws gatun::Error (InvalidInput) if a point does not
 * exist. */
VTKGATUNIO_EXPORT void ForEachOwnCell(vtkPolyData* surface, vtkCellArray* cells, vtkIdType first,
  const std::function<void(vtkIdType, vtkIdType, const vtkIdType*)>& body);

/** The triangles of a surface, with the cells that they come from. */
struct VTKGATUNIO_EXPORT SurfaceTriangles
{
  /** Polygons and strips are divided into triangles, those of a polygon without holes in its plane
   * by cutting ears. Cells with less than three points and ghost cells are left out. Throws
   * gatun::Error (InvalidInput) if there are too many points or a cell has a point that does not
   * exist. */
  explicit SurfaceTriangles(vtkPolyData* surface);

  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Triangle> Corners;
  std::vector<vtkIdType> Cells; ///< of each triangle

  /** Of each point, whether a vertex or a line has it. */
  std::vector<std::uint8_t> IsMarked;

  /** Of each point, whether no cells have it but ghost cells. Empty: none. */
  std::vector<std::uint8_t> IsOfGhosts;

private:
  void FindPointsOfGhosts(vtkPolyData* surface);
};

/** Returns the surface with its polygons and strips divided into triangles, as SurfaceTriangles
 * does it, or the surface itself if it has nothing else than triangles, vertices and lines. A
 * triangle has the data of its cell. Cells with less than three points are left out. Throws as
 * SurfaceTriangles. */
VTKGATUNIO_EXPORT vtkSmartPointer<vtkPolyData> MakeTriangleSurface(vtkPolyData* surface);
}

#endif
