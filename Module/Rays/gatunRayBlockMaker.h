// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayBlockMaker_h
#define gatunRayBlockMaker_h

// Blocks from a cache; missing ones are made.

#include "gatunParallel.h"
#include "gatunRayBlockCache.h"
#include "gatunRaySource.h"

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/** Takes blocks out of a cache. Calls make(missing blocks, span of their results) for the others.
 */
template <typename Make>
RaySource::Blocks FindOrMakeTogether(
  RayBlockCache& cache, std::span<const std::size_t> blocks, Make&& make)
{
  RaySource::Blocks result(blocks.size());
  std::vector<std::size_t> places;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    result[i] = cache.Find(blocks[i]);
    if (!result[i])
    {
      places.push_back(i);
      missing.push_back(blocks[i]);
    }
  }
  if (missing.empty())
  {
    return result;
  }
  RaySource::Blocks made(missing.size());
  make(std::span<const std::size_t>(missing), made);
  for (std::size_t i = 0; i < missing.size(); ++i)
  {
    cache.Add(missing[i], made[i]);
    result[places[i]] = std::move(made[i]);
  }
  return result;
}

/** The same, where make(block, result) makes one block. Calls run in parallel. */
template <typename Make>
RaySource::Blocks FindOrMake(RayBlockCache& cache, std::span<const std::size_t> blocks,
  const RaySource::Progress& progress, Make&& make)
{
  return FindOrMakeTogether(cache, blocks,
    [&](std::span<const std::size_t> missing, RaySource::Blocks& made)
    {
      ParallelFor(
        missing.size(),
        [&](std::size_t i)
        {
          auto block = std::make_shared<RayBlock>();
          make(missing[i], *block);
          block->Prepare();
          made[i] = std::move(block);
        },
        progress);
    });
}

}

#endif
