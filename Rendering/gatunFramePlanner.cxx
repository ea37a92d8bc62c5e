// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFramePlanner.h"

#include "gatunFrameClock.h"

#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
float FramePlanner::ChooseDistance(const VolumeFrame& frame) const
{
  const VolumeSettings& settings = frame.GetSettings();
  if (!settings.AdjustsDistance)
  {
    return settings.Distance;
  }
  const auto known = this->TimeOfRays.find({ frame.GetRenderer(), frame.GetVolume() });
  const double allocated = frame.GetVolume()->GetAllocatedRenderTime();
  if (known == this->TimeOfRays.end() || !(allocated > 0))
  {
    return settings.LeastDistance;
  }
  const double all = known->second * frame.GetViewport().Width * frame.GetViewport().Height;
  const auto wanted = static_cast<float>(std::sqrt(all / allocated));
  return std::max(settings.LeastDistance, std::min(wanted, settings.LargestDistance));
}

//------------------------------------------------------------------------------
FramePlan FramePlanner::Choose(const VolumeFrame& frame, LevelOfDetailCache* levels,
  std::size_t merges, const Range& values, const RaySource::Progress& progress)
{
  FramePlan plan;
  if (levels)
  {
    const VolumeSettings& settings = frame.GetSettings();
    const DetailSettings& detail = settings.Detail;
    FrameRequest request;
    const double allocated = frame.GetVolume()->GetAllocatedRenderTime();
    if (detail.JustInTime && allocated > 0 && allocated < LeastTimeAtRest)
    {
      request.Budget = detail.TimeBudget > 0 ? detail.TimeBudget : allocated;
    }
    request.Ratio = detail.Ratio;
    request.Merges = merges;
    if ((request.Budget > 0 && detail.ViewDependent) || detail.PixelError > 0)
    {
      request.View = frame.MakeDetailView(values);
    }
    request.Pixels = static_cast<double>(frame.GetViewport().Width) * frame.GetViewport().Height;
    request.LeastDistance = settings.AdjustsDistance ? settings.LeastDistance : settings.Distance;
    request.LargestDistance = settings.AdjustsDistance
      ? std::max(settings.LeastDistance, settings.LargestDistance)
      : settings.Distance;
    plan.Detail =
      this->Frames[{ frame.GetRenderer(), frame.GetVolume() }].Begin(*levels, request, progress);
    plan.IsInMotion = request.Budget > 0;
  }
  plan.Distance =
    plan.IsInMotion ? static_cast<float>(plan.Detail.Distance) : this->ChooseDistance(frame);
  return plan;
}

//------------------------------------------------------------------------------
void FramePlanner::Learn(const VolumeFrame& frame, LevelOfDetailCache* levels,
  const FramePlan& plan, double rays, const RayStatistics& statistics, const FrameSeconds& seconds)
{
  const Key key{ frame.GetRenderer(), frame.GetVolume() };
  this->TimeOfRays[key] = seconds.All / rays;
  if (levels && frame.GetSettings().Detail.JustInTime)
  {
    this->Frames[key].End(*levels, plan.Detail, rays, statistics, seconds);
  }
}
}
