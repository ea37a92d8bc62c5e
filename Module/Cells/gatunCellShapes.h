// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellShapes_h
#define gatunCellShapes_h

// The cell types of VTK, by their numbers in vtkCellType.h.

#include "gatunExport.h" // For export macro

#include <cstdint>
#include <span>

namespace gatun
{
constexpr std::uint8_t TriangleType = 5;    ///< VTK_TRIANGLE
constexpr std::uint8_t TetraType = 10;      ///< VTK_TETRA
constexpr std::uint8_t PolyhedronType = 42; ///< VTK_POLYHEDRON

/** A 3D cell type with a fixed number of faces. */
struct CellShape
{
  std::uint8_t Corners;

  /** Each face: the number of its corners, then the corners, counterclockwise if seen from outside
   * of a cell with a positive volume. Corners of voxels are in a cycle, too. */
  std::span<const std::uint8_t> Faces;
};

/** Role of a cell type in a volume. */
struct CellKind
{
  /** Of the space that a cell fills: 0 to 3, or -1 for an unknown type. */
  int Dimension = -1;

  /** The cell that is left of a nonlinear one without its other points, which come after the
   * corners; null for polyhedra, convex point sets and cells of a lower dimension. */
  const CellShape* Shape = nullptr;

  /** The number of points, or 0 if cells of the type differ in it. */
  std::uint8_t Points = 0;

  bool IsLinear() const { return this->Shape && this->Shape->Corners == this->Points; }
};

/** Returns the kind of a VTK cell type, which may be any number. */
GATUN_EXPORT CellKind GetCellKind(int type);

/** The name of a cell type: that of its class in VTK, or as it would be; null for an unknown type.
 */
GATUN_EXPORT const char* GetCellTypeName(int type);
}

#endif
