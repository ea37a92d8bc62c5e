// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayBlock_h
#define gatunRayBlock_h

#include "gatunExport.h"
#include "gatunTypes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A point of a mesh with its value. Tetrahedra with a point whose value is NaN are invisible. */
struct alignas(32) RayPoint
{
  double X, Y, Z, Value;
};

/** Tetrahedra that are drawn together; some ten thousand are best for speed. */
struct GATUN_EXPORT RayBlock
{
  using Tet = std::array<std::uint32_t, 4>;
  static constexpr std::uint32_t NoNeighbor = 0xffffffffu;

  std::vector<RayPoint> Points;
  std::vector<Tet> Tets;          ///< point indices
  std::vector<double> CellValues; ///< if not empty: values of the tetrahedra, used instead

  /** If not empty: for each tetrahedron an earlier one with which it shares the face opposite to
   * its last corner, or NoNeighbor. Prepare is faster with these hints, which may be wrong, and
   * removes them. */
  std::vector<std::uint32_t> Parents;

  /** Sets the value of each point or tetrahedron i to getValue(i). */
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
   * Prepares the block for drawing, once for all views. Sorts the corners of each tetrahedron by
   * their coordinates, so that tetrahedra of any block get exactly the same plane for a face that
   * they share, and computes the members below.
   */
  void Prepare();

  std::vector<std::uint8_t> Turned; ///< for each tetrahedron: whether its volume is negative

  /** For each face, opposite to corner i: the same face of its neighbor, tetrahedron t, as
   * 4 t + i. If more than two tetrahedra share a face, two of them become neighbors. */
  std::vector<Tet> Neighbors;

  std::size_t GetMemorySize() const;
};
}

#endif
