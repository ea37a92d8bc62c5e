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
#include <utility>
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

  /** Limits of candidates, and of taken ones. */
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

  /** Writes the nearest vertices, from the nearest one on, and returns their number. The vertex
   * number decides between equal distances. */
  std::size_t TakeNearest(std::span<const std::array<double, 3>> places, Vertex* to)
  {
    const auto center = places[this->Center];
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Ranks[i] = MakeRank(places[this->Ids[i]], center);
    }
    auto end = Highest;
    if (this->Count > this->Most && !this->FindEnd(end))
    {
      return this->TakeWithTies(end, to);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Nearest[kept] = this->Ids[i];
      this->NearestRanks[kept] = this->Ranks[i];
      kept += this->Ranks[i] < end ? 1 : 0;
    }
    if (!this->SortByRank(kept, to))
    {
      this->SortByPlace(kept, to);
    }
    return kept;
  }

private:
  using Int4 = std::int32_t __attribute__((vector_size(16)));
  using Double2 = double __attribute__((vector_size(16)));
  using Long2 = std::int64_t __attribute__((vector_size(16)));

  // Above all ranks.
  static constexpr auto Highest = std::numeric_limits<std::int32_t>::max();

  /** Among many vertices at the same distance. */
  std::size_t TakeWithTies(std::int32_t last, Vertex* to)
  {
    this->Ties.clear();
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      if (this->Ranks[i] <= last)
      {
        this->Ties.emplace_back(this->Ranks[i], this->Ids[i]);
      }
    }
    std::sort(this->Ties.begin(), this->Ties.end());
    for (std::size_t i = 0; i < this->Most; ++i)
    {
      to[i] = this->Ties[i].second;
    }
    return this->Most;
  }

  /** The position of a vertex is the number of nearer ones. Without branches. False if there are
   * equal distances: then some positions are the same, and their sum is less. */
  bool SortByRank(std::size_t count, Vertex* to)
  {
    constexpr std::size_t vectors = MaxTaken / 4;
    std::fill(this->NearestRanks.begin() + static_cast<std::ptrdiff_t>(count),
      this->NearestRanks.end(), Highest);
    std::array<Int4, vectors> ranks;
    std::memcpy(ranks.data(), this->NearestRanks.data(), sizeof(ranks));
    std::array<Int4, vectors> nearer{};
    for (std::size_t k = 0; k < count; ++k)
    {
      const auto rank = this->NearestRanks[k];
      const Int4 all{ rank, rank, rank, rank };
      for (std::size_t j = 0; j < vectors; ++j)
      {
        nearer[j] -= all < ranks[j]; // -1 where it is
      }
    }
    std::array<std::uint32_t, MaxTaken> positions;
    std::memcpy(positions.data(), nearer.data(), sizeof(positions));
    std::size_t sum = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      to[positions[i]] = this->Nearest[i];
      sum += positions[i];
    }
    return 2 * sum + count == count * count;
  }

  /** The same with equal distances, which vertex numbers decide. A rank above the bits of the
   * number is a positive finite number of binary64: all processors compare several of these at
   * once. */
  void SortByPlace(std::size_t count, Vertex* to)
  {
    std::array<double, MaxTaken + 1> places;
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto rank =
        static_cast<std::uint64_t>(static_cast<std::uint32_t>(this->NearestRanks[i]));
      places[i] = std::bit_cast<double>(rank << 32 | this->Nearest[i]);
    }
    places[count] = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i)
    {
      const Double2 both{ places[i], places[i] };
      Long2 nearer{};
      for (std::size_t k = 0; k < count; k += 2)
      {
        Double2 two;
        std::memcpy(&two, places.data() + k, sizeof(two));
        nearer += two < both; // -1 where it is
      }
      to[-(nearer[0] + nearer[1])] = this->Nearest[i];
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

  /** Sets end to a rank that as many ranks are below as are to be taken. False if there is none:
   * then end is the highest rank that fewer are below. */
  bool FindEnd(std::int32_t& end)
  {
    std::fill_n(this->Ranks.begin() + static_cast<std::ptrdiff_t>(this->Count), 3, Highest);
    std::int32_t low = 0;
    std::int32_t high = Highest;
    // First near the result for the vertex before. A step of the rank's logarithm for each vertex
    // that is missing, as if they were evenly spread.
    constexpr std::int32_t step = 340000;
    constexpr unsigned guesses = 5;
    for (unsigned i = 0; high - low > 1; ++i)
    {
      if (i == guesses)
      {
        const auto [least, most] =
          std::minmax_element(this->Ranks.begin(), this->Ranks.begin() + this->Count);
        low = std::max(low, *least);
        high = std::min(high, *most + 1); // ranks are at most that of infinity
      }
      const bool isGuess = i<guesses&& this->Guess> low && this->Guess < high;
      const auto middle = isGuess ? this->Guess : low + (high - low) / 2;
      const auto below = static_cast<std::int32_t>(this->CountBelow(middle));
      const auto missing = static_cast<std::int32_t>(this->Most) - below;
      this->Guess = middle;
      end = middle;
      if (missing == 0)
      {
        return true;
      }
      (missing > 0 ? low : high) = middle;
      this->Guess += std::clamp(missing, -24, 24) * step;
    }
    end = low;
    return false;
  }

  const std::size_t Most;
  std::vector<Vertex> Marks; // the last own vertex that each vertex was a candidate of
  Vertex Center = NoVertex;
  std::int32_t Guess = 0;
  std::size_t Count = 0;
  std::array<Vertex, MaxCandidates + 1> Ids;
  std::array<std::int32_t, MaxCandidates + 4> Ranks;
  std::array<Vertex, MaxTaken + 1> Nearest; // one more is written than kept
  std::array<std::int32_t, MaxTaken + 1> NearestRanks;
  std::vector<std::pair<std::int32_t, Vertex>> Ties;
};
}

#endif
