// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunBaseMesh_h
#define gatunBaseMesh_h

#include "gatunBytes.h"
#include "gatunMergeTree.h"
#include "gatunPartition.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** What is left of a mesh after so many merges, as a mesh of its own. */
class BaseMesh
{
public:
  BaseMesh(const MeshAccess& mesh, const MergeTree& tree, std::size_t merges);

  /** Valid for as long as this is. */
  MeshInput GetInput() const;

  /** The merges that follow, in the numbers of the points that are left. */
  const MergeTree& GetTree() const { return this->Tree; }

  /** The tuples, of so many bytes, of the points or tetrahedra that are left. */
  Bytes Gather(const void* values, Association where, std::size_t tupleBytes) const;

private:
  std::vector<std::uint32_t> Points; // of the whole mesh
  std::vector<std::uint32_t> Tets;
  ScalarType CoordinateType;
  Bytes Coordinates;
  bool WideIds;
  std::vector<std::int64_t> WideConnectivity;
  std::vector<std::int32_t> Connectivity;
  MergeTree Tree;
};
}

#endif
