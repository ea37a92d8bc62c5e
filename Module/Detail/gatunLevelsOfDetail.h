// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLevelsOfDetail_h
#define gatunLevelsOfDetail_h

#include "gatunDetailView.h"
#include "gatunExport.h"
#include "gatunRaySource.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/** A mesh that is simplified, uniformly or for a view. */
struct DetailLevel
{
  std::shared_ptr<RaySource> Source;
  std::uint64_t Points = 0; ///< that are left
  std::uint64_t Bytes = 0;  ///< that the source takes without its blocks, about
};

/**
 * The levels of detail of a mesh: any number of points, from all of them to the fewest.
 *
 * Only one thread at a time may call MakeSource; other threads may call the other methods
 * meanwhile.
 */
class GATUN_EXPORT LevelsOfDetail
{
public:
  /** The finest places of a mesh for a view are those of a uniform mesh with this factor times its
   * points. */
  static constexpr std::uint64_t FinestToUniform = 8;

  virtual ~LevelsOfDetail() = default;

  virtual std::uint64_t GetNumberOfPoints() const = 0; ///< of the whole mesh
  virtual std::uint64_t GetFewestPoints() const = 0;   ///< of the coarsest level

  /**
   * Returns the level with a given number of points, or the nearest one. A source takes little
   * time; its blocks are made when they are requested, and kept within a budget in bytes. Two
   * threads must not use the same source at the same time, but may use different ones.
   */
  virtual std::shared_ptr<RaySource> MakeSource(std::uint64_t points, std::uint64_t budget) = 0;

  /**
   * Returns a level for a view, or a uniform level without a view or if the mesh is not simplified
   * for views. Progress: of the preparation for views; if it returns false, Error(Aborted) is
   * thrown.
   */
  virtual DetailLevel MakeLevel(
    const DetailRequest& request, std::uint64_t budget, const RaySource::Progress& progress)
  {
    (void)progress;
    return { this->MakeSource(request.Points, budget), request.Points };
  }

  /** Estimates the number of tetrahedra of a level. */
  virtual std::uint64_t EstimateTets(std::uint64_t points) const = 0;
};
}

#endif
