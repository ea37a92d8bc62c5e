// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunVertexHash_h
#define gatunVertexHash_h

#include <cstdint>
#include <span>

namespace gatun
{
/** A hash of some vertices that does not depend on their order. */
inline std::uint64_t HashVertices(std::span<const std::uint32_t> vertices)
{
  std::uint64_t sum = vertices.size();
  for (const auto vertex : vertices)
  {
    std::uint64_t hash = (vertex + std::uint64_t{ 1 }) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
    hash *= 0xbf58476d1ce4e5b9u;
    sum += hash ^ hash >> 32;
  }
  return sum;
}
}

#endif
