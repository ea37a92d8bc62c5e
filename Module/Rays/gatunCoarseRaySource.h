// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunCoarseRaySource_h
#define gatunCoarseRaySource_h

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
 * The chunks of a file after so many merges, simplified as they are decoded. Where a chunk gets
 * corners from others, these are decoded with it, unless they have been before: what others need of
 * them is kept, which is little, and what is left of them waits until it is asked for, up to 32 MiB
 * and a quarter of the budget. Blocks that have been made are kept up to a number of bytes.
 */
class VTKGATUNCORE_EXPORT CoarseRaySource final : public RaySource
{
public:
  /** Tree: the file's. Throws InvalidInput if the file has no such array or step, or not so many
   * merges. */
  CoarseRaySource(std::shared_ptr<const FileReader> file, const MergeTree& tree, std::size_t merges,
    const RayValues& values, std::uint64_t budget);

  /** Uses a cache that others use, too, and keeps blocks within the same budget. */
  CoarseRaySource(std::shared_ptr<ChunkCache> parts, const MergeTree& tree, std::size_t merges,
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
