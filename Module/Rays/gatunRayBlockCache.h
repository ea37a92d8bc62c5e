// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayBlockCache_h
#define gatunRayBlockCache_h

#include "gatunCacheBudget.h"
#include "gatunExport.h"
#include "gatunRayBlock.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace gatun
{
/** Keeps blocks within a budget. The least recently used blocks are removed first. Thread safe. */
class GATUN_EXPORT RayBlockCache
{
public:
  /** Budget: in bytes. */
  explicit RayBlockCache(std::uint64_t budget);

  /** A cache that shares a budget with others. */
  explicit RayBlockCache(std::shared_ptr<CacheBudget> budget);

  ~RayBlockCache();
  RayBlockCache(const RayBlockCache&) = delete;
  RayBlockCache& operator=(const RayBlockCache&) = delete;

  /** Returns the block, or null if it is not in the cache. */
  std::shared_ptr<const RayBlock> Find(std::size_t block);
  void Add(std::size_t block, std::shared_ptr<const RayBlock> made);

  CacheStatistics GetStatistics() const;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
