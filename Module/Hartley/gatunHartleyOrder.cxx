// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyOrder.h"

#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gatun
{
namespace
{
using Triple = HartleyLayout::Triple;

std::int16_t GetWave(std::uint32_t index, std::uint32_t size)
{
  return static_cast<std::int16_t>(
    2 * index <= size ? std::int64_t{ index } : std::int64_t{ index } - std::int64_t{ size });
}

std::uint32_t GetOpposite(std::uint32_t index, std::uint32_t size)
{
  return index == 0 ? 0 : size - index;
}

std::uint32_t GetIndex(const Triple& place, const Triple& block)
{
  return place[0] + block[0] * (place[1] + block[1] * place[2]);
}

/** The length of a frequency in periods of the longest side, rounded down. */
class Shells
{
public:
  explicit Shells(const Triple& block)
  {
    const double longest = std::max({ block[0], block[1], block[2] });
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      for (std::uint32_t index = 0; index < block[axis]; ++index)
      {
        const double wave = GetWave(index, block[axis]) * longest / block[axis];
        this->Squares[axis].push_back(wave * wave);
      }
    }
  }

  std::uint32_t Get(const Triple& place) const
  {
    return static_cast<std::uint32_t>(std::sqrt(
      this->Squares[0][place[0]] + this->Squares[1][place[1]] + this->Squares[2][place[2]]));
  }

private:
  std::array<std::vector<double>, 3> Squares;
};
}

//------------------------------------------------------------------------------
/** The positions of a block, shell by shell. Slices of the block are counted and then placed by all
 * threads. */
class HartleyOrder::Builder
{
public:
  Builder(HartleyOrder& order, const Triple& block)
    : Order(order)
    , Block(block)
    , Lengths(block)
    , Parts(std::min<std::uint32_t>(block[2], MostParts))
    , Starts(this->Parts)
    , Ranks(order.GetPositions().size())
  {
  }

  void Run()
  {
    ParallelFor(this->Parts, [&](std::size_t part) { this->CountPart(part); });
    this->FindBands();
    ParallelFor(this->Parts, [&](std::size_t part) { this->PlacePart(part); });
    ParallelFor(this->Order.GetNumberOfSegments(),
      [&](std::size_t segment)
      {
        const auto begin = static_cast<std::uint32_t>(segment) * SegmentLength;
        const auto end = std::min(this->Order.GetCount(), begin + std::min(SegmentLength, ~begin));
        for (std::uint32_t rank = begin; rank < end; ++rank)
        {
          this->Flag(rank);
        }
      });
  }

private:
  static constexpr std::uint32_t MostParts = 64;

  /** Calls use(place, index, index of the opposite frequency) for one frequency of each pair in a
   * part of the block. */
  template <typename Use>
  void ForEachPair(std::size_t part, Use&& use)
  {
    const auto number = static_cast<std::uint32_t>(part);
    const auto getSlice = [&](std::uint32_t i)
    { return static_cast<std::uint32_t>(std::uint64_t{ this->Block[2] } * i / this->Parts); };
    Triple place{};
    for (place[2] = getSlice(number); place[2] < getSlice(number + 1); ++place[2])
    {
      for (place[1] = 0; place[1] < this->Block[1]; ++place[1])
      {
        place[0] = 0;
        std::uint32_t index = GetIndex(place, this->Block);
        const std::uint32_t opposite = GetIndex(
          { 0, GetOpposite(place[1], this->Block[1]), GetOpposite(place[2], this->Block[2]) },
          this->Block);
        for (; place[0] < this->Block[0]; ++place[0], ++index)
        {
          const std::uint32_t partner = opposite + GetOpposite(place[0], this->Block[0]);
          if (partner >= index)
          {
            use(place, index, partner);
          }
        }
      }
    }
  }

  void CountPart(std::size_t part)
  {
    auto& counts = this->Starts[part];
    this->ForEachPair(part,
      [&](const Triple& place, std::uint32_t index, std::uint32_t partner)
      {
        const std::size_t shell = this->Lengths.Get(place);
        if (shell >= counts.size())
        {
          counts.resize(shell + 1);
        }
        counts[shell] += index == partner ? 1 : 2;
      });
  }

  /** From the sizes of the shells in each part their first positions. */
  void FindBands()
  {
    std::size_t shells = 0;
    for (const auto& counts : this->Starts)
    {
      shells = std::max(shells, counts.size());
    }
    // Shell 0 contains frequency 0 only. If there are more other shells than bands, a band contains
    // several.
    const auto others = static_cast<std::uint32_t>(shells) - 1;
    std::uint32_t start = 0;
    for (std::uint32_t shell = 0; shell < shells; ++shell)
    {
      this->BandOfShell.push_back(static_cast<std::uint8_t>(
        shell == 0 || others < Bands ? shell : 1 + (shell - 1) * (Bands - 1) / others));
      if (this->Order.BandStarts.size() == this->BandOfShell.back())
      {
        this->Order.BandStarts.push_back(start);
      }
      for (auto& counts : this->Starts)
      {
        counts.resize(shells);
        start += std::exchange(counts[shell], start);
      }
    }
    this->Order.BandStarts.push_back(this->Order.GetCount());
  }

  void PlacePart(std::size_t part)
  {
    auto& starts = this->Starts[part];
    this->ForEachPair(part,
      [&](const Triple& place, std::uint32_t index, std::uint32_t partner)
      {
        const auto shell = this->Lengths.Get(place);
        Position position{ index, partner, {}, this->BandOfShell[shell], 0 };
        for (unsigned axis = 0; axis < 3; ++axis)
        {
          position.Wave[axis] = GetWave(place[axis], this->Block[axis]);
        }
        this->Put(starts[shell], position);
        if (index == partner)
        {
          return;
        }
        for (unsigned axis = 0; axis < 3; ++axis)
        {
          position.Wave[axis] =
            GetWave(GetOpposite(place[axis], this->Block[axis]), this->Block[axis]);
        }
        std::swap(position.Index, position.Partner);
        position.Flags = KnowsPartner;
        this->Put(starts[shell], position);
      });
  }

  void Put(std::uint32_t& rank, const Position& position)
  {
    this->Ranks[position.Index] = rank;
    this->Order.Positions[rank++] = position;
  }

  void Flag(std::uint32_t rank)
  {
    auto& position = this->Order.Positions[rank];
    const auto isKnown = [&](std::uint32_t index) {
      return this->Ranks[index] < rank &&
        this->Ranks[index] / SegmentLength == rank / SegmentLength;
    };
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto wave = position.Wave[axis];
      if (wave == 0)
      {
        continue;
      }
      const auto inner =
        static_cast<std::uint32_t>(position.Index + this->Order.GetStepInwards(axis, wave));
      if (isKnown(inner))
      {
        position.Flags |= static_cast<std::uint8_t>(KnowsInner << axis);
        const auto innerPartner =
          static_cast<std::uint32_t>(position.Partner + this->Order.GetStepInwards(axis, -wave));
        if (isKnown(innerPartner))
        {
          position.Flags |= static_cast<std::uint8_t>(KnowsInnerPartner << axis);
        }
      }
    }
    if (!isKnown(position.Partner))
    {
      position.Flags &= static_cast<std::uint8_t>(~KnowsPartner);
    }
  }

  HartleyOrder& Order;
  Triple Block;
  Shells Lengths;
  std::uint32_t Parts;
  std::vector<std::vector<std::uint32_t>> Starts; // of each shell, in each part
  std::vector<std::uint8_t> BandOfShell;
  LargeArray<std::uint32_t> Ranks;
};

//------------------------------------------------------------------------------
HartleyOrder::HartleyOrder(const Triple& block)
  : Positions(std::size_t{ block[0] } * block[1] * block[2])
{
  this->Strides = { 1, static_cast<std::ptrdiff_t>(block[0]),
    static_cast<std::ptrdiff_t>(block[0]) * static_cast<std::ptrdiff_t>(block[1]) };
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    this->Wraps[axis] = -this->Strides[axis] * (static_cast<std::ptrdiff_t>(block[axis]) - 1);
  }
  Builder(*this, block).Run();
}
}
