// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTurnedCells_h
#define gatunTurnedCells_h

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The tetrahedra at the corners of the 3D cells of a grid, and their orientations. */
class CornerTets
{
public:
  using PlaceOf = std::function<std::array<double, 3>(vtkIdType point)>;

  /** placeOf: the coordinates of a point. */
  CornerTets(vtkUnstructuredGrid* grid, const PlaceOf& placeOf);

  bool IsEmpty() const { return this->Tets.empty(); }

  /** Marks the corners of the tetrahedra that have another orientation with other coordinates.
   * Returns the number of these tetrahedra. marks: of each point of the grid; 1 is added. */
  std::size_t MarkTurned(const PlaceOf& placeOf, std::vector<std::uint8_t>& marks) const;

private:
  std::vector<std::array<vtkIdType, 4>> Tets;
  std::vector<std::int8_t> Signs;
};
}

#endif
