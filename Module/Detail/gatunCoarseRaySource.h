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
#include <vector>

namespace gatun
{
class CacheBudget;
class ChunkCache;
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

/** A mesh after the merges of a cut, and which of its tetrahedra are drawn. */
struct CoarsePart
{
  std::shared_ptr<RayChunks> Chunks;
  const MergeTree* Tree; ///< that of the file
  MergeCut Cut;
  CoarseMask Mask;
};

/**
 * The chunks of one or several meshes of a file after the merges of a cut, simplified as they are
 * decoded. If a chunk gets corners from other chunks that have not been decoded yet, these are
 * decoded with it. The points that others need are kept, which takes little memory. The simplified
 * chunks themselves are kept until they are requested, up to 32 MiB and a quarter of the budget.
 * Blocks are kept within the budget. Only chunks that have any tetrahedra that are drawn are
 * blocks.
 */
class GATUN_EXPORT CoarseRaySource final : public RaySource
{
public:
  /** The memory of a source without its blocks, about, for each point of the file. */
  static constexpr std::uint64_t BytesPerPoint = 6;

  /** Takes equal blocks from another source with the same chunks, which may be null. Throws
   * InvalidInput if a cut belongs to another tree. */
  CoarseRaySource(std::vector<CoarsePart> parts, const std::shared_ptr<CacheBudget>& budget,
    const CoarseRaySource* before);

  /** All of a mesh. Keeps blocks within the budget of the cache. Throws InvalidInput if the file
   * has no such array or step, too. */
  CoarseRaySource(std::shared_ptr<ChunkCache> parts, const MergeTree& tree, MergeCut cut,
    const RayValues& values);

  ~CoarseRaySource() override;

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
