// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayBins.h"

#include <algorithm>
#include <bit>

namespace gatun
{
//------------------------------------------------------------------------------
void RayBins::SetBlock(const RayKernel& kernel, const RayView& view, const RayTable& table,
  const RayBlock& block, RayFilter filter, ReleaseFrom from)
{
  this->Block = &block;
  this->Colors.clear();
  this->Points.resize(block.Points.size());
  this->SeenPoints.resize(block.Points.size());
  kernel.Transform(view, table.Low, table.Scale, block.Points.data(), block.Points.size(),
    this->Points.data(), this->SeenPoints.data());

  this->Seen.resize(block.Tets.size());
  this->Facing.resize(block.Tets.size());
  kernel.Look(view, filter, this->SeenPoints.data(), block.Tets.data(), block.Turned.data(),
    block.Tets.size(), this->Seen.data(), this->Facing.data());

  this->Released.FindOrder(block.Neighbors, this->Facing, from);
  this->Order.clear();
  for (const auto tet : this->Released.GetOrder())
  {
    if (!this->Seen[tet].IsEmpty())
    {
      this->Order.push_back(tet);
    }
  }
  this->Next = 0;
}

//------------------------------------------------------------------------------
bool RayBins::Fill(const RayKernel& kernel, const SetUpContext& context, const RayShading* shading,
  const RayColoring* coloring, std::size_t tiles, bool repeatable)
{
  this->Starts.assign(tiles + 1, 0);
  const auto first = this->Next;
  std::size_t items = 0;
  std::size_t reached = 0; // tiles, of which some may be opaque
  for (; this->Next < this->Order.size() && (repeatable ? reached : items) < MostItems;
       ++this->Next)
  {
    const SeenTet& seen = this->Seen[this->Order[this->Next]];
    reached +=
      static_cast<std::size_t>((seen.LastY / RayTile::Size - seen.FirstY / RayTile::Size + 1) *
        (seen.LastX / RayTile::Size - seen.FirstX / RayTile::Size + 1));
    ForEachTile(seen, context.TilesX, context.Limits,
      [&](int tile)
      {
        ++this->Starts[static_cast<std::size_t>(tile) + 1];
        ++items;
      });
  }
  for (std::size_t tile = 0; tile < tiles; ++tile)
  {
    this->Starts[tile + 1] += this->Starts[tile];
  }
  this->Places.assign(this->Starts.begin(), this->Starts.end() - 1);
  if (this->Items.size() < items)
  {
    this->Items.resize(items);
  }
  if (coloring && this->Colors.empty())
  {
    this->Colors = GetHueColors(*coloring, this->Block->Hues);
  }
  const bool hued = !this->Colors.empty();
  if (shading || hued)
  {
    this->Origins.resize(this->Items.size());
  }
  this->Shades.clear();
  this->Hues.clear();
  if (hued)
  {
    for (auto i = first; i < this->Next; ++i)
    {
      this->Hues.push_back(GetHue(*this->Block, this->Points, this->Colors, this->Order[i]));
    }
  }
  else if (shading)
  {
    this->Shades.resize(this->Next - first);
    for (auto i = first; i < this->Next; ++i)
    {
      this->Shades[i - first] = GetShade(*shading, *this->Block, this->Order[i]);
    }
  }
  const auto& cellValues = this->Block->CellValues;
  kernel.SetUp(context, this->Points.data(), this->Block->Tets.data(),
    cellValues.empty() ? nullptr : cellValues.data(), this->Seen.data(), this->Order.data() + first,
    this->Next - first, this->Places.data(), this->Items.data(),
    shading || hued ? this->Origins.data() : nullptr);
  return this->Next > first;
}

//------------------------------------------------------------------------------
void RayBins::FingerprintPoints()
{
  this->Fingerprints.resize(this->Points.size());
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const RayPoint& p = this->Points[i];
    std::uint64_t mixed = 0;
    for (const double number : { p.X, p.Y, p.Z, p.Value })
    {
      mixed = MixFingerprints(mixed, std::bit_cast<std::uint64_t>(number));
    }
    this->Fingerprints[i] = mixed;
  }
  const RayHues& hues = this->Block->Hues;
  for (std::size_t i = 0; !hues.OfCells && i < hues.Values.size(); ++i)
  {
    std::uint64_t& mixed = this->Fingerprints[i / hues.Channels];
    mixed = MixFingerprints(mixed, std::bit_cast<std::uint64_t>(hues.Values[i]));
  }
}

//------------------------------------------------------------------------------
std::uint64_t RayBins::GetFingerprint(std::uint32_t tet) const
{
  const RayBlock& block = *this->Block;
  std::uint64_t mixed = block.Turned[tet];
  for (const auto point : block.Tets[tet])
  {
    mixed = MixFingerprints(mixed, this->Fingerprints[point]);
  }
  if (!block.CellValues.empty())
  {
    mixed = MixFingerprints(mixed, std::bit_cast<std::uint64_t>(block.CellValues[tet]));
  }
  const RayHues& hues = block.Hues;
  for (std::size_t c = 0; hues.OfCells && c < hues.Channels; ++c)
  {
    const double value = hues.Values[tet * hues.Channels + c];
    mixed = MixFingerprints(mixed, std::bit_cast<std::uint64_t>(value));
  }
  return mixed;
}

//------------------------------------------------------------------------------
std::size_t RayBins::GetMemorySize() const
{
  return this->Points.capacity() * sizeof(RayPoint) + this->Fingerprints.capacity() * 8 +
    this->SeenPoints.capacity() * sizeof(SeenPoint) + this->Seen.capacity() * sizeof(SeenTet) +
    this->Facing.capacity() + this->Released.GetMemorySize() +
    (this->Order.capacity() + this->Starts.capacity() + this->Places.capacity() +
      this->Origins.capacity()) *
    4 +
    this->Items.capacity() * sizeof(TetItem) + this->Shades.capacity() * sizeof(RayShade) +
    this->Colors.capacity() * sizeof(RayColoring::Color) + this->Hues.capacity() * sizeof(RayHue);
}
}
