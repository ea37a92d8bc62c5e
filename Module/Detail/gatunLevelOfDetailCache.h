// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLevelOfDetailCache_h
#define gatunLevelOfDetailCache_h

#include "gatunExport.h"
#include "gatunLevelsOfDetail.h"
#include "gatunRaySource.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/**
 * Levels of detail of a mesh that are ready for drawing. When the budget is used up, the least
 * recently used levels are removed.
 *
 * A background thread first determines how the mesh can be simplified, then prepares a level that
 * is coarse enough to be drawn at once, then the levels that are requested. While frames are drawn,
 * it rests as long as it works. It stops within the time of a block when other levels are requested
 * and when this object is destroyed. All methods must be called from one thread.
 */
class GATUN_EXPORT LevelOfDetailCache
{
public:
  using Progress = RaySource::Progress;

  /** Called in the background. Must call progress; see BuildMergeTree. */
  using MakeLevels = std::function<std::shared_ptr<LevelsOfDetail>(const Progress& progress)>;

  /** Budgets in bytes. */
  struct Limits
  {
    std::uint64_t Whole = 0;   ///< for blocks of the whole mesh, which its source keeps
    std::uint64_t Simpler = 0; ///< for blocks of coarser levels
  };

  /** Whole: the source of the whole mesh. */
  LevelOfDetailCache(MakeLevels makeLevels, std::shared_ptr<RaySource> whole, const Limits& limits);
  ~LevelOfDetailCache();
  LevelOfDetailCache(const LevelOfDetailCache&) = delete;
  LevelOfDetailCache& operator=(const LevelOfDetailCache&) = delete;

  /** Returns the levels of detail, or null while they are not known. Throws the exception of
   * makeLevels. */
  LevelsOfDetail* FindLevels() const;

  /** Waits until the levels of detail are known. If progress returns false, Error(Aborted) is
   * thrown, and the work continues in the background. */
  LevelsOfDetail& WaitForLevels(const Progress& progress = {});

  /** Returns the whole mesh. */
  std::shared_ptr<RaySource> GetWhole();

  /** Returns a level. If it is not ready, it is made now, while the background thread rests. The
   * levels of detail must be known. */
  DetailLevel Get(const DetailRequest& wanted);

  /** Returns the nearest ready level that is coarser than the whole mesh; none, with 0 points, if
   * there is none. The distance of a level with more points than wanted counts twice. For a view,
   * levels for recent views are nearer, and after many views so are uniform levels. */
  DetailRequest FindReady(const DetailRequest& wanted) const;

  /** Requests levels, which are prepared one after the other; replaces earlier requests. Levels
   * that do not fit are skipped. A level for a view that is being made is completed if one for
   * another view is wanted in its place. Does nothing while the levels of detail are not known. */
  void Prepare(const std::vector<DetailRequest>& wanted);

  /** States whether a frame is being drawn. */
  void SetDrawing(bool drawing);

  /** Waits until all requested levels are ready. */
  void Wait();

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
