// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPalette_h
#define gatunPalette_h

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_set>
#include <vector>

namespace gatun
{
constexpr std::size_t MaxPalette = 1u << 16;

/** Whose values a palette is for. */
enum class PaletteUse : std::uint8_t
{
  Array,
  Coordinates ///< may have a palette of values at even distances
};

/** Collects the distinct values of a component whose tuples come in parts. */
class PaletteBuilder
{
public:
  /** most: the number of different values beyond which there is no palette. */
  explicit PaletteBuilder(ScalarType type, std::size_t most = MaxPalette);

  /** The most values that are worth collecting for a number of tuples. */
  static std::size_t GetMost(std::uint64_t count, PaletteUse use);

  void Add(const void* values, std::size_t count, std::size_t components, std::size_t component);

  /** Keeps the values of the tuples so far in little memory. */
  void Compress();

  /** Serializes the values for another process, and adds such a message. */
  void Put(ByteWriter& out);
  void Add(ByteReader& in);

  /**
   * The palette for the given number of tuples. Coordinates that are on a lattice, such as rounded
   * ones, have a palette of all its places, so that ranks are distances, too. Null if there are
   * more values than a sixteenth of the tuples and no lattice, or more than MaxPalette. Integers
   * never have a palette.
   */
  std::shared_ptr<const Palette> Finish(std::uint64_t count, PaletteUse use);

private:
  ScalarType Type;
  std::size_t Most;
  std::vector<Key> Sorted;
  std::unordered_set<Key> Distinct; // may contain some of the sorted ones
};

Bytes EncodePalette(ScalarType type, const Palette& palette);

/** Throws Error(Corrupt) unless the values ascend strictly. */
std::shared_ptr<const Palette> DecodePalette(
  ScalarType type, std::span<const std::uint8_t> stream, std::uint64_t count);
}

#endif
