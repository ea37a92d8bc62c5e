// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRaySourceInternals_h
#define gatunRaySourceInternals_h

// What sources of blocks have in common.

#include "gatunParallel.h"
#include "gatunRaySource.h"
#include "gatunWithType.h"

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
class ChunkCache;

/** Calls use(getValue), where getValue(i) is the value of tuple i that is to be drawn. */
template <typename Use>
void WithValues(const RayValuesInput& input, Use&& use)
{
  WithComponent(input.Type, input.Values, input.Components, input.Component, use);
}

inline void Extend(Range& range, double value)
{
  // NaN compares as false.
  range.Min = value < range.Min ? value : range.Min;
  range.Max = value > range.Max ? value : range.Max;
}

/** Takes blocks out of a cache; make(blocks that are missing, where they go) makes the others. */
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

/** The same, where make(block, where it goes) makes one of them, in parallel. */
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

/** How much of a budget of bytes is for what many chunks share, which is small, and is needed again
 * before long. */
inline std::uint64_t GetBudgetForParts(std::uint64_t budget)
{
  return std::min(budget / 4, std::uint64_t{ 16 } << 20);
}

/** Throws InvalidInput if a file has no such array, component or step. */
void CheckRayValues(const FileReader& file, const RayValues& values);

/** A chunk of a file, which is yet to be prepared: its shared points, then its own. */
RayBlock DecodeRayBlock(
  const std::shared_ptr<ChunkCache>& parts, const RayValues& values, std::size_t chunk);
}

#endif
