// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBoundaryMesh_h
#define gatunBoundaryMesh_h

#include "gatunBoundaryFaces.h"
#include "gatunBytes.h"
#include "gatunMergeTree.h"
#include "gatunMeshAccess.h"
#include "gatunPartition.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gatun
{
/** The boundary of a mesh (gatunBoundaryFaces.h) as a surface of its own. */
class BoundaryMesh
{
public:
  /** layout: the chunks of the mesh. Uses all threads. */
  BoundaryMesh(const MeshAccess& mesh, const Partition& layout);

  /** Vertices, lines, polygons and strips, in this order. Valid during the lifetime of this object.
   */
  MeshInput GetInput() const;

  /** The merges of the mesh that simplify the boundary, in its own numbers: those of its points.
   * Nothing if it has cells other than triangles, vertices and lines, or if one of its points is
   * merged into another one that is not there. */
  std::optional<MergeTree> MakeTree(const MergeTree& whole) const;

  /** The tuples of the points of the boundary, or of the cell of each of its faces. */
  Bytes Gather(const void* values, Association where, std::size_t tupleBytes) const;

private:
  void AddCells(const MeshAccess& mesh, std::vector<BoundaryFace> faces);
  void AddPoints(const MeshAccess& mesh);

  std::vector<std::uint32_t> Points; // numbers in the whole mesh
  std::vector<std::uint32_t> Cells;  // that of each face
  ScalarType CoordinateType;
  Bytes Coordinates;
  std::vector<std::uint8_t> Types;
  std::vector<std::int64_t> Offsets;
  std::vector<std::int64_t> Connectivity;
};
}

#endif
