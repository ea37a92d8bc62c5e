// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeMesh_h
#define gatunMergeMesh_h

#include "gatunMergeRings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * The connectivity of a tetrahedral mesh while its points are merged.
 *
 * A face of only one tetrahedron is on the boundary, and so are its edges and corners.
 */
class MergeMesh : public MergeRings<4>
{
public:
  using Tet = Cell;

  MergeMesh(std::size_t points, std::span<const Tet> tets);

  /** The first corner of a removed tetrahedron is None. */
  const Tet& GetTet(std::uint32_t tet) const { return this->GetCell(tet); }
  std::size_t GetNumberOfTets() const { return this->GetNumberOfCells(); }

  /** Returns the places of the two corners of a tetrahedron besides two others. */
  static std::array<unsigned, 2> FindOthers(unsigned at, unsigned other)
  {
    std::array<unsigned, 2> rest{};
    unsigned n = 0;
    for (unsigned i = 0; i < 4; ++i)
    {
      if (i != at && i != other)
      {
        rest[n++] = i;
      }
    }
    return rest;
  }

  /** Bit i: the face opposite to corner i is on the boundary. */
  std::uint8_t GetBoundaryFaces(std::uint32_t tet) const { return this->BoundaryFaces[tet]; }
  bool IsOnBoundary(std::uint32_t point) const { return this->OnBoundary[point] != 0; }

  /** Merges a point into a neighbor. */
  void Merge(std::uint32_t point, std::uint32_t into);

private:
  void FindBoundary();
  void PassBoundaryOn(std::uint32_t tet, std::uint32_t point, std::uint32_t into);

  std::vector<std::uint8_t> BoundaryFaces;
  std::vector<std::uint8_t> OnBoundary;
};
}

#endif
