// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayMerger_h
#define gatunRayMerger_h

#include "gatunExport.h"
#include "gatunRayTable.h"
#include "gatunRayView.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Merges the fragments of several RayCasters into pixels. Each has drawn a part of the cells, with
 * the same view, table, limits and settings. The parts need not be compact: the image is that of
 * one RayCaster with all cells, except for rounding. Fragments that overlap are drawn in the order
 * in which they begin, as RayCaster does.
 *
 * Memory: that of the messages.
 */
class GATUN_EXPORT RayMerger
{
public:
  /** The arguments must exist as long as this object. */
  RayMerger(const RayView& view, const RayTable& table);

  std::size_t GetNumberOfTiles() const { return this->Parts.size(); }

  /** Takes a result of RayCaster::TakeFragments. Throws Corrupt for anything else. */
  void Add(std::vector<std::uint8_t> message);

  /** Writes some tiles of the image; see RayCaster::Finish. With depths, these must have been
   * taken. */
  void Finish(std::span<const std::size_t> tiles, float* rgba, float* depth = nullptr) const;

private:
  void FinishTile(std::size_t tile, float* rgba, float* depth) const;

  const RayView& View;
  const RayTable& Table;
  std::size_t TilesX;
  std::vector<std::vector<std::uint8_t>> Messages;

  /** The fragments that a message has for a tile. */
  struct Part
  {
    std::span<const std::uint8_t> Content;
    bool HasDepths = false;
  };
  std::vector<std::vector<Part>> Parts; // of each tile
};
}

#endif
