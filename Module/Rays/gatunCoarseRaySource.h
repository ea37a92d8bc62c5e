// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunCoarseRaySource_h
#define gatunCoarseRaySource_h

#include "gatunMergeCut.h"
#include "gatunMergeTree.h"
#include "gatunRaySource.h"
#include "gatunRayValues.h"
#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace gatun
{
class ChunkCache;
class FileReader;

/**
 * The chunks of a file after the merges of a cut, simplified as they are decoded. If a chunk
 * gets corners from other chunks that have not been decoded yet, these are decoded with it. The
 * points that others need are kept, which takes little memory. The simplified chunks themselves are
 * kept until they are requested, up to 32 MiB and a quarter of the budget. Blocks are kept within
 * the budget.
 */
class VTKGATUNCORE_EXPORT CoarseRaySource final : public RaySource
{
public:
  /** Tree: that of the file. Budget: in bytes. Throws InvalidInput if the file has no such array or
   * step, or the cut belongs to another tree. */
  CoarseRaySource(std::shared_ptr<const FileReader> file, const MergeTree& tree, MergeCut cut,
    const RayValues& values, std::uint64_t budget);

  /** Uses a cache that others use, too, and keeps blocks within the same budget. */
  CoarseRaySource(std::shared_ptr<ChunkCache> parts, const MergeTree& tree, MergeCut cut,
    const RayValues& values);

  ~CoarseRaySource() override;

  std::size_t GetNumberOfBlocks() const override;
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
