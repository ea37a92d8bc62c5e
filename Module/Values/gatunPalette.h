// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPalette_h
#define gatunPalette_h

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunTypes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <utility>
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

/** Different keys. A hash table with linear probing that is at most half full. */
class KeySet
{
public:
  /** Whether a key was new. */
  bool Add(Key key)
  {
    if (key == None)
    {
      return !std::exchange(this->HasNone, true);
    }
    if (2 * (this->Used + 1) > this->Slots.size())
    {
      this->Grow();
    }
    auto& slot = this->Slots[this->FindSlot(key)];
    const bool isNew = slot == None;
    slot = key;
    this->Used += isNew ? 1 : 0;
    return isNew;
  }

  std::size_t GetSize() const { return this->Used + (this->HasNone ? 1 : 0); }

  /** Appends the keys in any order. */
  void AppendTo(std::vector<Key>& keys) const
  {
    std::copy_if(this->Slots.begin(), this->Slots.end(), std::back_inserter(keys),
      [](Key key) { return key != None; });
    if (this->HasNone)
    {
      keys.push_back(None);
    }
  }

private:
  static constexpr Key None = 0; // in slots that are free

  /** The slot of a key, or the free one where it belongs. */
  std::size_t FindSlot(Key key) const
  {
    const auto mask = this->Slots.size() - 1;
    auto at = static_cast<std::size_t>((key * Key{ 0x9e3779b97f4a7c15u }) >> 32) & mask;
    while (this->Slots[at] != None && this->Slots[at] != key)
    {
      at = (at + 1) & mask;
    }
    return at;
  }

  void Grow()
  {
    const auto before = std::exchange(
      this->Slots, std::vector<Key>(std::max<std::size_t>(64, 2 * this->Slots.size()), None));
    for (const auto key : before)
    {
      if (key != None)
      {
        this->Slots[this->FindSlot(key)] = key;
      }
    }
  }

  std::vector<Key> Slots;
  std::size_t Used = 0;
  bool HasNone = false;
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
  KeySet Distinct; // may contain some of the sorted ones
};

Bytes EncodePalette(ScalarType type, const Palette& palette);

/** Throws Error(Corrupt) unless the values ascend strictly. */
std::shared_ptr<const Palette> DecodePalette(
  ScalarType type, std::span<const std::uint8_t> stream, std::uint64_t count);
}

#endif
