// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChunkCache_h
#define gatunChunkCache_h

#include "gatunFileReader.h"
#include "vtkGatunCoreModule.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/** What a ChunkCache has done so far, and holds. */
struct ChunkCacheStatistics
{
  std::uint64_t Bytes = 0;     ///< held now
  std::uint64_t PeakBytes = 0; ///< the most ever held since the budget was set; never more than it

  // Each part that a decoder asked for was decoded from the file or found here.
  std::uint64_t MeshesDecoded = 0; ///< connectivity and coordinates of a chunk
  std::uint64_t MeshesFound = 0;
  std::uint64_t ArraysDecoded = 0; ///< an array of a chunk at one time step
  std::uint64_t ArraysFound = 0;
};

/**
 * Parts of one file that have been decoded: meshes and arrays of chunks, and of the points that
 * chunks share. When they are more than the budget allows, those go that were not used for longest.
 *
 * Give one cache to all PieceDecoders of a file that are to profit from each other, in whatever
 * threads: it is thread safe, and what it hands out never changes. Two threads that want the same
 * part at the same time may both decode it.
 *
 * Memory: every byte of what is held is counted, and never more than the budget is held. What
 * decoders are at work on comes on top, even if it does not fit here.
 */
class VTKGATUNCORE_EXPORT ChunkCache
{
public:
  /** Enough for about ten million tetrahedra with an array or two. */
  static constexpr std::uint64_t DefaultBudget = std::uint64_t{ 512 } << 20;

  /** Budget: in bytes; with 0 nothing is kept. */
  explicit ChunkCache(std::shared_ptr<const FileReader> file, std::uint64_t budget = DefaultBudget);
  ~ChunkCache();
  ChunkCache(const ChunkCache&) = delete;
  ChunkCache& operator=(const ChunkCache&) = delete;

  const std::shared_ptr<const FileReader>& GetFile() const;

  /** Drops what is more than the new budget at once. */
  void SetBudget(std::uint64_t bytes);
  std::uint64_t GetBudget() const;

  /** Whether parts of chunks are kept, or only those of points that chunks share, which one chunk
   * after the other needs. Default: true. False drops those of chunks at once. */
  void SetKeepsChunks(bool keeps);

  ChunkCacheStatistics GetStatistics() const;

  /** Drops everything. */
  void Clear();

  class Internals;

private:
  friend Internals& InternalsOf(ChunkCache& cache);

  std::unique_ptr<Internals> Self;
};
}

#endif
