// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkCache_h
#define gatunChunkCache_h

#include "gatunCacheBudget.h"
#include "gatunExport.h"
#include "gatunFileReader.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/** The contents and the work of a ChunkCache. */
struct ChunkCacheStatistics
{
  std::uint64_t Bytes = 0;     ///< held now
  std::uint64_t PeakBytes = 0; ///< maximum since the budget was set; never more than the budget

  // Each part that a decoder needs is either decoded from the file or found in the cache.
  std::uint64_t MeshesDecoded = 0; ///< connectivity and coordinates of a chunk
  std::uint64_t MeshesFound = 0;
  std::uint64_t ArraysDecoded = 0; ///< an array of a chunk at one time step
  std::uint64_t ArraysFound = 0;
};

/**
 * Decoded parts of one file: meshes and arrays of chunks and of shared points. When the parts
 * exceed the budget, the least recently used ones are removed.
 *
 * PieceDecoders of a file that use the same cache share their work. They may run in any thread: the
 * cache is thread safe, and parts never change. Two threads that need the same part at the same
 * time may both decode it.
 *
 * Memory: the cache counts every byte of its parts and never holds more than the budget. Parts in
 * use by decoders come in addition, even if they do not fit into the cache.
 */
class GATUN_EXPORT ChunkCache
{
public:
  /** Enough for about ten million tetrahedra with one or two arrays. */
  static constexpr std::uint64_t DefaultBudget = std::uint64_t{ 512 } << 20;

  /** Budget: in bytes; with 0 nothing is kept. */
  explicit ChunkCache(std::shared_ptr<const FileReader> file, std::uint64_t budget = DefaultBudget);

  /** A cache that shares a budget with others. */
  ChunkCache(std::shared_ptr<const FileReader> file, std::shared_ptr<CacheBudget> budget);

  /** A view of another cache, with statistics of its own: the other cache holds the parts, and
   * counts them, too. A view that does not keep chunks finds the chunks of others. */
  ChunkCache(const std::shared_ptr<ChunkCache>& other, bool keepsChunks);

  /** A view for a mesh with some of the cells of the file (FileReader::GetParentMesh). */
  ChunkCache(const ChunkCache& other, std::shared_ptr<const FileReader> file);
  ~ChunkCache();
  ChunkCache(const ChunkCache&) = delete;
  ChunkCache& operator=(const ChunkCache&) = delete;

  const std::shared_ptr<const FileReader>& GetFile() const;

  const std::shared_ptr<CacheBudget>& GetSharedBudget() const;

  /** Sets the bytes of the budget, also for all caches that share it. Parts that do not fit are
   * removed at once. */
  void SetBudget(std::uint64_t bytes);
  std::uint64_t GetBudget() const;

  /** Whether to keep parts of chunks, or only those of shared points, which each chunk needs again.
   * Default: true. False removes the parts of chunks at once, except in a view. */
  void SetKeepsChunks(bool keeps);

  ChunkCacheStatistics GetStatistics() const;

  /** Removes all parts. */
  void Clear();

  class Internals;

private:
  friend Internals& InternalsOf(ChunkCache& cache);

  std::unique_ptr<Internals> Self;
};
}

#endif
