// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFingerprint_h
#define gatunFingerprint_h

#include "gatunExport.h" // For export macro

#include <cstdint>
#include <span>

namespace gatun
{
/** A hash of 128 bits that recognizes arrays that are no longer in memory. Among 10^9 different
 * ones, the probability of a collision is below 10^-20. It is no protection from deliberate
 * collisions. */
struct Fingerprint
{
  std::uint64_t Low = 0;
  std::uint64_t High = 0;

  bool operator==(const Fingerprint&) const = default;
};

/** The fingerprint of a list of arrays: of their lengths and bytes. Throws std::bad_alloc. */
GATUN_EXPORT Fingerprint MakeFingerprint(std::span<const std::span<const std::uint8_t>> arrays);
}

#endif
