// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayRefresh_h
#define gatunRayRefresh_h

#include "gatunExport.h"
#include "gatunRayCaster.h"
#include "gatunRaySource.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/**
 * Updates an image when another mesh is drawn, such as another level of detail: only tiles that
 * change are drawn again. The image is the same to the last bit as if all tiles were drawn.
 */
class GATUN_EXPORT RayRefresh
{
public:
  /** Each call makes a caster with the same view, table, limits and settings; Repeatable. */
  using MakeCaster = std::function<std::unique_ptr<RayCaster>()>;

  explicit RayRefresh(MakeCaster makeCaster);

  /** Draws a mesh into rgba, which must hold the result of the last call; see RayCaster::Finish.
   * Returns the fraction of tiles that were drawn. After an exception, the next call draws
   * everything. The source is kept until the next call, which compares the two. */
  double Draw(
    std::shared_ptr<RaySource> source, float* rgba, const RaySource::Progress& progress = {});

private:
  MakeCaster Maker;
  std::shared_ptr<RaySource> Last;         // of the last image
  std::vector<std::uint64_t> Fingerprints; // of its tiles, or none yet
};
}

#endif
