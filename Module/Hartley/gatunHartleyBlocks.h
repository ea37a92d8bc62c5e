// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyBlocks_h
#define gatunHartleyBlocks_h

// Iteration over the chunks of a volume and the blocks of a chunk.

#include "gatunError.h"
#include "gatunHartleyLayout.h"
#include "gatunParallel.h"

#include <cstddef>
#include <functional>

namespace gatun
{
/** The number of blocks of a chunk along each axis. */
inline HartleyLayout::Triple GetHartleyGrid(const HartleyLayout& layout, std::size_t chunk)
{
  const auto box = layout.GetBlocksOfChunk(chunk);
  return { box.End[0] - box.First[0], box.End[1] - box.First[1], box.End[2] - box.First[2] };
}

inline std::size_t CountHartleyBlocks(const HartleyLayout& layout, std::size_t chunk)
{
  const auto grid = GetHartleyGrid(layout, chunk);
  return std::size_t{ grid[0] } * grid[1] * grid[2];
}

/** Calls visit(number in the chunk, place in the volume) for the blocks of a chunk. */
template <typename Visit>
void ForEachHartleyBlock(const HartleyLayout& layout, std::size_t chunk, Visit&& visit)
{
  const auto box = layout.GetBlocksOfChunk(chunk);
  std::size_t block = 0;
  for (auto z = box.First[2]; z < box.End[2]; ++z)
  {
    for (auto y = box.First[1]; y < box.End[1]; ++y)
    {
      for (auto x = box.First[0]; x < box.End[0]; ++x)
      {
        visit(block, HartleyLayout::Triple{ x, y, z });
        ++block;
      }
    }
  }
}

/** ParallelFor, except that a single chunk runs on the calling thread, so that its own loops can be
 * parallel. */
template <typename Body>
void ForEachHartleyChunk(
  std::size_t count, Body&& body, const std::function<bool(double)>& progress = {})
{
  if (count != 1)
  {
    ParallelFor(count, body, progress);
    return;
  }
  const auto report = [&](double done)
  {
    if (progress && !progress(done))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  };
  report(0);
  body(std::size_t{ 0 });
  report(1);
}
}

#endif
