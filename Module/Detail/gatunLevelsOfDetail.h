// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLevelsOfDetail_h
#define gatunLevelsOfDetail_h

#include "gatunDetailView.h"
#include "gatunExport.h"
#include "gatunRaySource.h"

#include <algorithm>
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
 * The levels of detail of a mesh: any number of points, from all of them to the fewest, the same
 * everywhere or finer where a view needs it.
 *
 * Only one thread at a time may call MakeLevel; other threads may call the other methods meanwhile.
 */
class GATUN_EXPORT LevelsOfDetail
{
public:
  virtual ~LevelsOfDetail() = default;

  virtual std::uint64_t GetNumberOfPoints() const = 0; ///< of the whole mesh
  virtual std::uint64_t GetFewestPoints() const = 0;   ///< of the coarsest level

  /** The nearest level that there is. With all points and no error it is the same for all views. */
  DetailRequest Clamp(const DetailRequest& wanted) const
  {
    const auto all = this->GetNumberOfPoints();
    const auto points = std::clamp(wanted.Points, this->GetFewestPoints(), all);
    const bool isWhole = points == all && !(wanted.View && wanted.View->PixelError > 0);
    return { points, isWhole ? nullptr : wanted.View };
  }

  /**
   * Returns the nearest level; a uniform one without a view or if the mesh is not simplified for
   * views. A source takes little time; its blocks are made when they are requested, and kept within
   * a budget. Two threads must not use the same source at the same time, but may use different
   * ones.
   *
   * Progress: of the preparation for views; if it returns false, Error(Aborted) is thrown.
   */
  virtual DetailLevel MakeLevel(
    const DetailRequest& request, const RaySource::Progress& progress) = 0;

  /** Estimates the number of tetrahedra of a level. */
  virtual std::uint64_t EstimateTets(std::uint64_t points) const = 0;
};
}

#endif
