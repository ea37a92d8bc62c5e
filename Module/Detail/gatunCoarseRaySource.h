// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunCoarseRaySource_h
#define gatunCoarseRaySource_h

#include "gatunExport.h"
#include "gatunMergeCut.h"
#include "gatunMergeTree.h"
#include "gatunRaySource.h"
#include "gatunRayValues.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace gatun
{
class CacheBudget;
class ChunkCache;
class FileReader;
class RayChunks;

/**
 * Selects the tetrahedra of a base mesh in a mesh of several base meshes: no corner is too coarse,
 * and any corner is too coarse in the next base mesh. One element for each point of the base mesh,
 * before the merges of the cut.
 */
struct CoarseMask
{
  std::vector<bool> TooCoarse;     ///< empty: none
  std::vector<bool> NextTooCoarse; ///< empty: all
};

/**
 * The chunks of a file after the merges of a cut, simplified as they are decoded. If a chunk
 * gets corners from other chunks that have not been decoded yet, these are decoded with it. The
 * points that others need are kept, which takes little memory. The simplified chunks themselves are
 * kept until they are requested, up to 32 MiB and a quarter of the budget. Blocks are kept within
 * the budget.
 */
class GATUN_EXPORT CoarseRaySource final : public RaySource
{
public:
  /** The memory of a source without its blocks, about, for each point of the file. */
  static constexpr std::uint64_t BytesPerPoint = 6;

  /** Tree: that of the file. Budget: in bytes. Throws InvalidInput if the file has no such array or
   * step, or the cut belongs to another tree. */
  CoarseRaySource(std::shared_ptr<const FileReader> file, const MergeTree& tree, MergeCut cut,
    const RayValues& values, std::uint64_t budget);

  /** Uses a shared cache, and keeps blocks within the same budget. */
  CoarseRaySource(std::shared_ptr<ChunkCache> parts, const MergeTree& tree, MergeCut cut,
    const RayValues& values);

  /** Takes equal blocks from another source of the same chunks, which may be null. With a mask,
   * only chunks that have any of its tetrahedra are blocks. */
  CoarseRaySource(std::shared_ptr<RayChunks> chunks, std::shared_ptr<CacheBudget> budget,
    const MergeTree& tree, MergeCut cut, CoarseMask mask, const CoarseRaySource* other);

  ~CoarseRaySource() override;

  /** The chunk of a block in the file. */
  std::uint32_t GetChunk(std::size_t block) const;

  std::size_t GetNumberOfBlocks() const override;
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;
  double GetSimplifyTime() const override;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
