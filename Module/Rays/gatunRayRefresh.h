// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayRefresh_h
#define gatunRayRefresh_h

#include "gatunRayCaster.h"
#include "gatunRaySource.h"
#include "vtkGatunCoreModule.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/**
 * A picture of which only those tiles are drawn anew that another mesh changes, as when a simpler
 * one takes the place of what was drawn. It is the same to the last bit as if all were drawn.
 */
class VTKGATUNCORE_EXPORT RayRefresh
{
public:
  /** Each call makes a caster with the same view, table, limits and settings; Repeatable. */
  using MakeCaster = std::function<std::unique_ptr<RayCaster>()>;

  explicit RayRefresh(MakeCaster makeCaster);

  /** Draws a mesh; see RayCaster::Finish for what becomes of rgba, which must be what the last call
   * left. If an exception is thrown, the next call draws everything. Returns the part of the tiles
   * that were drawn. The source is kept until the next call, which finds out what it showed. */
  double Draw(
    std::shared_ptr<RaySource> source, float* rgba, const RaySource::Progress& progress = {});

private:
  MakeCaster Maker;
  std::shared_ptr<RaySource> Last;         // of the last picture
  std::vector<std::uint64_t> Fingerprints; // of its tiles, or none yet
};
}

#endif
