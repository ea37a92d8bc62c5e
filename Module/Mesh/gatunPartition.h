// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartition_h
#define gatunPartition_h

// Partitions a mesh into chunks and finds the points that they share.

#include "gatunLayerPartition.h"
#include "gatunMeshAccess.h"
#include "gatunSharedGroups.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace gatun
{
/** The chunks of a mesh. Indices refer to the input and fit 32 bits. */
struct Partition
{
  std::vector<std::uint32_t> Cells; // chunk by chunk, ascending within a chunk
  std::vector<std::size_t> ChunkStart;

  // The points that no other chunk uses, for each chunk, ascending.
  std::vector<std::vector<std::uint32_t>> OwnPoints;

  // The points that two or more chunks use, for each set of chunks, by Morton code.
  std::map<ChunkGroup, std::vector<std::uint32_t>> SharedPoints;

  std::vector<std::uint32_t> UnusedPoints; // ascending

  std::size_t GetChunkCount() const { return this->ChunkStart.size() - 1; }
};

/** The bounds of the finite coordinates of all points. */
Bounds FindBox(const MeshAccess& mesh);

/** The Morton code of a point within such bounds. */
std::uint64_t FindMortonCode(const MeshAccess& mesh, const Bounds& box, std::uint64_t point);

/** The default limit of tetrahedra per chunk, for a number of tetrahedra. */
std::uint32_t GetDefaultChunkTets(std::uint64_t tets, bool hasLayers);

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
