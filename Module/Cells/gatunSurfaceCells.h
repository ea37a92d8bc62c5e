// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceCells_h
#define gatunSurfaceCells_h

#include <cstddef>
#include <cstdint>

namespace gatun
{
/** The lists of cells of a vtkPolyData, in the order that its cell arrays follow. */
enum class SurfaceList : std::uint8_t
{
  Vertices = 0,
  Lines = 1,
  Polygons = 2,
  Strips = 3
};

constexpr std::size_t SurfaceLists = 4;

/** Whether cells of a VTK type can be part of a surface file. */
constexpr bool IsSurfaceCell(int type)
{
  return (type >= 1 && type <= 7) || type == 9;
}

/** The list that has the cells of a type for which IsSurfaceCell holds. */
constexpr SurfaceList GetSurfaceList(int type)
{
  return type <= 2 ? SurfaceList::Vertices
    : type <= 4    ? SurfaceList::Lines
    : type == 6    ? SurfaceList::Strips
                   : SurfaceList::Polygons;
}

/** The type of a cell of a list with a number of points. The list and the points determine it, and
 * it determines the list. */
constexpr std::uint8_t GetSurfaceCell(SurfaceList list, std::int64_t points)
{
  switch (list)
  {
    case SurfaceList::Vertices:
      return points == 1 ? 1 : 2; // VTK_VERTEX, VTK_POLY_VERTEX
    case SurfaceList::Lines:
      return points == 2 ? 3 : 4; // VTK_LINE, VTK_POLY_LINE
    case SurfaceList::Strips:
      return 6; // VTK_TRIANGLE_STRIP
    default:
      return points == 3 ? 5 : points == 4 ? 9 : 7; // VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON
  }
}
}

#endif
