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
/**
 * A block as a view sees it: its tetrahedra in the order in which they are released, set up for
 * each tile that they reach. Only so many at a time are, so that a view from nearby, where each is
 * in many tiles, takes no more memory than one from afar.
 */
class RayBins
{
public:
  /** Brings a block into view; it must stay until another is. */
  void SetBlock(const RayKernel& kernel, const RayView& view, const RayTable& table,
    const RayBlock& block, RayFilter filter, ReleaseFrom from);

  /** Puts the next tetrahedra into the bins of the tiles; false when there are none left. Shading:
   * null for none. */
  bool Fill(const RayKernel& kernel, const SetUpContext& context, const RayShading* shading,
    std::size_t tiles);

  TetItems GetItems(std::size_t tile) const
  {
    const auto first = this->Starts[tile];
    const bool shaded = !this->Shades.empty();
    return { this->Items.data() + first, this->Starts[tile + 1] - first,
      shaded ? this->Origins.data() + first : nullptr, shaded ? this->Shades.data() : nullptr };
  }

  std::size_t GetNumberOfSeenTets() const { return this->Order.size(); }
  std::size_t GetMostWaiting() const { return this->Released.GetMostWaiting(); }
  std::size_t GetMemorySize() const;

private:
  static constexpr std::size_t MostItems = std::size_t{ 1 } << 17;

  const RayBlock* Block = nullptr;
  std::vector<RayPoint> Points;
  std::vector<SeenPoint> SeenPoints;
  std::vector<SeenTet> Seen;
  std::vector<std::uint8_t> Facing;
  Release Released;
  std::vector<std::uint32_t> Order;  // those that are seen
  std::size_t Next = 0;              // in the order
  std::vector<std::uint32_t> Starts; // of each tile's items
  std::vector<std::uint32_t> Places;
  std::vector<TetItem> Items;
  std::vector<std::uint32_t> Origins; // see TetItems
  std::vector<RayShade> Shades;
};
}

#endif
