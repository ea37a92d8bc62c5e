// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRelease.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
template <ReleaseFrom From>
void Release::Find(std::span<const RayBlock::Tet> neighbors, std::span<const std::uint8_t> facing)
{
  constexpr std::uint8_t taken = 16;
  auto& state = this->State;
  const auto isReady = [&](std::size_t tet)
  {
    const unsigned open = ~state[tet] & 15u;
    return (facing[tet] & open) == 0 ||
      (From == ReleaseFrom::Both && (facing[tet] >> 4 & open) == 0);
  };
  const auto take = [&](std::uint32_t tet)
  {
    state[tet] |= taken;
    this->Ready.push_back(tet);
  };
  std::size_t arrived = 0;
  const auto drawReady = [&]
  {
    while (!this->Ready.empty())
    {
      const auto tet = this->Ready.back();
      this->Ready.pop_back();
      this->Order.push_back(tet);
      for (const auto face : neighbors[tet])
      {
        const auto other = face / 4;
        if (face == RayBlock::NoNeighbor)
        {
          continue;
        }
        state[other] |= static_cast<std::uint8_t>(1u << face % 4);
        if (other < arrived && (state[other] & taken) == 0 && isReady(other))
        {
          take(other);
        }
      }
    }
  };
  while (arrived < neighbors.size())
  {
    const auto tet = arrived++;
    for (unsigned side = 0; side < 4; ++side)
    {
      const bool isBorder = neighbors[tet][side] == RayBlock::NoNeighbor;
      state[tet] |= static_cast<std::uint8_t>((isBorder ? 1u : 0u) << side);
    }
    if (isReady(tet))
    {
      take(static_cast<std::uint32_t>(tet));
      drawReady();
    }
    this->MostWaiting = std::max(this->MostWaiting, arrived - this->Order.size());
  }
  for (std::uint32_t tet = 0; this->Order.size() < neighbors.size(); ++tet)
  {
    if ((state[tet] & taken) == 0)
    {
      take(tet);
      drawReady();
    }
  }
}

//------------------------------------------------------------------------------
void Release::FindOrder(
  std::span<const RayBlock::Tet> neighbors, std::span<const std::uint8_t> facing, ReleaseFrom from)
{
  this->Order.clear();
  this->Order.reserve(neighbors.size());
  this->State.assign(neighbors.size(), 0);
  this->MostWaiting = 0;
  if (from == ReleaseFrom::Front)
  {
    this->Find<ReleaseFrom::Front>(neighbors, facing);
  }
  else
  {
    this->Find<ReleaseFrom::Both>(neighbors, facing);
  }
}
}
