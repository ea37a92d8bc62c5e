// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBoundaryMesh_h
#define gatunBoundaryMesh_h

#include "gatunBoundaryFaces.h"
#include "gatunBytes.h"
#include "gatunMergeTree.h"
#include "gatunMeshAccess.h"
#include "gatunPartition.h"
#include "gatunWriterOptions.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** The options of the file of a boundary. whole: those of the whole file. tree: of the boundary, or
 * null. */
WriterOptions MakeBoundaryOptions(const WriterOptions& whole, const MergeTree* tree);

/** The faces of all chunks of a mesh, or of a part of it, that may be on its boundary.
 *
 * numberOf, isShared: see FindOpenFaces, with the chunks in place of the cells. */
std::vector<BoundaryFace> FindFacesOfChunks(const MeshAccess& mesh, const Partition& layout,
  const std::function<std::uint32_t(std::uint32_t)>& numberOf,
  const std::function<bool(std::uint32_t)>& isShared);

/** The cells of a boundary with the points of the mesh. */
struct BoundaryCells
{
  std::vector<std::uint8_t> Types;
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<std::int64_t> Connectivity;
  std::vector<std::uint32_t> Cells; ///< that each of them is, or is a face of

  /** Those of one list of a surface must follow each other. */
  void Add(SurfaceList list, std::uint32_t cell, std::span<const std::uint32_t> corners);
};

/** The boundary of a mesh (gatunBoundaryFaces.h) as a surface of its own. */
class BoundaryMesh
{
public:
  /** layout: the chunks of the mesh. Uses all threads. */
  BoundaryMesh(const MeshAccess& mesh, const Partition& layout);

  /** points: the number of those of the mesh. getCoordinates: of some of them. */
  BoundaryMesh(BoundaryCells cells, std::uint64_t points, ScalarType type,
    const std::function<Bytes(std::span<const std::uint32_t>)>& getCoordinates);

  /** Vertices, lines, polygons and strips, in this order. Valid during the lifetime of this object.
   */
  MeshInput GetInput() const;

  /** The merges of the mesh that simplify the boundary, in its own numbers: those of its points.
   * Nothing if it has cells other than triangles, vertices and lines, or if one of its points is
   * merged into another one that is not there. */
  std::optional<MergeTree> MakeTree(const MergeTree& whole) const;

  /** The tuples of the points of the boundary, or of the cell of each of its faces. */
  Bytes Gather(const void* values, Association where, std::size_t tupleBytes) const;

  /** The points, and the cell of each cell, in the mesh. */
  const std::vector<std::uint32_t>& GetPoints() const { return this->Points; }
  const std::vector<std::uint32_t>& GetCells() const { return this->Faces.Cells; }

private:
  void AddCells(const MeshAccess& mesh, std::vector<BoundaryFace> faces);
  void AddPoints(std::uint64_t points);

  std::vector<std::uint32_t> Points; // numbers in the whole mesh
  ScalarType CoordinateType;
  Bytes Coordinates;
  BoundaryCells Faces; // with places among the points, once these are there
};
}

#endif
