// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunJoinedRaySource_h
#define gatunJoinedRaySource_h

#include "gatunRaySource.h"

#include <memory>
#include <utility>
#include <vector>

namespace gatun
{
/** The blocks of several sources, one source after the other. */
class JoinedRaySource final : public RaySource
{
public:
  explicit JoinedRaySource(std::vector<std::shared_ptr<RaySource>> sources);

  std::size_t GetNumberOfBlocks() const override { return this->Places.size(); }
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;
  double GetSimplifyTime() const override;

private:
  std::vector<std::shared_ptr<RaySource>> Sources;
  std::vector<std::pair<std::size_t, std::size_t>> Places; // source and its block
};
}

#endif
