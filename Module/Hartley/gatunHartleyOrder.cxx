// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyOrder.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
using Triple = HartleyLayout::Triple;

std::int32_t GetWave(std::uint32_t index, std::uint32_t size)
{
  return static_cast<std::int32_t>(
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

Triple GetPlace(std::uint32_t index, const Triple& block)
{
  return { index % block[0], index / block[0] % block[1], index / block[0] / block[1] };
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
HartleyOrder::HartleyOrder(const Triple& block)
{
  const Shells shells(block);
  const std::uint32_t count = block[0] * block[1] * block[2];

  // The size of each shell, and from these the first position of each shell.
  std::vector<std::uint32_t> starts;
  for (std::uint32_t index = 0; index < count; ++index)
  {
    const std::size_t shell = shells.Get(GetPlace(index, block));
    starts.resize(std::max(starts.size(), shell + 2));
    ++starts[shell + 1];
  }
  for (std::size_t shell = 1; shell < starts.size(); ++shell)
  {
    starts[shell] += starts[shell - 1];
  }

  // Shell 0 contains frequency 0 only. If there are more other shells than bands, a band contains
  // several.
  const auto others = static_cast<std::uint32_t>(starts.size()) - 2;
  const auto getBand = [&](std::uint32_t shell)
  { return shell == 0 || others < Bands ? shell : 1 + (shell - 1) * (Bands - 1) / others; };
  for (std::uint32_t shell = 0; shell <= others; ++shell)
  {
    if (this->BandStarts.size() == getBand(shell))
    {
      this->BandStarts.push_back(starts[shell]);
    }
  }
  this->BandStarts.push_back(count);

  this->Positions.resize(count);
  std::vector<std::uint32_t> ranks(count);
  for (std::uint32_t index = 0; index < count; ++index)
  {
    const auto place = GetPlace(index, block);
    Triple opposite{};
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      opposite[axis] = GetOpposite(place[axis], block[axis]);
    }
    const auto partner = GetIndex(opposite, block);
    if (partner < index)
    {
      continue;
    }
    const auto shell = shells.Get(place);
    for (const auto& [own, other] : { std::pair{ index, partner }, std::pair{ partner, index } })
    {
      auto& position = this->Positions[starts[shell]];
      ranks[own] = starts[shell]++;
      position.Index = own;
      position.Partner = other;
      position.Band = static_cast<std::uint8_t>(getBand(shell));
      const auto ownPlace = GetPlace(own, block);
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        position.Wave[axis] = GetWave(ownPlace[axis], block[axis]);
      }
      if (own == other)
      {
        break;
      }
      position.Flags |= own > other ? KnowsPartner : 0;
    }
  }

  this->Strides = { 1, static_cast<std::ptrdiff_t>(block[0]),
    static_cast<std::ptrdiff_t>(block[0]) * block[1] };
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    this->Wraps[axis] = -this->Strides[axis] * (static_cast<std::ptrdiff_t>(block[axis]) - 1);
  }
  for (std::uint32_t rank = 0; rank < count; ++rank)
  {
    auto& position = this->Positions[rank];
    const auto isKnown = [&](std::uint32_t index)
    { return ranks[index] < rank && ranks[index] / SegmentLength == rank / SegmentLength; };
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto wave = position.Wave[axis];
      if (wave == 0)
      {
        continue;
      }
      const auto inner =
        static_cast<std::uint32_t>(position.Index + this->GetStepInwards(axis, wave));
      if (isKnown(inner))
      {
        position.Flags |= static_cast<std::uint8_t>(KnowsInner << axis);
        if (isKnown(this->Positions[ranks[inner]].Partner))
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
}
}
