// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeMesh_h
#define gatunMergeMesh_h

#include "gatunLocalIndex.h"

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
 * A face of only one tetrahedron is on the boundary, and so are its edges and corners. Links are
 * those of the mesh with one more point outside, which forms a tetrahedron with each boundary face.
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
  std::span<const std::uint32_t> GetRing(std::uint32_t point);

  /** Bit i: the face opposite to corner i is on the boundary. */
  std::uint8_t GetBoundaryFaces(std::uint32_t tet) const { return this->BoundaryFaces[tet]; }
  bool IsOnBoundary(std::uint32_t point) const { return this->OnBoundary[point] != 0; }

  /**
   * Whether merging a point into a neighbor preserves the topology: the intersection of the links
   * of the two points must be the link of their edge (Dey, Edelsbrunner, Guha, Nekhayev: Topology
   * preserving edge contraction, 1999).
   */
  bool MayMerge(std::uint32_t point, std::uint32_t into);

  /** Merges a point into a neighbor. */
  void Merge(std::uint32_t point, std::uint32_t into);

private:
  struct Ring
  {
    std::size_t First = 0;
    std::uint32_t Count = 0;
    bool HasGone = false; // whether it lists removed tetrahedra
  };

  void FindBoundary();
  void MarkNeighbors(std::uint32_t point, std::uint8_t neighbor, std::uint8_t boundaryNeighbor);
  void MarkEdge(std::uint32_t point, std::uint32_t into);
  bool ShareNoOtherPoint(std::uint32_t point, std::uint32_t into, bool edgeOnBoundary);
  bool ShareNoOtherTriangle(std::uint32_t point, std::uint32_t into);
  bool ShareBoundaryFace(std::uint32_t point, std::uint32_t into);
  bool IsInEdgeLink(std::uint32_t a, std::uint32_t b) const;
  bool HaveTet(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  bool HasTet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  bool IsBoundaryFace(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void PassBoundaryOn(std::uint32_t tet, std::uint32_t point, std::uint32_t into);
  void Compact();

  std::vector<Tet> Tets;
  std::vector<std::uint8_t> BoundaryFaces;
  std::vector<std::uint8_t> OnBoundary;
  std::vector<Ring> Rings;
  std::vector<std::uint32_t> Pool; // of the rings
  std::size_t Used = 0;            // of the pool, by rings

  LocalIndex Marks;                                   // of the points around the two current ones
  std::vector<std::array<std::uint32_t, 2>> EdgeLink; // forms a tetrahedron with both
  std::vector<std::uint32_t> Moved;                   // to the ring of another point
};
}

#endif
