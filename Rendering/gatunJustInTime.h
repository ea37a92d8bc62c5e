// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunJustInTime_h
#define gatunJustInTime_h

#include "gatunFrameBudget.h"
#include "gatunLevelOfDetailCache.h"
#include "gatunRayCaster.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/** The requirements of a frame. */
struct FrameRequest
{
  double Budget = 0;        ///< seconds that it may take; 0: all that it needs
  double Ratio = 0;         ///< fraction of points removed in any case
  std::uint64_t Merges = 0; ///< number of points removed in any case

  /** Where detail is needed: in motion, and at rest if it has a pixel error or a region. Null:
   * everywhere the same. */
  std::shared_ptr<const DetailView> View;

  /** Whether to wait for the level that is best, in motion too, instead of taking a ready one. */
  bool Waits = false;

  double Pixels = 0;
  double LeastDistance = 1; ///< of rays
  double LargestDistance = 1;
};

/** How it is drawn. */
struct Frame
{
  std::shared_ptr<RaySource> Source;
  std::uint64_t Points = 0;     ///< 0: all; how many there are is not known yet
  DetailRequest Level;          ///< what was asked for; no points: the whole mesh
  std::uint64_t NextPoints = 0; ///< of the level for this view that is being prepared; 0: none
  double Distance = 1;          ///< of rays, in pixels
};

/** Seconds that an image took. */
struct FrameSeconds
{
  double Cast = 0; ///< by the ray caster
  double All = 0;
};

/**
 * Images of one volume in one renderer, each with as many points and rays as there is time for.
 * What is likely to be wanted next is made ready in the background.
 */
class JustInTime
{
public:
  /** Progress: while it has to be found out how the mesh can be simplified, which only a ratio
   * needs at once. Throws InvalidInput for a ratio that is none. */
  Frame Begin(
    LevelOfDetailCache& levels, const FrameRequest& request, const RaySource::Progress& progress);

  /** The image has been drawn, with so many rays. */
  void End(LevelOfDetailCache& levels, const Frame& frame, double rays,
    const RayStatistics& statistics, const FrameSeconds& seconds);

private:
  Frame ChooseInMotion(LevelOfDetailCache& levels, const FrameRequest& request);
  FrameLimits GetLimits(const LevelsOfDetail* detail, const FrameRequest& request) const;

  FrameBudget Budget;
  FrameChoice Present;       // of the last image in motion
  FrameRequest Request;      // of this one
  double MotionBudget = 0.1; // of the last image in motion
  std::uint64_t Last = 0;    // points of the last image
  double AllTets = 0;        // of the whole mesh, once they were drawn
};
}

#endif
