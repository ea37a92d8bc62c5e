// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnHash_h
#define gtnHash_h

#include <xxhash.h>

#include <compare>
#include <cstddef>
#include <cstdint>

namespace gtn
{
/** A hash of 128 bits. Two of them are taken to be equal only if their sources are. */
struct Hash
{
  std::uint64_t Low = 0;
  std::uint64_t High = 0;

  auto operator<=>(const Hash&) const = default;
};

/** Returns the hash of some bytes and of an earlier hash. */
inline Hash HashOf(const void* bytes, std::size_t size, const Hash& before = {})
{
  const XXH128_hash_t first = XXH3_128bits_withSeed(bytes, size, before.Low);
  const std::uint64_t all[3] = { first.low64, first.high64, before.High };
  const XXH128_hash_t mixed = XXH3_128bits(all, sizeof(all));
  return { mixed.low64, mixed.high64 };
}
}

#endif
