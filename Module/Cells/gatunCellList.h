// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellList_h
#define gatunCellList_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Cells of any VTK type, with 32-bit point numbers, as vtkUnstructuredGrid has them. */
struct CellList
{
  std::vector<std::uint8_t> Types;

  /** The corners of cell c are Corners[Starts[c]] to Corners[Starts[c + 1] - 1]. */
  std::vector<std::uint32_t> Starts{ 0 };
  std::vector<std::uint32_t> Corners;

  /** The faces of polyhedra: for each face the number of its corners, then the corners. FaceStarts
   * is as Starts, or empty if there are no polyhedra. */
  std::vector<std::uint32_t> FaceStarts;
  std::vector<std::uint32_t> Faces;

  std::size_t GetNumber() const { return this->Types.size(); }

  std::span<const std::uint32_t> GetCorners(std::size_t cell) const
  {
    return std::span(this->Corners)
      .subspan(this->Starts[cell], this->Starts[cell + 1] - this->Starts[cell]);
  }

  /** The faces of a polyhedron. Empty for other cells. */
  std::span<const std::uint32_t> GetFaces(std::size_t cell) const
  {
    return this->FaceStarts.empty()
      ? std::span<const std::uint32_t>()
      : std::span(this->Faces)
          .subspan(this->FaceStarts[cell], this->FaceStarts[cell + 1] - this->FaceStarts[cell]);
  }

  bool operator==(const CellList&) const = default;
};

/** Whether a corner occurs twice. */
inline bool HasTwice(std::span<const std::uint32_t> corners)
{
  constexpr std::size_t few = 32; // need no copy
  if (corners.size() > few)
  {
    std::vector<std::uint32_t> sorted(corners.begin(), corners.end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }
  for (auto corner = corners.begin(); corner != corners.end(); ++corner)
  {
    if (std::find(corners.begin(), corner, *corner) != corner)
    {
      return true;
    }
  }
  return false;
}
}

#endif
