// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNearestPicker_h
#define gatunNearestPicker_h

#include "gatunFront.h"
#include "gatunInline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace gatun
{
/** The bits of a squared distance in binary32, which ascend with it. */
GATUN_INLINE std::int32_t MakeRank(
  const std::array<double, 3>& place, const std::array<double, 3>& center)
{
  const double x = place[0] - center[0];
  const double y = place[1] - center[1];
  const double z = place[2] - center[2];
  const auto square = static_cast<float>(x * x + y * y + z * z);
  constexpr float most = std::numeric_limits<float>::max();
  return std::bit_cast<std::int32_t>(
    square <= most ? square : std::numeric_limits<float>::infinity());
}

/** Candidates and their ranks. Without branches that depend on the mesh, as far as possible. */
class NearestPicker
{
public:
  /** most: the number of vertices to take. */
  NearestPicker(std::size_t vertices, std::size_t most)
    : Most(most)
    , Marks(vertices, NoVertex)
  {
  }

  /** The number of candidates that there may be, and of those that may be taken. */
  static constexpr std::size_t MaxCandidates = 1056;
  static constexpr std::size_t MaxTaken = 24;

  void Begin(Vertex center)
  {
    this->Center = center;
    this->Marks[center] = center;
    this->Count = 0;
  }

  /** Adds a vertex, unless it has been added since Begin. There must be fewer than MaxCandidates.
   */
  void Add(Vertex v)
  {
    this->Ids[this->Count] = v;
    this->Count += this->Marks[v] != this->Center ? 1 : 0;
    this->Marks[v] = this->Center;
  }

  /** Writes the nearest vertices, from the nearest one on, and returns how many. The vertex number
   * decides between equal distances. */
  std::size_t TakeNearest(std::span<const std::array<double, 3>> places, Vertex* to)
  {
    const auto center = places[this->Center];
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Ranks[i] = MakeRank(places[this->Ids[i]], center);
    }
    std::size_t kept = 0;
    if (this->Count <= this->Most)
    {
      for (; kept < this->Count; ++kept)
      {
        this->Nearest[kept] = this->GetPlace(kept);
      }
    }
    else
    {
      const auto end = this->FindEnd();
      if (this->CountBelow(end) < this->Most)
      {
        kept = this->TakeWithTies(end);
      }
      else
      {
        for (std::size_t i = 0; i < this->Count; ++i)
        {
          this->Nearest[kept] = this->GetPlace(i);
          kept += this->Ranks[i] < end ? 1 : 0;
        }
      }
    }
    this->Sort(kept, to);
    return kept;
  }

private:
  using Int4 = std::int32_t __attribute__((vector_size(16)));

  using Double2 = double __attribute__((vector_size(16)));
  using Long2 = std::int64_t __attribute__((vector_size(16)));

  /** Bits of a rank above those of the vertex number, as a positive finite number of binary64,
   * because all processors compare several of these at once. */
  double GetPlace(std::size_t i) const
  {
    const auto rank = static_cast<std::uint64_t>(static_cast<std::uint32_t>(this->Ranks[i]));
    return std::bit_cast<double>(rank << 32 | this->Ids[i]);
  }

  /** Among many vertices at the same distance. */
  std::size_t TakeWithTies(std::int32_t last)
  {
    this->Ties.clear();
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      if (this->Ranks[i] <= last)
      {
        this->Ties.push_back(this->GetPlace(i));
      }
    }
    std::sort(this->Ties.begin(), this->Ties.end());
    std::copy_n(this->Ties.begin(), this->Most, this->Nearest.begin());
    return this->Most;
  }

  /** The position of a vertex is the number of nearer ones. Without branches. */
  void Sort(std::size_t count, Vertex* to)
  {
    this->Nearest[count] = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i)
    {
      const double place = this->Nearest[i];
      const Double2 both{ place, place };
      Long2 nearer{};
      for (std::size_t k = 0; k < count; k += 2)
      {
        Double2 two;
        std::memcpy(&two, this->Nearest.data() + k, sizeof(two));
        nearer += two < both; // -1 where it is
      }
      to[-(nearer[0] + nearer[1])] = static_cast<Vertex>(std::bit_cast<std::uint64_t>(place));
    }
  }

  std::size_t CountBelow(std::int32_t end) const
  {
    const Int4 all{ end, end, end, end };
    Int4 below{};
    for (std::size_t k = 0; k < this->Count; k += 4)
    {
      Int4 four;
      std::memcpy(&four, this->Ranks.data() + k, sizeof(four));
      below += four < all; // -1 where it is
    }
    return static_cast<std::size_t>(-(below[0] + below[1] + below[2] + below[3]));
  }

  /** A rank that as many ranks are below as are to be kept; or fewer, but too many up to it. */
  std::int32_t FindEnd()
  {
    constexpr auto highest = std::numeric_limits<std::int32_t>::max();
    std::fill_n(this->Ranks.begin() + static_cast<std::ptrdiff_t>(this->Count), 3, highest);
    std::int32_t low = highest;
    std::int32_t high = 0;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      low = std::min(low, this->Ranks[i]);
      high = std::max(high, this->Ranks[i] + 1); // ranks are at most that of infinity
    }
    // First near the result for the vertex before. A step of the rank's logarithm for each vertex
    // that is missing, as if they were evenly spread.
    constexpr std::int32_t step = 340000;
    constexpr unsigned guesses = 5;
    for (unsigned i = 0; high - low > 1; ++i)
    {
      const bool isGuess = i<guesses&& this->Guess> low && this->Guess < high;
      const auto middle = isGuess ? this->Guess : low + (high - low) / 2;
      const auto below = static_cast<std::int32_t>(this->CountBelow(middle));
      const auto missing = static_cast<std::int32_t>(this->Most) - below;
      this->Guess = middle;
      if (missing == 0)
      {
        return middle;
      }
      (missing > 0 ? low : high) = middle;
      this->Guess += std::clamp(missing, -24, 24) * step;
    }
    return low;
  }

  const std::size_t Most;
  std::vector<Vertex> Marks; // the last own vertex that each vertex was a candidate of
  Vertex Center = NoVertex;
  std::int32_t Guess = 0;
  std::size_t Count = 0;
  std::array<Vertex, MaxCandidates + 1> Ids;
  std::array<std::int32_t, MaxCandidates + 4> Ranks;
  std::array<double, MaxTaken + 1> Nearest;
  std::vector<double> Ties;
};
}

#endif
