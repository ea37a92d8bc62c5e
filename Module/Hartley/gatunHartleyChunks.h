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
/** The chunks that are in use, got from a source, and those that are kept for the next picture. */
class HartleyChunks
{
public:
  /** bytes: how much may be kept besides what is in use. */
  HartleyChunks(const HartleySource& source, std::uint64_t bytes)
    : Source(source)
    , Layout(source.GetLayout())
    , Kept(std::make_shared<CacheBudget>(bytes), CachePolicy::KeepFirst)
  {
  }

  /** Gets the chunks that blocks are in, in parallel, and lets those of the call before go. */
  void Load(std::span<const HartleyLayout::Triple> blocks);

  /** Of a block that was loaded. */
  std::span<const HartleyTerm> GetTerms(const HartleyLayout::Triple& place) const;

private:
  using Map = std::map<std::size_t, std::shared_ptr<const HartleyChunk>>;

  const HartleySource& Source;
  HartleyLayout Layout;
  Map Used;
  Cache<std::size_t, HartleyChunk> Kept; // the first ones, because all are used in a cycle
};
}

#endif
