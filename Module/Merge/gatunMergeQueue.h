// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeQueue_h
#define gatunMergeQueue_h

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * A priority queue of points by cost. Costs that differ by less than 1/16 may have the same key.
 * All points of the lowest key are taken at once, in the order of their numbers: points that follow
 * each other are then near each other, and their surroundings are in the cache of the processor.
 */
class MergeQueue
{
public:
  using Key = std::uint16_t;

  /** Of a cost that is not negative: its exponent and four more bits. */
  static Key GetKey(double cost)
  {
    return static_cast<Key>(std::bit_cast<std::uint64_t>(cost) >> 48);
  }

  MergeQueue()
    : Buckets(std::size_t{ 1 } << 15)
    , Lowest(this->Buckets.size())
  {
  }

  void Push(Key key, std::uint32_t point)
  {
    this->Buckets[key].push_back(point);
    this->Lowest = std::min<std::size_t>(this->Lowest, key);
  }

  /** Takes the points of the lowest key. Returns false if there are none. */
  bool Take(Key& key, std::vector<std::uint32_t>& points)
  {
    points.clear();
    while (this->Lowest < this->Buckets.size() && this->Buckets[this->Lowest].empty())
    {
      ++this->Lowest;
    }
    if (this->Lowest == this->Buckets.size())
    {
      return false;
    }
    key = static_cast<Key>(this->Lowest);
    points.swap(this->Buckets[this->Lowest]);
    std::sort(points.begin(), points.end());
    return true;
  }

private:
  std::vector<std::vector<std::uint32_t>> Buckets; // of each key
  std::size_t Lowest;                              // no key below it has points
};
}

#endif
