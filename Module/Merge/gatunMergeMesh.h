// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeMesh_h
#define gatunMergeMesh_h

#include "gatunLargeArray.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * The connectivity of a mesh while its points are merged.
 *
 * A face of only one tetrahedron is on the boundary, and so are its edges and corners.
 */
class MergeMesh
{
public:
  using Tet = std::array<std::uint32_t, 4>;
  static constexpr std::uint32_t None = 0xffffffffu;

  MergeMesh(std::size_t points, std::span<const Tet> tets);

  /** The first corner of a removed tetrahedron is None. */
  const Tet& GetTet(std::uint32_t tet) const { return this->Tets[tet]; }
  std::size_t GetNumberOfTets() const { return this->Tets.size(); }
  std::size_t GetNumberOfPoints() const { return this->Rings.size(); }

  /** Returns the tetrahedra of a point. */
  std::span<const std::uint32_t> GetRing(std::uint32_t point) const
  {
    const Ring& ring = this->Rings[point];
    return { this->Pool.data() + ring.First, ring.Count };
  }

  /** Returns the place of a point among the corners of a tetrahedron, or 4. */
  static unsigned FindCorner(const Tet& tet, std::uint32_t point)
  {
    return tet[0] == point ? 0
      : tet[1] == point    ? 1
      : tet[2] == point    ? 2
      : tet[3] == point    ? 3
                           : 4;
  }

  /** The same for a point that is a corner, without branches. */
  static unsigned FindKnownCorner(const Tet& tet, std::uint32_t point)
  {
    return (tet[1] == point ? 1u : 0u) | (tet[2] == point ? 2u : 0u) | (tet[3] == point ? 3u : 0u);
  }

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

  /** Loads the ring of a point into the cache of the processor, and then its tetrahedra. Mostly
   * they are somewhere else in memory than those of the point before. */
  void PrefetchRing(std::uint32_t point) const
  {
    constexpr std::size_t perLine = 64 / sizeof(std::uint32_t);
    const std::uint32_t* const first = this->Pool.data() + this->Rings[point].First;
    __builtin_prefetch(first);
    __builtin_prefetch(first + perLine);
  }
  void PrefetchTets(std::uint32_t point) const
  {
    for (const auto tet : this->GetRing(point))
    {
      __builtin_prefetch(&this->Tets[tet]);
    }
  }

  /** Bit i: the face opposite to corner i is on the boundary. */
  std::uint8_t GetBoundaryFaces(std::uint32_t tet) const { return this->BoundaryFaces[tet]; }
  bool IsOnBoundary(std::uint32_t point) const { return this->OnBoundary[point] != 0; }

  /** Merges a point into a neighbor. */
  void Merge(std::uint32_t point, std::uint32_t into);

private:
  struct Ring
  {
    std::size_t First = 0;
    std::uint32_t Count = 0;
  };

  void FindBoundary();
  void RemoveFromRing(std::uint32_t point, std::uint32_t tet);
  void PassBoundaryOn(std::uint32_t tet, std::uint32_t point, std::uint32_t into);
  void Compact();

  LargeArray<Tet> Tets;
  std::vector<std::uint8_t> BoundaryFaces;
  std::vector<std::uint8_t> OnBoundary;
  LargeArray<Ring> Rings;
  LargeArray<std::uint32_t> Pool; // of the rings
  std::size_t Used = 0;           // of the pool, by rings

  std::vector<std::uint32_t> Moved; // to the ring of another point
};
}

#endif
