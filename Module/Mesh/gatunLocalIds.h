// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLocalIds_h
#define gatunLocalIds_h

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gatun
{
/** Numbers the points of a chunk from 0 in the order in which they are added. A hash table with
 * linear probing that is at most half full. */
class LocalIds
{
public:
  /** expected: approximate number of points. */
  explicit LocalIds(std::size_t expected)
    : Slots(std::bit_ceil(std::max<std::size_t>(64, 2 * expected)))
  {
  }

  /** The number of a point, which is added unless it is there. */
  std::uint32_t Add(std::uint32_t point)
  {
    auto& slot = this->Slots[this->FindSlot(point)];
    if (slot.Number == None)
    {
      slot = { point, static_cast<std::uint32_t>(this->Points.size()) };
      this->Points.push_back(point);
      if (2 * this->Points.size() > this->Slots.size())
      {
        this->Grow();
      }
      return static_cast<std::uint32_t>(this->Points.size() - 1);
    }
    return slot.Number;
  }

  /** The number of a point that has been added. */
  std::uint32_t operator[](std::uint32_t point) const
  {
    return this->Slots[this->FindSlot(point)].Number;
  }

  /** The points in the order of their numbers. */
  const std::vector<std::uint32_t>& GetPoints() const { return this->Points; }

private:
  static constexpr std::uint32_t None = 0xffffffffu;

  struct Slot
  {
    std::uint32_t Point = 0;
    std::uint32_t Number = None;
  };

  /** The slot of a point, or the free one where it belongs. */
  std::size_t FindSlot(std::uint32_t point) const
  {
    const auto mask = this->Slots.size() - 1;
    auto at = static_cast<std::size_t>((point * std::uint64_t{ 0x9e3779b97f4a7c15u }) >> 32) & mask;
    while (this->Slots[at].Number != None && this->Slots[at].Point != point)
    {
      at = (at + 1) & mask;
    }
    return at;
  }

  void Grow()
  {
    this->Slots.assign(2 * this->Slots.size(), {});
    for (std::uint32_t i = 0; i < this->Points.size(); ++i)
    {
      this->Slots[this->FindSlot(this->Points[i])] = { this->Points[i], i };
    }
  }

  std::vector<Slot> Slots;
  std::vector<std::uint32_t> Points;
};
}

#endif
