// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayMerger.h"

#include "gatunParallel.h"
#include "gatunRayFragments.h"
#include "gatunRayPixel.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace gatun
{
namespace
{
constexpr auto Pixels = static_cast<std::size_t>(RayTile::Pixels);

template <typename T>
T ReadAt(std::span<const std::uint8_t> values, std::size_t index)
{
  T value;
  std::memcpy(&value, values.data() + index * sizeof(T), sizeof(T));
  return value;
}

/** The fragments of a tile that one message has. */
class PartReader
{
public:
  PartReader(RayMode mode, std::span<const std::uint8_t> content, bool hasDepths)
    : Mode(mode)
  {
    const bool hasLists = mode == RayMode::Composite || mode == RayMode::Sampled;
    ByteReader reader(content);
    std::uint64_t cells = 0;
    for (std::size_t cell = 0; cell < Pixels; ++cell)
    {
      const std::uint64_t count = reader.GetVarint();
      if (count > (hasLists ? content.size() : 1))
      {
        ThrowCorrupt("a pixel has too many fragments");
      }
      this->First[cell + 1] = this->First[cell] + static_cast<std::size_t>(count);
      this->Filled[cell] = static_cast<std::size_t>(cells);
      cells += count > 0 ? 1 : 0;
    }
    const std::uint64_t fragments = this->First[Pixels];
    if (hasLists)
    {
      this->Numbers = reader.GetBytes(fragments * sizeof(float));
      this->Opacities = reader.GetBytes(fragments * sizeof(float));
      this->Colors = reader.GetBytes(fragments * sizeof(std::array<std::uint16_t, 3>));
    }
    else
    {
      this->Numbers = reader.GetBytes(fragments * sizeof(float) * (mode == RayMode::XRay ? 4 : 1));
    }
    if (hasDepths)
    {
      this->Depths = reader.GetBytes(cells * sizeof(float));
    }
    if (reader.GetRemaining() != 0)
    {
      ThrowCorrupt("there are bytes behind the fragments of a tile");
    }
  }

  /** Adds the fragments of a cell. */
  void Get(std::size_t cell, std::vector<Fragment>& fragments) const
  {
    const float depth = this->Depths.empty() || this->First[cell] == this->First[cell + 1]
      ? -RayTile::Never
      : ReadAt<float>(this->Depths, this->Filled[cell]);
    for (std::size_t i = this->First[cell]; i < this->First[cell + 1]; ++i)
    {
      Fragment& fragment = fragments.emplace_back(NoFragment());
      fragment.First = depth;
      if (this->Mode == RayMode::Maximum)
      {
        // Checked, as it is a place in a table; NaN too.
        const auto place = ReadAt<float>(this->Numbers, i);
        if (!(place >= 0 && place <= static_cast<float>(RayTable::Size)))
        {
          ThrowCorrupt("a value is beyond the table");
        }
        fragment.End = place;
      }
      else if (this->Mode == RayMode::XRay)
      {
        fragment.Sum = ReadAt<std::array<float, 4>>(this->Numbers, i);
      }
      else
      {
        fragment.Begin = ReadAt<float>(this->Numbers, i);
        const auto opacity = ReadAt<float>(this->Opacities, i);
        const auto color = ReadAt<std::array<std::uint16_t, 3>>(this->Colors, i);
        for (std::size_t c = 0; c < 3; ++c)
        {
          fragment.Sum[c] = static_cast<float>(color[c]) / 65535 * opacity;
        }
        fragment.Sum[3] = 1 - opacity;
      }
    }
  }

private:
  RayMode Mode;
  std::array<std::size_t, Pixels + 1> First{}; // fragment of each cell
  std::array<std::size_t, Pixels> Filled{};    // how many cells before each have any
  std::span<const std::uint8_t> Numbers, Opacities, Colors, Depths;
};

/** The sum of the fragments of a pixel. */
Fragment Sum(RayMode mode, std::vector<Fragment>& fragments)
{
  if (mode == RayMode::Composite || mode == RayMode::Sampled)
  {
    return CompositeFragments(fragments);
  }
  Fragment sum = NoFragment();
  sum.End = RayTile::Never;
  for (const Fragment& fragment : fragments)
  {
    sum.End = std::max(sum.End, fragment.End);
    for (std::size_t i = 0; i < 4; ++i)
    {
      sum.Sum[i] += fragment.Sum[i];
    }
  }
  return sum;
}
}

//------------------------------------------------------------------------------
RayMerger::RayMerger(const RayView& view, const RayTable& table)
  : View(view)
  , Table(table)
  , TilesX(static_cast<std::size_t>((view.Width + RayTile::Size - 1) / RayTile::Size))
  , Parts(
      this->TilesX * static_cast<std::size_t>((view.Height + RayTile::Size - 1) / RayTile::Size))
{
}

//------------------------------------------------------------------------------
void RayMerger::Add(std::vector<std::uint8_t> message)
{
  // Its bytes stay where they are, even if the list of messages grows.
  const auto& kept = this->Messages.emplace_back(std::move(message));
  ByteReader reader(kept);
  while (reader.GetRemaining() > 0)
  {
    const auto number = reader.Get<std::uint32_t>();
    const auto content = reader.GetBytes(reader.Get<std::uint32_t>());
    if (number / 2 >= this->Parts.size())
    {
      ThrowCorrupt("there are fragments of a tile beyond the image");
    }
    this->Parts[number / 2].push_back({ content, number % 2 != 0 });
  }
}

//------------------------------------------------------------------------------
void RayMerger::FinishTile(std::size_t tile, float* rgba, float* depth) const
{
  std::vector<PartReader> readers;
  readers.reserve(this->Parts[tile].size());
  for (const Part& part : this->Parts[tile])
  {
    readers.emplace_back(this->Table.Mode, part.Content, part.HasDepths);
  }
  const int x0 = static_cast<int>(tile % this->TilesX) * RayTile::Size;
  const int y0 = static_cast<int>(tile / this->TilesX) * RayTile::Size;
  std::vector<Fragment> fragments;
  for (int cell = 0; cell < RayTile::Pixels; ++cell)
  {
    const int x = x0 + RayTile::ToX(cell);
    const int y = y0 + RayTile::ToY(cell);
    if (x >= this->View.Width || y >= this->View.Height)
    {
      continue;
    }
    fragments.clear();
    for (const PartReader& reader : readers)
    {
      reader.Get(static_cast<std::size_t>(cell), fragments);
    }
    const Fragment sum = Sum(this->Table.Mode, fragments);
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(this->View.Width) +
      static_cast<std::size_t>(x);
    ToPixel(this->Table, sum, sum.End, rgba + 4 * at);
    if (depth)
    {
      depth[at] = sum.First == -RayTile::Never
        ? std::numeric_limits<float>::infinity()
        : static_cast<float>(sum.First * this->View.SampleDistance);
    }
  }
}

//------------------------------------------------------------------------------
void RayMerger::Finish(std::span<const std::size_t> tiles, float* rgba, float* depth) const
{
  ParallelFor(tiles.size(), [&](std::size_t i) { this->FinishTile(tiles[i], rgba, depth); });
}
}
