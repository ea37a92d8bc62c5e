// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayFragments.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <vector>

namespace gatun
{
namespace
{
template <typename T>
void PutAll(const std::vector<T>& values, ByteWriter& bytes)
{
  bytes.PutBytes(
    { reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T) });
}

/** The fragments of a tile that show something, in the order of cells. */
class TileFragments
{
public:
  explicit TileFragments(RayTile& tile)
    : Tile(tile)
  {
    tile.Consolidate();
  }

  /** Those of a cell; cells must be asked for in order. */
  std::span<const Fragment> Get(int cell)
  {
    this->Found.clear();
    this->Add(this->Tile.Get(0, cell));
    this->Add(this->Tile.Get(1, cell));
    const auto& others = this->Tile.Others;
    for (; this->Next < others.size() && others[this->Next].Cell == static_cast<unsigned>(cell);
         ++this->Next)
    {
      this->Add(others[this->Next]);
    }
    return this->Found;
  }

private:
  void Add(const Fragment& fragment)
  {
    if (fragment.End != RayTile::Never && fragment.Sum[3] != 1)
    {
      this->Found.push_back(fragment);
    }
  }

  RayTile& Tile;
  std::size_t Next = 0;
  std::vector<Fragment> Found;
};

/** A color of a fragment in proportion to its opacity. */
std::uint16_t ToProportion(float color, float opacity)
{
  const float proportion = color / opacity;
  const float inRange = proportion > 0 ? std::min(proportion, 1.0f) : 0.0f;
  return static_cast<std::uint16_t>(inRange * 65535 + 0.5f);
}

void WriteLists(RayTile& tile, bool withDepths, ByteWriter& bytes)
{
  TileFragments fragments(tile);
  std::vector<float> begins;
  std::vector<float> opacities;
  std::vector<std::array<std::uint16_t, 3>> colors;
  std::vector<float> depths;
  for (int cell = 0; cell < RayTile::Pixels; ++cell)
  {
    const auto ofCell = fragments.Get(cell);
    bytes.PutVarint(ofCell.size());
    float first = -RayTile::Never;
    for (const Fragment& fragment : ofCell)
    {
      begins.push_back(fragment.Begin);
      const float opacity = 1 - fragment.Sum[3];
      opacities.push_back(opacity);
      colors.push_back({ ToProportion(fragment.Sum[0], opacity),
        ToProportion(fragment.Sum[1], opacity), ToProportion(fragment.Sum[2], opacity) });
      first = std::min(first, fragment.First);
    }
    if (withDepths && !ofCell.empty())
    {
      depths.push_back(first);
    }
  }
  PutAll(begins, bytes);
  PutAll(opacities, bytes);
  PutAll(colors, bytes);
  PutAll(depths, bytes);
}

void WriteLargest(const RayTile& tile, ByteWriter& bytes)
{
  std::vector<float> places;
  for (int cell = 0; cell < RayTile::Pixels; ++cell)
  {
    const float largest = tile.Get(0, cell).End;
    const bool isThere = largest != RayTile::Never;
    bytes.PutVarint(isThere ? 1 : 0);
    if (isThere)
    {
      places.push_back(largest);
    }
  }
  PutAll(places, bytes);
}

void WriteSums(const RayTile& tile, ByteWriter& bytes)
{
  std::vector<std::array<float, 4>> sums;
  for (int cell = 0; cell < RayTile::Pixels; ++cell)
  {
    const Fragment sum = tile.Get(0, cell);
    const float depth = sum.Sum[3] - 1;
    bytes.PutVarint(depth > 0 ? 1 : 0);
    if (depth > 0)
    {
      sums.push_back({ sum.Sum[0], sum.Sum[1], sum.Sum[2], depth });
    }
  }
  PutAll(sums, bytes);
}
}

//------------------------------------------------------------------------------
void WriteFragments(
  RayMode mode, std::size_t index, RayTile& tile, bool withDepths, ByteWriter& bytes)
{
  const auto start = bytes.Data.size();
  const bool hasLists = mode == RayMode::Composite || mode == RayMode::Sampled;
  const bool hasDepths = withDepths && hasLists;
  bytes.Put(static_cast<std::uint32_t>(2 * index + (hasDepths ? 1 : 0)));
  bytes.Put(std::uint32_t{ 0 });
  const auto begin = bytes.Data.size();
  if (hasLists)
  {
    WriteLists(tile, hasDepths, bytes);
  }
  else if (mode == RayMode::Maximum)
  {
    WriteLargest(tile, bytes);
  }
  else
  {
    WriteSums(tile, bytes);
  }
  const auto size = static_cast<std::uint32_t>(bytes.Data.size() - begin);
  if (size == static_cast<std::uint32_t>(RayTile::Pixels))
  {
    bytes.Data.resize(start); // nothing but zeros
    return;
  }
  std::memcpy(bytes.Data.data() + begin - sizeof(size), &size, sizeof(size));
}
}
