// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunVertexNames_h
#define gatunVertexNames_h

// Which vertices of a chunk are shared ones, and which of them.

#include "gatunNumberStream.h"
#include "gatunTetTree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Appends the names of vertices below shared. inputOf: the input's vertex of each one. Returns the
 * own ones in order, from 0. */
inline std::vector<std::uint32_t> PutVertexNames(
  ByteWriter& out, std::span<const std::uint32_t> inputOf, std::uint32_t shared)
{
  NumberWriter names;
  std::vector<std::uint32_t> own;
  std::uint32_t after = 0; // the last shared vertex
  std::int64_t place = -1;
  for (std::uint32_t v = 0; v < inputOf.size(); ++v)
  {
    const auto input = inputOf[v];
    if (input >= shared)
    {
      own.push_back(input - shared);
      continue;
    }
    names.Put(v - after);
    names.Put(FromSigned(std::int64_t{ input } - place - 1));
    after = v + 1;
    place = input;
  }
  names.Finish(out);
  return own;
}

/** The sources of vertices as in TetTree. */
inline std::vector<std::uint32_t> MakeSources(
  std::span<const std::uint32_t> inputOf, std::uint32_t shared)
{
  std::vector<std::uint32_t> sources(inputOf.size());
  std::uint32_t own = 0;
  std::transform(inputOf.begin(), inputOf.end(), sources.begin(),
    [&](std::uint32_t input) { return input < shared ? input | TetTree::SharedFlag : own++; });
  return sources;
}

/** Reads names: the sources of vertices as in TetTree. */
inline std::vector<std::uint32_t> GetVertexNames(
  ByteReader& in, std::uint32_t vertices, std::uint32_t shared)
{
  std::vector<std::uint32_t> sources(vertices, 0);
  NumberReader names(in, 2 * std::size_t{ shared }, 18);
  std::vector<char> isMet(shared, 0);
  std::uint64_t vertex = 0;
  std::int64_t place = -1;
  for (std::uint32_t i = 0; i < shared; ++i, ++vertex)
  {
    vertex += names.Get();
    place += 1 + ToSigned(names.Get());
    if (vertex >= vertices || place < 0 || place >= shared ||
      isMet[static_cast<std::size_t>(place)] != 0)
    {
      ThrowCorrupt("a chunk names a shared point that it does not have");
    }
    isMet[static_cast<std::size_t>(place)] = 1;
    sources[static_cast<std::size_t>(vertex)] =
      static_cast<std::uint32_t>(place) | TetTree::SharedFlag;
  }
  std::uint32_t own = 0;
  for (auto& source : sources)
  {
    const std::uint32_t isOwn = source == 0 ? 1 : 0;
    source |= own & (0 - isOwn);
    own += isOwn;
  }
  return sources;
}
}

#endif
