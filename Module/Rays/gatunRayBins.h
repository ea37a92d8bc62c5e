// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayBins_h
#define gatunRayBins_h

#include "gatunRayBlock.h"
#include "gatunRayKernel.h"
#include "gatunRelease.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The hash of a sequence, from that of its beginning and its next element. */
inline std::uint64_t MixFingerprints(std::uint64_t before, std::uint64_t next)
{
  std::uint64_t mixed = (before ^ next) * 0x9e3779b97f4a7c15u;
  mixed = (mixed ^ mixed >> 32) * 0xd6e8feb86659fd93u;
  return (mixed ^ mixed >> 29) + (before << 1 | before >> 63);
}

/**
 * The tetrahedra of a block in a view, in the order of their release, set up for each tile that
 * they reach. They are set up in batches of limited size: a close view, in which each tetrahedron
 * reaches many tiles, needs no more memory than a distant one.
 */
class RayBins
{
public:
  /** Projects a block. The block must exist until the next call. */
  void SetBlock(const RayKernel& kernel, const RayView& view, const RayTable& table,
    const RayBlock& block, RayFilter filter, ReleaseFrom from);

  /** Calls use(tile, fingerprint) for each item that Fill would make next if nothing were opaque,
   * in the order of each tile. Returns false when there are none left. */
  template <typename Use>
  bool Skim(int tilesX, Use&& use);

  /** Puts the next tetrahedra into the bins of the tiles. Returns false when there are none left.
   * Shading may be null, and so may the coloring, which replaces it in blocks with hues. */
  bool Fill(const RayKernel& kernel, const SetUpContext& context, const RayShading* shading,
    const RayColoring* coloring, std::size_t tiles, bool repeatable);

  TetItems GetItems(std::size_t tile) const
  {
    const auto first = this->Starts[tile];
    const bool shaded = !this->Shades.empty();
    const bool hued = !this->Hues.empty();
    return { this->Items.data() + first, this->Starts[tile + 1] - first,
      shaded || hued ? this->Origins.data() + first : nullptr,
      shaded ? this->Shades.data() : nullptr, hued ? this->Hues.data() : nullptr, 0, 0 };
  }

  std::size_t GetNumberOfSeenTets() const { return this->Order.size(); }
  std::size_t GetMostWaiting() const { return this->Released.GetMostWaiting(); }
  std::size_t GetMemorySize() const;

private:
  static constexpr std::size_t MostItems = std::size_t{ 1 } << 17;

  void FingerprintPoints();
  std::uint64_t GetFingerprint(std::uint32_t tet) const;

  const RayBlock* Block = nullptr;
  std::vector<RayPoint> Points;
  std::vector<std::uint64_t> Fingerprints; // of points
  std::vector<SeenPoint> SeenPoints;
  std::vector<SeenTet> Seen;
  std::vector<std::uint8_t> Facing;
  Release Released;
  std::vector<std::uint32_t> Order;  // visible tetrahedra
  std::size_t Next = 0;              // in the order
  std::vector<std::uint32_t> Starts; // of the items of each tile
  std::vector<std::uint32_t> Places;
  std::vector<TetItem> Items;
  std::vector<std::uint32_t> Origins; // see TetItems
  std::vector<RayShade> Shades;
  std::vector<RayColoring::Color> Colors; // of the block's hues
  std::vector<RayHue> Hues;
};

//------------------------------------------------------------------------------
template <typename Use>
bool RayBins::Skim(int tilesX, Use&& use)
{
  if (this->Next == 0)
  {
    this->FingerprintPoints();
  }
  const auto first = this->Next;
  for (std::size_t items = 0; this->Next < this->Order.size() && items < MostItems; ++this->Next)
  {
    const auto tet = this->Order[this->Next];
    const SeenTet& seen = this->Seen[tet];
    const auto fingerprint = this->GetFingerprint(tet);
    for (int y = seen.FirstY / RayTile::Size; y <= seen.LastY / RayTile::Size; ++y)
    {
      for (int x = seen.FirstX / RayTile::Size; x <= seen.LastX / RayTile::Size; ++x)
      {
        use(static_cast<std::size_t>(y * tilesX + x), fingerprint);
        ++items;
      }
    }
  }
  return this->Next > first;
}
}

#endif
