// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayShare_h
#define gatunRayShare_h

#include "gatunExport.h"
#include "gatunRaySource.h"

#include <cstddef>
#include <memory>

namespace gatun
{
/**
 * The share of one of several processes in the blocks of a common source: every n-th block.
 * Neighboring blocks have neighboring numbers, so that visible blocks are divided evenly, whatever
 * the view. A process has the same blocks in all views, and finds them in its cache.
 */
class GATUN_EXPORT RayShare final : public RaySource
{
public:
  RayShare(std::shared_ptr<RaySource> all, std::size_t process, std::size_t processes);
  ~RayShare() override;

  std::size_t GetNumberOfBlocks() const override;
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;

private:
  std::size_t ToWhole(std::size_t block) const { return this->Process + block * this->Processes; }

  std::shared_ptr<RaySource> All;
  std::size_t Process;
  std::size_t Processes;
};
}

#endif
