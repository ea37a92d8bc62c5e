// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPalette_h
#define gatunPalette_h

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunTypes.h"

#include <cstdint>
#include <memory>
#include <span>

namespace gatun
{
constexpr std::size_t MaxPalette = 1u << 16;

/**
 * The distinct values of a component of count tuples. Null if there are more than a sixteenth of
 * the tuples, or more than MaxPalette. Integers never have a palette.
 */
std::shared_ptr<const Palette> FindPalette(ScalarType type, const void* values, std::size_t count,
  std::size_t components, std::size_t component);

Bytes EncodePalette(ScalarType type, const Palette& palette);

/** Throws Error(Corrupt) unless the values ascend strictly. */
std::shared_ptr<const Palette> DecodePalette(
  ScalarType type, std::span<const std::uint8_t> stream, std::uint64_t count);
}

#endif
