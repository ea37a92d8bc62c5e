// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileSurface_h
#define gatunFileSurface_h

#include "gatunChunkCache.h"
#include "gatunExport.h"
#include "gatunFileReader.h"
#include "gatunIntervalTree.h"
#include "gatunMergeTree.h"
#include "gatunSurface.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace gatun
{
class ChunkSurface;
class CoarseLayout;

/** A request for isosurfaces of a file. */
struct FileSurfaceRequest
{
  SurfaceOptions Options;
  std::uint32_t Array = 0; ///< the point array of the isovalues: index into GetArrays()
  int Component = -1;      ///< of that array; -1: the length of the tuples
  std::size_t Step = 0;
  std::vector<std::uint32_t> Arrays; ///< arrays to interpolate: indices, ascending

  /** If the surface passes through K chunks, piece p of n consists of numbers p K / n to
   * (p + 1) K / n - 1 of these. Normals are those of the whole surface. */
  unsigned Piece = 0;
  unsigned Pieces = 1;
};

struct FileSurfaceStatistics
{
  std::size_t Chunks = 0; ///< decoded chunks
  std::uint64_t Tets = 0; ///< in these chunks
};

/**
 * Isosurfaces of a file. Decodes only the chunks whose ranges of values contain an isovalue, one
 * after the other. Keeps decoded chunks in a cache for the next isovalues.
 *
 * With merges, the isosurfaces are those of the simplified mesh.
 *
 * Memory: the surface, the cache, a chunk for each thread and the shared points that remaining
 * chunks need; with merges, the simplified chunks of about two million tetrahedra. Not thread safe;
 * uses all threads.
 */
class GATUN_EXPORT FileSurface
{
public:
  using Progress = std::function<bool(double)>;

  /** Cache: see SetCacheBudget. Tree: null without merges. */
  explicit FileSurface(std::shared_ptr<const FileReader> file, std::uint64_t cacheBudget = 0,
    std::shared_ptr<const MergeTree> tree = nullptr, std::size_t merges = 0);

  /** Uses a shared cache, whose owner sets its budget and contents. If the budget is too small for
   * the parts that one chunk after the other needs, up to 32 MiB (64 MiB with merges) are kept in
   * addition while a surface is extracted. */
  explicit FileSurface(std::shared_ptr<ChunkCache> cache,
    std::shared_ptr<const MergeTree> tree = nullptr, std::size_t merges = 0);

  ~FileSurface();
  FileSurface(const FileSurface&) = delete;
  FileSurface& operator=(const FileSurface&) = delete;

  const std::shared_ptr<const FileReader>& GetFile() const { return this->Cache->GetFile(); }

  /** Sets the number of bytes of decoded chunks that the cache keeps for the next isovalues. */
  void SetCacheBudget(std::uint64_t bytes);

  /** Returns the chunks that the surfaces pass through, ascending. */
  std::vector<std::uint32_t> FindChunks(const FileSurfaceRequest& request);

  /** Throws Error for an invalid request, a damaged file, and if progress returns false. */
  Surface Extract(const FileSurfaceRequest& request, const Progress& progress = {});

  /** Statistics of the last call of Extract. */
  const FileSurfaceStatistics& GetStatistics() const { return this->Statistics; }

private:
  struct Mesh;

  /** The parameters of a tree of ranges. */
  struct TreeKey
  {
    std::uint32_t Array = 0;
    int Component = 0;
    std::size_t Step = 0;
    bool operator==(const TreeKey&) const = default;
  };

  class WorkingCache;

  std::uint64_t GetLeastCache() const;
  void Check(const FileSurfaceRequest& request) const;
  const IntervalTree& GetRanges(const FileSurfaceRequest& request);
  bool Touch(std::uint32_t a, std::uint32_t b, std::size_t step) const;
  Bounds GetBounds(std::uint32_t chunk, std::size_t step) const;
  void Fetch(std::vector<std::uint32_t> chunks, const FileSurfaceRequest& request) const;
  Mesh DecodeCoarse(std::vector<std::uint32_t> chunks, const FileSurfaceRequest& request) const;
  static std::vector<SurfacePart> MakeParts(ChunkSurface& maker,
    const std::vector<std::uint32_t>& chunks, const SurfaceOptions& options,
    const Progress& progress);
  std::vector<SurfacePart> MakeCoarseParts(const std::vector<std::uint32_t>& chunks,
    const FileSurfaceRequest& request, const Progress& progress) const;

  std::shared_ptr<ChunkCache> Cache;
  std::shared_ptr<const CoarseLayout> Layout; // with merges
  bool KeepsBlocks = true;                    // shared points, for the next isovalues
  std::optional<std::pair<TreeKey, IntervalTree>> Ranges;
  FileSurfaceStatistics Statistics;
};
}

#endif
