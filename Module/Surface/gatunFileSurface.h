// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileSurface_h
#define gatunFileSurface_h

#include "gatunChunkCache.h"
#include "gatunFileReader.h"
#include "gatunIntervalTree.h"
#include "gatunMergeTree.h"
#include "gatunSurface.h"
#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace gatun
{
class CoarseLayout;

/** Which isosurfaces of a file are wanted. */
struct FileSurfaceRequest
{
  SurfaceOptions Options;
  std::uint32_t Array = 0; ///< a point array, that of the isovalues: index into GetArrays()
  int Component = -1;      ///< of it; -1: the length of the tuples
  std::size_t Step = 0;
  std::vector<std::uint32_t> Arrays; ///< to be carried along: indices, ascending

  /** Of the chunks that the surface passes through, piece p of n has those from number p K / n to
   * (p + 1) K / n - 1. Normals are those of the whole surface. */
  unsigned Piece = 0;
  unsigned Pieces = 1;
};

struct FileSurfaceStatistics
{
  std::size_t Chunks = 0; ///< decoded
  std::uint64_t Tets = 0; ///< in these
};

/**
 * Isosurfaces of a file: only the chunks that they pass through are decoded, as the ranges of their
 * values tell, each when its turn comes. Keeps what it has decoded in a cache, for the next values.
 *
 * After merges: isosurfaces of the simplified mesh.
 *
 * Memory: the surface, the cache, a chunk for each thread and, up to 32 MiB, points that chunks
 * share; with merges, what is left of the chunks of about two million tetrahedra. Not thread safe;
 * uses all threads of vtkSMPTools.
 */
class VTKGATUNCORE_EXPORT FileSurface
{
public:
  using Progress = std::function<bool(double)>;

  /** Cache: see SetCacheBudget. Tree: null without merges. */
  explicit FileSurface(std::shared_ptr<const FileReader> file, std::uint64_t cacheBudget = 0,
    std::shared_ptr<const MergeTree> tree = nullptr, std::size_t merges = 0);

  /** Uses a cache that others use, too. Its owner sets its budget and what it keeps. */
  explicit FileSurface(std::shared_ptr<ChunkCache> cache,
    std::shared_ptr<const MergeTree> tree = nullptr, std::size_t merges = 0);

  ~FileSurface();
  FileSurface(const FileSurface&) = delete;
  FileSurface& operator=(const FileSurface&) = delete;

  const std::shared_ptr<const FileReader>& GetFile() const { return this->Cache->GetFile(); }

  /** Sets the number of bytes of decoded chunks that the cache keeps for the next isovalues. */
  void SetCacheBudget(std::uint64_t bytes);

  /** The chunks that surfaces of the values pass through, ascending. */
  std::vector<std::uint32_t> FindChunks(const FileSurfaceRequest& request);

  /** Throws Error: a request that makes no sense, a damaged file, Aborted. */
  Surface Extract(const FileSurfaceRequest& request, const Progress& progress = {});

  /** Of what was extracted last. */
  const FileSurfaceStatistics& GetStatistics() const { return this->Statistics; }

private:
  struct Mesh;

  /** What a tree of ranges was made for. */
  struct TreeKey
  {
    std::uint32_t Array = 0;
    int Component = 0;
    std::size_t Step = 0;
    bool operator==(const TreeKey&) const = default;
  };

  void Check(const FileSurfaceRequest& request) const;
  const IntervalTree& GetRanges(const FileSurfaceRequest& request);
  bool Touch(std::uint32_t a, std::uint32_t b) const;
  const Bounds& GetBounds(std::uint32_t chunk) const;
  Mesh Decode(std::vector<std::uint32_t> chunks, const FileSurfaceRequest& request) const;
  std::vector<SurfacePart> MakeParts(const std::vector<std::uint32_t>& chunks,
    const FileSurfaceRequest& request, const Progress& progress) const;
  std::vector<SurfacePart> MakeCoarseParts(const std::vector<std::uint32_t>& chunks,
    const FileSurfaceRequest& request, const Progress& progress) const;

  std::shared_ptr<ChunkCache> Cache;
  std::shared_ptr<const CoarseLayout> Layout; // with merges
  std::optional<std::pair<TreeKey, IntervalTree>> Ranges;
  FileSurfaceStatistics Statistics;
};
}

#endif
