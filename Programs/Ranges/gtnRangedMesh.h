// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnRangedMesh_h
#define gtnRangedMesh_h

// A mesh that is read by ranges of its points and cells.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace gtn
{
/** Points or cells that are read at once. */
inline constexpr std::size_t BlockSize = 1 << 16;

/** Consecutive cells of a mesh. */
struct RangedCells
{
  std::vector<std::uint8_t> Types;
  std::vector<std::uint32_t> Sizes;  ///< the number of points of each cell
  std::vector<std::uint32_t> Points; ///< of all cells, one after the other

  /** Only of a mesh with polyhedra. The faces of a polyhedron are their number, and the number of
   * points and the points of each face. Others have none. */
  std::vector<std::uint32_t> FaceSizes; ///< the number of values of each cell
  std::vector<std::uint32_t> Faces;     ///< of all cells, one after the other
};

/** Methods throw Failure with the name of the file. */
class RangedMesh
{
public:
  virtual ~RangedMesh() = default;

  virtual std::uint64_t GetNumberOfPoints() const = 0;
  virtual std::uint64_t GetNumberOfCells() const = 0;
  virtual bool HasPolyhedra() const = 0;

  /** Whether ids have 64 bits in a grid of this mesh. */
  virtual bool HasWideIds() const = 0;

  /** The times in ascending order, or nothing without time. */
  virtual std::vector<double> GetTimes() const = 0;

  /** A grid without points and cells, with the type of the points, all arrays and the field data of
   * a time step. All steps have the same arrays. */
  virtual vtkUnstructuredGrid* GetTemplate(std::size_t step) const = 0;

  /** Reads coordinates of the type that they have. */
  virtual void ReadPoints(std::uint64_t begin, std::size_t count, void* values) = 0;

  /** Reads some cells, at most count, into the arrays, which are cleared first. Ranges follow each
   * other, or begin again at 0. Points of cells are below the number of points. */
  virtual void ReadCells(std::uint64_t begin, std::size_t count, RangedCells& cells) = 0;

  /** Reads tuples of an array. association: vtkDataObject::POINT or CELL. array: its number in the
   * template. */
  virtual void ReadArray(int association, int array, std::size_t step, std::uint64_t begin,
    std::size_t count, void* values) = 0;

  /** Throws if the files are not as they were when they were opened. */
  virtual void CheckUnchanged() const = 0;
};
}

#endif
