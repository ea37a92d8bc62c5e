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
class vtkFieldData;
class vtkUnstructuredGrid;

namespace gtn
{
/** The values of an array as bytes, tuple by tuple. */
struct ArrayView
{
  std::string Name;
  std::string Title; ///< "point array 'pressure'"
  int Type = 0;      ///< VTK's number
  int Components = 1;
  std::vector<std::string> ComponentNames;
  unsigned Roles = 0; ///< bit i: active attribute i
  const unsigned char* Bytes = nullptr;
  std::size_t TupleBytes = 0;
  vtkSmartPointer<vtkDataArray> Owner;

  const unsigned char* Tuple(std::size_t i) const { return this->Bytes + i * this->TupleBytes; }

  /** The tuple's values for people; what they do not show is shown by its bytes. */
  std::string Text(std::size_t i) const;
};

using Tet = std::array<std::int64_t, 4>;

class GridView
{
public:
  /** The grid must live as long, and consist of tetrahedra. Throws Failure for arrays that are not
   * numeric. */
  explicit GridView(vtkUnstructuredGrid* grid);

  std::size_t Points = 0;
  std::size_t Cells = 0;
  ArrayView Coordinates;
  std::vector<ArrayView> PointArrays;
  std::vector<ArrayView> CellArrays;
  vtkFieldData* Field = nullptr;

  Tet Corners(std::size_t cell) const;

private:
  const std::int64_t* Wide = nullptr;
  const std::int32_t* Narrow = nullptr;
  vtkSmartPointer<vtkDataArray> Connectivity;
};

/** An array's values as bytes; bits become a byte each. */
ArrayView ViewOf(vtkAbstractArray* array, const std::string& kind);
}

#endif
