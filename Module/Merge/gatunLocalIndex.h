// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLocalIndex_h
#define gatunLocalIndex_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * A map from a few points to numbers, which are 0 at first. Its memory depends on the number of its
 * points, not on that of the mesh, so that it stays in the first-level cache. Clearing it takes
 * constant time.
 */
class LocalIndex
{
public:
  LocalIndex()
    : Slots(std::size_t{ 1 } << Bits)
  {
  }

  void Clear()
  {
    this->Count = 0;
    if (++this->Stamp == 0)
    {
      this->Slots.assign(this->Slots.size(), {});
      this->Stamp = 1;
    }
  }

  /** Returns the number of a point, which is added if it is new. The reference is valid until the
   * next call. */
  std::uint32_t& operator[](std::uint32_t point)
  {
    Slot* slot = this->Find(point);
    if (slot->Stamp != this->Stamp)
    {
      if (2 * ++this->Count > this->Slots.size())
      {
        this->Grow();
        slot = this->Find(point);
      }
      *slot = { this->Stamp, point, 0 };
    }
    return slot->Number;
  }

  /** Returns the number of a point, or 0. */
  std::uint32_t Get(std::uint32_t point) const
  {
    const Slot* const slot = const_cast<LocalIndex*>(this)->Find(point);
    return slot->Stamp == this->Stamp ? slot->Number : 0;
  }

private:
  struct Slot
  {
    std::uint32_t Stamp = 0; // empty if it is not that of the index
    std::uint32_t Point = 0;
    std::uint32_t Number = 0;
  };

  static constexpr unsigned Bits = 8; // at first

  /** Returns the slot of a point, or that where it belongs. */
  Slot* Find(std::uint32_t point)
  {
    const std::size_t mask = this->Slots.size() - 1;
    for (std::size_t at = (point * 0x9e3779b1u) >> this->Shift;; ++at)
    {
      Slot& slot = this->Slots[at & mask];
      if (slot.Stamp != this->Stamp || slot.Point == point)
      {
        return &slot;
      }
    }
  }

  void Grow()
  {
    std::vector<Slot> old(2 * this->Slots.size());
    old.swap(this->Slots);
    --this->Shift;
    for (const Slot& slot : old)
    {
      if (slot.Stamp == this->Stamp)
      {
        *this->Find(slot.Point) = slot;
      }
    }
  }

  std::vector<Slot> Slots;
  std::size_t Count = 0;
  std::uint32_t Stamp = 1;
  unsigned Shift = 32 - Bits;
};
}

#endif
