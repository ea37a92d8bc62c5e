// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkSurface_h
#define gatunChunkSurface_h

#include "gatunPartDecoder.h"
#include "gatunSurfacePart.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/** The arrays that isosurfaces of chunks need, all at the same step. */
struct ChunkSurfaceArrays
{
  std::uint32_t Scalars = 0;            ///< the point array of the isovalues
  int Component = -1;                   ///< of that array; -1: the length of the tuples
  std::vector<std::uint32_t> Carried{}; ///< arrays to interpolate, ascending
  std::size_t Step = 0;
};

/**
 * Decodes chunks and extracts isosurfaces of each. The surface is made from the decoded chunk where
 * it is; its mesh is not copied.
 *
 * Thread safe. Memory: a decoded chunk for each thread, and the cache.
 */
class ChunkSurface
{
public:
  ChunkSurface(const std::shared_ptr<ChunkCache>& cache, ChunkSurfaceArrays arrays);

  /** Removes shared points from the cache as soon as none of these chunks needs them, of all calls.
   * Each chunk may then be requested once. */
  void RemoveUsedBlocks(std::span<const std::uint32_t> chunks);

  SurfacePart Make(std::uint32_t chunk, const SurfaceOptions& options);

private:
  struct Values;

  std::shared_ptr<const ChunkMesh> GetMesh(std::uint32_t chunk) const;
  std::shared_ptr<const ArrayPart> GetArray(
    std::uint32_t chunk, const ChunkMesh& mesh, std::uint32_t array) const;
  std::shared_ptr<const ArrayPart> GetBlockArray(
    std::uint32_t block, std::uint32_t array, std::size_t step) const;
  Values GetValues(std::uint32_t chunk, const ChunkMesh& mesh, std::uint32_t array) const;
  void Release(std::uint32_t chunk);

  const std::shared_ptr<ChunkCache> Cache;
  const PartDecoder Parts;
  const ChunkSurfaceArrays Arrays;

  // For each block the number of chunks that still need it, if blocks are removed.
  std::vector<std::atomic<std::uint32_t>> Users;
};
}

#endif
