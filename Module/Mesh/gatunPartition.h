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
#include <span>
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

  /** The cells of a chunk. */
  std::span<const std::uint32_t> GetCells(std::size_t chunk) const
  {
    const auto first = this->ChunkStart[chunk];
    return std::span(this->Cells).subspan(first, this->ChunkStart[chunk + 1] - first);
  }
};

/** The bounds of the finite coordinates of all points. */
Bounds FindBox(const MeshAccess& mesh);

/** The Morton code of a point within such bounds. */
std::uint64_t FindMortonCode(const MeshAccess& mesh, const Bounds& box, std::uint64_t point);

/** What chunks may have at most. */
struct ChunkLimits
{
  std::uint32_t Size; ///< tetrahedra, about, whatever the cells are; with a limit of points, cells
  std::uint32_t Points = 0; ///< unless it is 0; cells with more of them are chunks of their own
};

/** The default limit of tetrahedra or cells per chunk, for a number of them. */
std::uint32_t GetDefaultChunkSize(std::uint64_t number, bool hasLayers);

/**
 * Halves the cells along the longest axis of the means of their points until no part exceeds the
 * limits. With layers, each bucket of layers is halved separately, and so are tetrahedra and other
 * cells where that pays. The result does not depend on the number of threads. Throws
 * Error(InvalidInput) as CheckCells does.
 */
Partition MakePartition(const MeshAccess& mesh, const ChunkLimits& limits,
  const std::function<bool(double)>& progress, LayerPartition* layers = nullptr);
}

#endif
