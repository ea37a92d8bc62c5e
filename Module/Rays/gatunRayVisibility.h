// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayVisibility_h
#define gatunRayVisibility_h

#include "gatunRaySource.h"
#include "gatunRayTable.h"
#include "gatunRayView.h"

#include <cstddef>
#include <vector>

namespace gatun
{
/** The projection of a box. */
struct SeenBox
{
  bool IsOutside = false;
  double FirstX = 0, FirstY = 0, LastX = 0, LastY = 0; // pixels
  double Nearest = 0, Farthest = 0;                    // depth in units of z in ray coordinates
};

/** Finds the blocks that may be visible in an image. Parts of the image may have been drawn. */
class RayVisibility
{
public:
  /** The arguments must exist as long as this object. */
  RayVisibility(const RayView& view, const RayTable& table, const RayLimits& limits);

  /** Sets the depth in samples behind which nothing is visible in a tile. */
  void SetTileLimit(std::size_t tile, float limit) { this->TileLimits[tile] = limit; }
  const float* GetTileLimits() const { return this->TileLimits.data(); }

  /** Whether the image so far hides a box, all of which would be visible otherwise. */
  bool IsCovered(const Bounds& box) const;

  /** Returns the blocks of a source that may be visible, the nearest first, regardless of tile
   * limits. Throws InvalidInput if there are too many samples in front of the farthest one. */
  std::vector<std::size_t> FindCandidates(const RaySource& source) const;

private:
  /** Finds the depth behind which blocks need not be fetched, with a margin of a sample. */
  void LimitTiles();

  /** Whether a box is invisible, whatever its values and other blocks are. */
  bool IsOutOfView(const Bounds& box) const;

  /** Whether a box is entirely on the negative side of a plane, even after rounding errors. */
  bool IsCutAway(const Bounds& box) const;

  SeenBox See(const Bounds& box) const;

  /** Throws if there are too many samples up to a depth, in units of z in ray coordinates. */
  void RequireFewSamples(double farthest) const;

  std::size_t GetTile(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(this->TilesX) +
      static_cast<std::size_t>(x);
  }

  const RayView& View;
  const RayTable& Table;
  const RayLimits& Limits;
  int TilesX;
  int TilesY;
  std::vector<float> TileLimits;
  double MostPerDepth = 0; // samples; maximum over all pixels
};
}

#endif
