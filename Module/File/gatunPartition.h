// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunPartition_h
#define gatunPartition_h

// Cuts a mesh into chunks and finds the points that they share.

#include "gatunLayerPartition.h"
#include "gatunMeshAccess.h"
#include "gatunTables.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/** A mesh cut into chunks. Indices are those of the input; they fit 32 bits. */
struct Partition
{
  static constexpr std::uint32_t Unused = 0xffffffffu;

  std::vector<std::uint32_t> Tets; // all, chunk by chunk, ascending within a chunk
  std::vector<std::size_t> ChunkStart;

  // The points used by several chunks, in the order of the file: blocks, groups, Morton order.
  std::vector<std::uint32_t> SharedPoints;
  std::vector<BlockEntry> Blocks; // groups and counts only

  std::vector<std::uint32_t> UnusedPoints;

  // Of each point: its place in SharedPoints, or OwnPoint, or UnusedPoint.
  static constexpr std::uint32_t OwnPoint = 0xfffffffeu;
  std::vector<std::uint32_t> SharedIndex;

  std::size_t GetChunkCount() const { return this->ChunkStart.size() - 1; }
};

/**
 * Halves the tetrahedra along the longest axis of their centroids until no part has more than
 * chunkTets; with layers, those of each bucket of layers by themselves. The same result for any
 * number of threads. Throws InvalidInput if a tetrahedron names a point that is not there.
 */
Partition MakePartition(const MeshAccess& mesh, std::uint32_t chunkTets,
  const std::function<bool(double)>& progress, LayerPartition* layers = nullptr);
}

#endif
