// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartition_h
#define gatunPartition_h

// Partitions a mesh into chunks and finds the points that they share.

#include "gatunLayerPartition.h"
#include "gatunMeshAccess.h"
#include "gatunTables.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/** The chunks of a mesh. Indices refer to the input and fit 32 bits. */
struct Partition
{
  static constexpr std::uint32_t Unused = 0xffffffffu;

  std::vector<std::uint32_t> Cells; // chunk by chunk, ascending within a chunk
  std::vector<std::size_t> ChunkStart;

  // The shared points in the order of the file: by block, group and Morton code.
  std::vector<std::uint32_t> SharedPoints;
  std::vector<BlockEntry> Blocks; // groups and counts only

  // The points that no other chunk uses, for each chunk, ascending.
  std::vector<std::vector<std::uint32_t>> OwnPoints;

  std::vector<std::uint32_t> UnusedPoints;

  // For each point, its position in SharedPoints, or OwnPoint, or Unused.
  static constexpr std::uint32_t OwnPoint = 0xfffffffeu;
  std::vector<std::uint32_t> SharedIndex;

  std::size_t GetChunkCount() const { return this->ChunkStart.size() - 1; }
};

/**
 * Halves the cells along the longest axis of the means of their points until no part has more than
 * about chunkTets tetrahedra, whatever the cells are. With layers, each bucket of layers is halved
 * separately, and so are tetrahedra and other cells where that pays. The result does not depend on
 * the number of threads. Throws Error(InvalidInput) as CheckCells does.
 */
Partition MakePartition(const MeshAccess& mesh, std::uint32_t chunkTets,
  const std::function<bool(double)>& progress, LayerPartition* layers = nullptr);
}

#endif
