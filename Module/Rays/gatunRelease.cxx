// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRelease.h"

#include <algorithm>

namespace gatun
{
namespace
{
// The state of a tetrahedron: its open faces, those towards the eye in bits 0 to 3 and, if rays
// grow from both ends, those away from it in bits 4 to 7; and whether it has been taken.
constexpr std::uint16_t Taken = 256;

/** The faces of a tetrahedron that have a neighbor. */
unsigned GetInnerFaces(const RayBlock::Tet& neighbors)
{
  unsigned inner = 0;
  for (unsigned side = 0; side < 4; ++side)
  {
    inner |= (neighbors[side] != RayBlock::NoNeighbor ? 1u : 0u) << side;
  }
  return inner;
}

template <ReleaseFrom From>
bool IsReady(unsigned state)
{
  return From == ReleaseFrom::Front ? state == 0
                                    : (state & Taken) == 0 && ((state & 15) == 0 || state < 16);
}
}

//------------------------------------------------------------------------------
template <ReleaseFrom From>
void Release::Find(std::span<const RayBlock::Tet> neighbors, std::span<const std::uint8_t> facing)
{
  const std::size_t count = neighbors.size();
  std::uint16_t* const state = this->State.data();
  std::uint32_t* const ready = this->Ready.data();
  std::uint32_t* const order = this->Order.data();
  constexpr unsigned tracked = From == ReleaseFrom::Front ? 15 : 255;
  for (std::size_t tet = 0; tet < count; ++tet)
  {
    const unsigned inner = GetInnerFaces(neighbors[tet]);
    state[tet] = static_cast<std::uint16_t>(facing[tet] & (inner | inner << 4) & tracked);
  }
  std::size_t arrived = 0;
  std::size_t drawn = 0;
  const auto drawFrom = [&](std::uint32_t first)
  {
    std::size_t n = 0;
    state[first] |= Taken;
    ready[n++] = first;
    while (n != 0)
    {
      const auto tet = ready[--n];
      order[drawn++] = tet;
      // Neighbors in front have been drawn before, unless rays grow from both ends or it is unknown
      // which are in front.
      const unsigned behind = facing[tet] >> 4;
      unsigned faces = From == ReleaseFrom::Front && facing[tet] != 0 ? behind : 15;
      for (; faces != 0; faces &= faces - 1)
      {
        const auto face = neighbors[tet][static_cast<unsigned>(__builtin_ctz(faces))];
        if (face == RayBlock::NoNeighbor)
        {
          continue;
        }
        const auto other = face / 4;
        const unsigned after = state[other] & ~(17u << face % 4);
        // Without a branch: whether it is ready cannot be predicted.
        const bool take = (other < arrived) & IsReady<From>(after);
        state[other] = static_cast<std::uint16_t>(after | (take ? Taken : 0u));
        ready[n] = other;
        n += take ? 1 : 0;
      }
    }
  };
  while (arrived < count)
  {
    const auto tet = static_cast<std::uint32_t>(arrived++);
    if (IsReady<From>(state[tet]))
    {
      drawFrom(tet);
    }
    this->MostWaiting = std::max(this->MostWaiting, arrived - drawn);
  }
  for (std::uint32_t tet = 0; tet < count && drawn < count; ++tet)
  {
    if ((state[tet] & Taken) == 0)
    {
      drawFrom(tet);
    }
  }
}

//------------------------------------------------------------------------------
void Release::FindOrder(
  std::span<const RayBlock::Tet> neighbors, std::span<const std::uint8_t> facing, ReleaseFrom from)
{
  this->Order.resize(neighbors.size());
  this->Ready.resize(neighbors.size() + 1); // one may be written without being counted
  this->State.resize(neighbors.size());
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
