// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyChunks_h
#define gatunHartleyChunks_h

#include "gatunCache.h"
#include "gatunHartleySource.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>

namespace gatun
{
/** Gets chunks from a source and keeps as many of them for the next image as a budget allows. */
class HartleyChunks
{
public:
  /** Bytes: budget of the chunks that are kept in addition to those in use. */
  HartleyChunks(const HartleySource& source, std::uint64_t bytes)
    : Source(source)
    , Layout(source.GetLayout())
    , Kept(std::make_shared<CacheBudget>(bytes), CachePolicy::KeepFirst)
  {
  }

  /** Gets the chunks of blocks, in parallel, and releases those of the previous call. */
  void Load(std::span<const HartleyLayout::Triple> blocks);

  /** The coefficients of a loaded block. */
  std::span<const HartleyTerm> GetTerms(const HartleyLayout::Triple& place) const;

private:
  using Map = std::map<std::size_t, std::shared_ptr<const HartleyChunk>>;

  const HartleySource& Source;
  HartleyLayout Layout;
  Map Used;
  // Never evicted: each image asks for the same chunks in the same order, where an LRU cache that
  // is too small never hits.
  Cache<std::size_t, HartleyChunk> Kept;
};
}

#endif
