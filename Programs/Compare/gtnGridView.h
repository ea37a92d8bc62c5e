// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnGridView_h
#define gtnGridView_h

// The bytes of a grid, for comparing.

#include "gatunFaceStream.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <span>
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

  std::string Title;             ///< "point array 'pressure'"
  std::string Kind;              ///< "float, 3 component(s)"
  std::string Roles;             ///< " (x, y, z), active Scalars"
  std::vector<std::string> Keys; ///< "vtkDataArray::UNITS_LABEL = m"
  const unsigned char* Bytes = nullptr;
  std::size_t TupleBytes = 0;
  vtkSmartPointer<vtkDataArray> Owner;

  const unsigned char* Tuple(std::size_t i) const { return this->Bytes + i * this->TupleBytes; }

  /** The values of a tuple. NaN is printed with its bits. */
  std::string Text(std::size_t i) const;
};

/** The information keys of an array, with their values. */
std::vector<std::string> KeyTexts(vtkAbstractArray* array);

/** Views of the arrays of a grid, which must live as long. */
struct GridView
{
  /** Throws Failure for arrays that are not numeric. The cells must be valid: see MakeCellInput. */
  explicit GridView(vtkUnstructuredGrid* grid);

  vtkUnstructuredGrid* Grid;
  std::size_t Points;
  std::vector<ArrayView> PointArrays; ///< the coordinates come first
  std::vector<ArrayView> CellArrays;
  std::size_t Cells;

  /** Whether the coordinates are among the arrays. */
  bool HasCoordinates() const;

  int GetType(std::size_t cell) const { return this->Types[cell]; }

  /** The ids of the points of a cell. */
  std::span<const std::int64_t> GetIds(std::size_t cell) const
  {
    const auto begin = static_cast<std::size_t>(this->Starts[cell]);
    return std::span(this->Ids).subspan(
      begin, static_cast<std::size_t>(this->Starts[cell + 1]) - begin);
  }

  /** The faces of a polyhedron: for each the number of its points, and their ids. Empty for other
   * cells. */
  std::span<const std::int64_t> GetFaces(std::size_t cell) const;

private:
  vtkSmartPointer<vtkUnsignedCharArray> TypeArray;
  const unsigned char* Types = nullptr;
  std::vector<std::int64_t> Starts; // of the ids of each cell, and the end
  std::vector<std::int64_t> Ids;
  gatun::FaceStream Faces;
};
}

#endif
