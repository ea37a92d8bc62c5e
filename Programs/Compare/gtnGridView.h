// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnGridView_h
#define gtnGridView_h

// The bytes of a tetrahedral grid, for comparing.

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkUnstructuredGrid;

namespace gtn
{
/** The values of an array as bytes, tuple by tuple. */
struct ArrayView
{
  /** Throws Failure for arrays that are not numeric. */
  ArrayView(vtkAbstractArray* array, const std::string& kind);

  std::string Title; ///< "point array 'pressure'"
  std::string Kind;  ///< "float, 3 components (x, y, z), active Scalars"
  const unsigned char* Bytes = nullptr;
  std::size_t TupleBytes = 0;
  vtkSmartPointer<vtkDataArray> Owner;

  const unsigned char* Tuple(std::size_t i) const { return this->Bytes + i * this->TupleBytes; }

  /** The values of a tuple. NaN is printed with its bits. */
  std::string Text(std::size_t i) const;
};

using Tet = std::array<std::int64_t, 4>;

/** Views of the arrays of a grid, which must live as long. */
struct GridView
{
  /** Throws Failure for other cells than tetrahedra, and for arrays that are not numeric. */
  explicit GridView(vtkUnstructuredGrid* grid);

  vtkUnstructuredGrid* Grid;
  std::size_t Points;
  std::vector<ArrayView> PointArrays; ///< the coordinates come first
  std::vector<ArrayView> CellArrays;
  std::vector<Tet> Tets;
};
}

#endif
