// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFingerprint.h"

#include <xxhash.h>

#include <memory>
#include <new>

namespace gatun
{
//------------------------------------------------------------------------------
Fingerprint MakeFingerprint(std::span<const std::span<const std::uint8_t>> arrays)
{
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(
    XXH3_createState(), &XXH3_freeState);
  if (!state)
  {
    throw std::bad_alloc();
  }
  XXH3_128bits_reset(state.get());
  for (const auto& array : arrays)
  {
    const std::uint64_t length = array.size();
    XXH3_128bits_update(state.get(), &length, sizeof(length));
    XXH3_128bits_update(state.get(), array.data(), array.size());
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  return { hash.low64, hash.high64 };
}
}
