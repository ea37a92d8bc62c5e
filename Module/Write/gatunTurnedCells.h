// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTurnedCells_h
#define gatunTurnedCells_h

#include "gatunMeshAccess.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/** The tetrahedra at the corners of the 3D cells of a mesh, and their orientations. */
class CornerTets
{
public:
  using PlaceOf = std::function<std::array<double, 3>(std::uint64_t point)>;

  /** Takes cells that CheckCells and CheckCellSizes have found to be right. placeOf: the
   * coordinates of a point. */
  CornerTets(const MeshAccess& mesh, const PlaceOf& placeOf);

  /** Marks the corners of the tetrahedra that have another orientation with other coordinates.
   * Returns the number of these tetrahedra. marks: of each point of the mesh; 1 is added. */
  std::size_t MarkTurned(const PlaceOf& placeOf, std::vector<std::uint8_t>& marks) const;

private:
  std::vector<std::array<std::uint32_t, 4>> Tets;
  std::vector<std::int8_t> Signs;
};
}

#endif
