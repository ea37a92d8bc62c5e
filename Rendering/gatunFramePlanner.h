// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFramePlanner_h
#define gatunFramePlanner_h

#include "gatunJustInTime.h"
#include "gatunLevelOfDetailCache.h"
#include "gatunVolumeFrame.h"

#include <cstddef>
#include <map>
#include <utility>

namespace gatun
{
/** The rays and the level of detail of an image. */
struct FramePlan
{
  Frame Detail;
  float Distance = 1; ///< of rays, in pixels
  bool IsInMotion = false;
};

/** Chooses the rays and the levels of detail of images in any number of renderers, from the times
 * of the images before. */
class FramePlanner
{
public:
  /** Levels: null if the mesh is not simplified. Merges: those that the input asks for. Values: the
   * range of all. Progress: while it is found out how the mesh can be simplified. */
  FramePlan Choose(const VolumeFrame& frame, LevelOfDetailCache* levels, std::size_t merges,
    const Range& values, const RaySource::Progress& progress);

  /** An image was drawn with so many rays. Levels: null if its level was not chosen here. */
  void Learn(const VolumeFrame& frame, LevelOfDetailCache* levels, const FramePlan& plan,
    double rays, const RayStatistics& statistics, const FrameSeconds& seconds);

private:
  using Key = std::pair<const void*, const void*>; // renderer and volume

  float ChooseDistance(const VolumeFrame& frame) const;

  std::map<Key, double> TimeOfRays; // seconds for each ray of the last image
  std::map<Key, JustInTime> Frames;
};

/** Tells the threads in the background that a frame is being drawn. */
class FrameNotice
{
public:
  /** Levels: null if there are none. */
  explicit FrameNotice(LevelOfDetailCache* levels)
    : Levels(levels)
  {
    this->Tell(true);
  }
  ~FrameNotice() { this->Tell(false); }
  FrameNotice(const FrameNotice&) = delete;
  FrameNotice& operator=(const FrameNotice&) = delete;

private:
  void Tell(bool drawing)
  {
    if (this->Levels)
    {
      this->Levels->SetDrawing(drawing);
    }
  }

  LevelOfDetailCache* const Levels;
};
}

#endif
