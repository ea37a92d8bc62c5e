// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeLinks_h
#define gatunMergeLinks_h

#include "gatunMergeMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * Whether merges preserve the topology. Links include one more point outside, which forms a
 * tetrahedron with each boundary face.
 */
class MergeLinks
{
public:
  explicit MergeLinks(const MergeMesh& mesh)
    : Mesh(mesh)
    , Marks(mesh.GetNumberOfPoints(), 0)
  {
  }

  /**
   * Whether merging a point into a neighbor preserves the topology: the intersection of the links
   * of the two points must be the link of their edge (Dey, Edelsbrunner, Guha, Nekhayev: Topology
   * preserving edge contraction, 1999).
   */
  bool MayMerge(std::uint32_t point, std::uint32_t into);

private:
  void Mark(std::uint32_t point, unsigned marks);
  void MarkNeighbors(std::uint32_t point, unsigned neighbor);
  void MarkBoundary(std::uint32_t point, unsigned boundaryNeighbor);
  void MarkEdge(std::uint32_t point, std::uint32_t into);
  bool ShareNoOthers(std::uint32_t point, std::uint32_t into) const;
  bool ShareTriangle(const MergeMesh::Tet& corners, std::uint32_t into) const;
  bool ShareBoundaryFace(std::uint32_t point, std::uint32_t into) const;
  bool IsInEdgeLink(std::uint32_t a, std::uint32_t b) const;
  bool HaveTet(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  bool HasTet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  bool IsBoundaryFace(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  const MergeMesh& Mesh;
  std::vector<std::uint8_t> Marks;                    // of each point; 0 if it is not near
  std::vector<std::uint32_t> Marked;                  // around the two current ones
  std::vector<std::array<std::uint32_t, 2>> EdgeLink; // forms a tetrahedron with both
};
}

#endif
