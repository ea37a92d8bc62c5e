// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayShare.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace gatun
{
//------------------------------------------------------------------------------
RayShare::RayShare(std::shared_ptr<RaySource> all, std::size_t process, std::size_t processes)
  : All(std::move(all))
  , Process(process)
  , Processes(processes)
{
}

RayShare::~RayShare() = default;

//------------------------------------------------------------------------------
std::size_t RayShare::GetNumberOfBlocks() const
{
  const std::size_t all = this->All->GetNumberOfBlocks();
  return all / this->Processes + (this->Process < all % this->Processes ? 1 : 0);
}

//------------------------------------------------------------------------------
const Bounds& RayShare::GetBounds(std::size_t block) const
{
  return this->All->GetBounds(this->ToWhole(block));
}

//------------------------------------------------------------------------------
Range RayShare::GetRange(std::size_t block) const
{
  return this->All->GetRange(this->ToWhole(block));
}

//------------------------------------------------------------------------------
RaySource::Blocks RayShare::GetBlocks(std::span<const std::size_t> blocks, const Progress& progress)
{
  std::vector<std::size_t> ofAll;
  std::transform(blocks.begin(), blocks.end(), std::back_inserter(ofAll),
    [this](std::size_t block) { return this->ToWhole(block); });
  return this->All->GetBlocks(ofAll, progress);
}
}
