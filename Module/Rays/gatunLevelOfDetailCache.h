// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLevelOfDetailCache_h
#define gatunLevelOfDetailCache_h

#include "gatunLevelsOfDetail.h"
#include "gatunRaySource.h"
#include "vtkGatunCoreModule.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/**
 * A mesh with several numbers of points, ready for drawing. Those that were not used for longest go
 * first when there is no more room.
 *
 * A thread in the background finds out first how the mesh can be simplified, makes one ready that
 * is simple enough to be drawn at once, and then what is wanted next. While pictures are drawn, it
 * rests as long as it works. It stops within a block's time when something else is wanted, and when
 * this is destroyed. All methods are for one thread.
 */
class VTKGATUNCORE_EXPORT LevelOfDetailCache
{
public:
  using Progress = RaySource::Progress;

  /** Called in the background; see BuildMergeTree for what becomes of progress. */
  using MakeLevels = std::function<std::shared_ptr<LevelsOfDetail>(const Progress& progress)>;

  /** How many bytes may be used. */
  struct Room
  {
    std::uint64_t Whole = 0;   ///< for blocks of the whole mesh, which its source keeps
    std::uint64_t Simpler = 0; ///< for those of simpler ones
  };

  /** Whole: what is drawn of all points. */
  LevelOfDetailCache(MakeLevels makeLevels, std::shared_ptr<RaySource> whole, const Room& room);
  ~LevelOfDetailCache();
  LevelOfDetailCache(const LevelOfDetailCache&) = delete;
  LevelOfDetailCache& operator=(const LevelOfDetailCache&) = delete;

  /** How the mesh can be simplified; null while that is not known. Throws what making it threw. */
  LevelsOfDetail* FindLevels() const;

  /** The same, once it is known. Progress: how far that is; if it returns false, Error(Aborted) is
   * thrown, but work goes on. */
  LevelsOfDetail& WaitForLevels(const Progress& progress = {});

  /** All of the mesh. */
  std::shared_ptr<RaySource> GetWhole();

  /** The mesh with so many points. What is not there is made now, while the background rests. The
   * detail must be known. */
  std::shared_ptr<RaySource> Get(std::uint64_t points);

  /** Of what is ready and simpler than the whole mesh, the number of points that comes nearest; 0
   * for none. One that has more than wanted counts as twice as far away. */
  std::uint64_t FindReady(std::uint64_t wanted) const;

  /** Has these made ready, one after the other, in place of what was wanted before. Those for which
   * there is no room are left out. Does nothing while the detail is not known. */
  void Prepare(const std::vector<std::uint64_t>& points);

  /** Tells whether a picture is being drawn. */
  void SetDrawing(bool drawing);

  /** Waits until all that is wanted is ready. */
  void Wait();

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
