// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyChunks_h
#define gatunHartleyChunks_h

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
    , Bytes(bytes)
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
  std::uint64_t Bytes;
  std::uint64_t KeptBytes = 0;
  Map Used;
  Map Kept; // the first ones that came, as going through all of them again finds most in this way
};
}

#endif
