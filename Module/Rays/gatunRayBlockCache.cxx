// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayBlockCache.h"

#include "gatunCache.h"

namespace gatun
{
//------------------------------------------------------------------------------
class RayBlockCache::Internals
{
public:
  Cache<std::size_t, RayBlock> Blocks;
};

//------------------------------------------------------------------------------
RayBlockCache::RayBlockCache(std::uint64_t budget)
  : RayBlockCache(std::make_shared<CacheBudget>(budget))
{
}

RayBlockCache::RayBlockCache(std::shared_ptr<CacheBudget> budget)
  : Self(new Internals{ Cache<std::size_t, RayBlock>(std::move(budget)) })
{
}

RayBlockCache::~RayBlockCache() = default;

//------------------------------------------------------------------------------
std::shared_ptr<const RayBlock> RayBlockCache::Find(std::size_t block)
{
  return this->Self->Blocks.Find(block);
}

//------------------------------------------------------------------------------
void RayBlockCache::Add(std::size_t block, std::shared_ptr<const RayBlock> made)
{
  const auto bytes = made->GetMemorySize();
  this->Self->Blocks.Keep(block, std::move(made), bytes);
}

//------------------------------------------------------------------------------
CacheStatistics RayBlockCache::GetStatistics() const
{
  return this->Self->Blocks.GetStatistics();
}

}
