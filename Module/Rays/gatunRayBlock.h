// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayBlock_h
#define gatunRayBlock_h

#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A point of a mesh with its value. NaN: nothing is seen of the tetrahedra that have it. */
struct alignas(32) RayPoint
{
  double X, Y, Z, Value;
};

/** Tetrahedra that are drawn together; some ten thousand are best. */
struct VTKGATUNCORE_EXPORT RayBlock
{
  using Tet = std::array<std::uint32_t, 4>;
  static constexpr std::uint32_t NoNeighbour = 0xffffffffu;

  std::vector<RayPoint> Points;
  std::vector<Tet> Tets; ///< point indices
  std::vector<double>
    CellValues; ///< if not empty, of the tetrahedra, instead of the points' values

  /** Takes getValue(i) for the value of each point or tetrahedron. */
  template <typename GetValue>
  void SetValues(Association where, GetValue&& getValue)
  {
    if (where == Association::Cell)
    {
      this->CellValues.resize(this->Tets.size());
      for (std::size_t i = 0; i < this->Tets.size(); ++i)
      {
        this->CellValues[i] = getValue(i);
      }
      return;
    }
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->Points[i].Value = getValue(i);
    }
  }

  /**
   * Makes ready for drawing, once for all views: puts the corners of each tetrahedron into the
   * order of their coordinates, so that all who have a face, in whatever block, see the same face;
   * and finds the rest.
   */
  void Prepare();

  std::vector<std::uint8_t> Turned; ///< of each tetrahedron: whether its volume is negative

  /** Of each face, opposite to corner i, the face of another tetrahedron t that it is, as 4 t + i.
   * Where more than two tetrahedra share a face, two of them get each other. */
  std::vector<Tet> Neighbours;

  std::size_t GetMemorySize() const;
};
}

#endif
