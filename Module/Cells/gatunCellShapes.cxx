// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCellShapes.h"

namespace gatun
{
namespace
{
// clang-format off
constexpr std::uint8_t TetraFaces[] = { 3, 0, 1, 3,  3, 1, 2, 3,  3, 2, 0, 3,  3, 0, 2, 1 };
constexpr std::uint8_t PyramidFaces[] = { 4, 0, 3, 2, 1,  3, 0, 1, 4,  3, 1, 2, 4,  3, 2, 3, 4,
  3, 3, 0, 4 };
constexpr std::uint8_t WedgeFaces[] = { 3, 0, 1, 2,  3, 3, 5, 4,  4, 0, 3, 4, 1,  4, 1, 4, 5, 2,
  4, 2, 5, 3, 0 };
constexpr std::uint8_t VoxelFaces[] = { 4, 0, 4, 6, 2,  4, 1, 3, 7, 5,  4, 0, 1, 5, 4,
  4, 2, 6, 7, 3,  4, 0, 2, 3, 1,  4, 4, 5, 7, 6 };
constexpr std::uint8_t HexahedronFaces[] = { 4, 0, 4, 7, 3,  4, 1, 2, 6, 5,  4, 0, 1, 5, 4,
  4, 3, 7, 6, 2,  4, 0, 3, 2, 1,  4, 4, 5, 6, 7 };
constexpr std::uint8_t PentagonalPrismFaces[] = { 5, 0, 4, 3, 2, 1,  5, 5, 6, 7, 8, 9,
  4, 0, 1, 6, 5,  4, 1, 2, 7, 6,  4, 2, 3, 8, 7,  4, 3, 4, 9, 8,  4, 4, 0, 5, 9 };
constexpr std::uint8_t HexagonalPrismFaces[] = { 6, 0, 5, 4, 3, 2, 1,  6, 6, 7, 8, 9, 10, 11,
  4, 0, 1, 7, 6,  4, 1, 2, 8, 7,  4, 2, 3, 9, 8,  4, 3, 4, 10, 9,  4, 4, 5, 11, 10,
  4, 5, 0, 6, 11 };
// clang-format on

constexpr CellShape Tetra{ 4, TetraFaces };
constexpr CellShape Pyramid{ 5, PyramidFaces };
constexpr CellShape Wedge{ 6, WedgeFaces };
constexpr CellShape Voxel{ 8, VoxelFaces };
constexpr CellShape Hexahedron{ 8, HexahedronFaces };
constexpr CellShape PentagonalPrism{ 10, PentagonalPrismFaces };
constexpr CellShape HexagonalPrism{ 12, HexagonalPrismFaces };
}

//------------------------------------------------------------------------------
CellKind GetCellKind(int type)
{
  switch (type)
  {
    case 0: // empty cell
    case 1: // vertex
    case 2: // polyvertex
      return { 0 };
    case 3:  // line
    case 4:  // polyline
    case 21: // quadratic edge
    case 35: // cubic line
    case 51: // parametric curve
    case 60: // higher-order edge
    case 68: // Lagrange curve
    case 75: // Bezier curve
      return { 1 };
    case 5:  // triangle
    case 6:  // triangle strip
    case 7:  // polygon
    case 8:  // pixel
    case 9:  // quad
    case 22: // quadratic triangle
    case 23: // quadratic quad
    case 28: // biquadratic quad
    case 30: // quadratic linear quad
    case 34: // biquadratic triangle
    case 36: // quadratic polygon
    case 52: // parametric surface
    case 53: // parametric triangle surface
    case 54: // parametric quad surface
    case 61: // higher-order triangle
    case 62: // higher-order quad
    case 63: // higher-order polygon
    case 69: // Lagrange triangle
    case 70: // Lagrange quad
    case 76: // Bezier triangle
    case 77: // Bezier quad
      return { 2 };
    case 10:
      return { 3, &Tetra, 4 };
    case 11:
      return { 3, &Voxel, 8 };
    case 12:
      return { 3, &Hexahedron, 8 };
    case 13:
      return { 3, &Wedge, 6 };
    case 14:
      return { 3, &Pyramid, 5 };
    case 15:
      return { 3, &PentagonalPrism, 10 };
    case 16:
      return { 3, &HexagonalPrism, 12 };
    case 24: // quadratic
      return { 3, &Tetra, 10 };
    case 25:
      return { 3, &Hexahedron, 20 };
    case 26:
      return { 3, &Wedge, 15 };
    case 27:
      return { 3, &Pyramid, 13 };
    case 29: // triquadratic
      return { 3, &Hexahedron, 27 };
    case 31: // quadratic linear
      return { 3, &Wedge, 12 };
    case 32: // biquadratic quadratic
      return { 3, &Wedge, 18 };
    case 33:
      return { 3, &Hexahedron, 24 };
    case 37: // triquadratic
      return { 3, &Pyramid, 19 };
    case 55: // parametric regions
      return { 3, &Tetra };
    case 56:
      return { 3, &Hexahedron };
    case 64: // of higher order
    case 71: // Lagrange
    case 78: // Bezier
      return { 3, &Tetra };
    case 65:
    case 73:
    case 80:
      return { 3, &Wedge };
    case 66:
    case 74:
    case 81:
      return { 3, &Pyramid };
    case 67:
    case 72:
    case 79:
      return { 3, &Hexahedron };
    case 41: // convex point set
    case 42: // polyhedron
      return { 3 };
    default:
      return {};
  }
}

//------------------------------------------------------------------------------
const char* GetCellTypeName(int type)
{
  struct Named
  {
    int Type;
    const char* Name;
  };
  static constexpr Named names[] = {
    { 0, "vtkEmptyCell" },
    { 1, "vtkVertex" },
    { 2, "vtkPolyVertex" },
    { 3, "vtkLine" },
    { 4, "vtkPolyLine" },
    { 5, "vtkTriangle" },
    { 6, "vtkTriangleStrip" },
    { 7, "vtkPolygon" },
    { 8, "vtkPixel" },
    { 9, "vtkQuad" },
    { 10, "vtkTetra" },
    { 11, "vtkVoxel" },
    { 12, "vtkHexahedron" },
    { 13, "vtkWedge" },
    { 14, "vtkPyramid" },
    { 15, "vtkPentagonalPrism" },
    { 16, "vtkHexagonalPrism" },
    { 21, "vtkQuadraticEdge" },
    { 22, "vtkQuadraticTriangle" },
    { 23, "vtkQuadraticQuad" },
    { 24, "vtkQuadraticTetra" },
    { 25, "vtkQuadraticHexahedron" },
    { 26, "vtkQuadraticWedge" },
    { 27, "vtkQuadraticPyramid" },
    { 28, "vtkBiQuadraticQuad" },
    { 29, "vtkTriQuadraticHexahedron" },
    { 30, "vtkQuadraticLinearQuad" },
    { 31, "vtkQuadraticLinearWedge" },
    { 32, "vtkBiQuadraticQuadraticWedge" },
    { 33, "vtkBiQuadraticQuadraticHexahedron" },
    { 34, "vtkBiQuadraticTriangle" },
    { 35, "vtkCubicLine" },
    { 36, "vtkQuadraticPolygon" },
    { 37, "vtkTriQuadraticPyramid" },
    { 41, "vtkConvexPointSet" },
    { 42, "vtkPolyhedron" },
    { 51, "vtkParametricCurve" },
    { 52, "vtkParametricSurface" },
    { 53, "vtkParametricTriSurface" },
    { 54, "vtkParametricQuadSurface" },
    { 55, "vtkParametricTetraRegion" },
    { 56, "vtkParametricHexRegion" },
    { 60, "vtkHigherOrderEdge" },
    { 61, "vtkHigherOrderTriangle" },
    { 62, "vtkHigherOrderQuad" },
    { 63, "vtkHigherOrderPolygon" },
    { 64, "vtkHigherOrderTetrahedron" },
    { 65, "vtkHigherOrderWedge" },
    { 66, "vtkHigherOrderPyramid" },
    { 67, "vtkHigherOrderHexahedron" },
    { 68, "vtkLagrangeCurve" },
    { 69, "vtkLagrangeTriangle" },
    { 70, "vtkLagrangeQuadrilateral" },
    { 71, "vtkLagrangeTetra" },
    { 72, "vtkLagrangeHexahedron" },
    { 73, "vtkLagrangeWedge" },
    { 74, "vtkLagrangePyramid" },
    { 75, "vtkBezierCurve" },
    { 76, "vtkBezierTriangle" },
    { 77, "vtkBezierQuadrilateral" },
    { 78, "vtkBezierTetra" },
    { 79, "vtkBezierHexahedron" },
    { 80, "vtkBezierWedge" },
    { 81, "vtkBezierPyramid" },
  };
  for (const auto& named : names)
  {
    if (named.Type == type)
    {
      return named.Name;
    }
  }
  return nullptr;
}
}
