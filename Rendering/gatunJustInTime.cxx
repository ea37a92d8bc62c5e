// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunJustInTime.h"

#include "gatunError.h"
#include "gatunSimplifyTarget.h"

#include <algorithm>

namespace gatun
{
namespace
{
/** The number of points that a request leaves at most. */
std::uint64_t CountPoints(const LevelsOfDetail& detail, const FrameRequest& request)
{
  const auto all = detail.GetNumberOfPoints();
  const auto most = all - detail.GetFewestPoints();
  const std::uint64_t merges =
    CountMerges({ SimplifyTarget::Ratio, request.Ratio }, all, static_cast<std::size_t>(most), {});
  return all - std::max(merges, std::min(request.Merges, most));
}

bool Simplifies(const FrameRequest& request)
{
  return request.Ratio > 0 || request.Merges > 0;
}
}

//------------------------------------------------------------------------------
FrameLimits JustInTime::GetLimits(const LevelsOfDetail* detail, const FrameRequest& request) const
{
  FrameLimits limits;
  limits.Pixels = request.Pixels;
  limits.LeastDistance = request.LeastDistance;
  limits.LargestDistance = request.LargestDistance;
  if (detail)
  {
    // An image of fewer is hardly faster, and shows next to nothing.
    constexpr std::uint64_t enough = 500;
    limits.MostPoints = CountPoints(*detail, request);
    limits.FewestPoints = std::min(limits.MostPoints, std::max(detail->GetFewestPoints(), enough));
    limits.EstimateTets = [detail](std::uint64_t points) { return detail->EstimateTets(points); };
  }
  else
  {
    limits.MostPoints = limits.FewestPoints = 1;
    limits.EstimateTets = [this](std::uint64_t)
    { return static_cast<std::uint64_t>(this->AllTets); };
  }
  return limits;
}

//------------------------------------------------------------------------------
Frame JustInTime::ChooseInMotion(LevelOfDetailCache& levels, const FrameRequest& request)
{
  LevelsOfDetail* const detail = levels.FindLevels();
  const FrameLimits limits = this->GetLimits(detail, request);
  Frame frame;
  if (!detail)
  {
    // Until it is known how to simplify the mesh, the image gets as coarse as it must.
    frame.Source = levels.GetWhole();
    frame.Distance = this->Budget.ChooseDistance(request.Budget, limits, 1, this->Present);
    this->Present.Distance = frame.Distance;
    return frame;
  }
  const auto wanted = this->Budget.ChoosePoints(request.Budget, limits, this->Present);
  frame.Points = wanted;
  if (wanted != limits.MostPoints || Simplifies(request))
  {
    // Another one than what would be best, as long as that is not ready.
    const auto ready = levels.FindReady(wanted);
    frame.Points = ready != 0 && ready <= limits.MostPoints ? ready : wanted;
  }
  levels.Prepare({ wanted, FrameBudget::StepUp(wanted, limits),
    FrameBudget::StepDown(wanted, limits), limits.MostPoints });
  frame.Source = levels.Get(frame.Points);
  frame.Distance = this->Budget.ChooseDistance(request.Budget, limits, frame.Points, this->Present);
  this->Present = { frame.Points, frame.Distance };
  return frame;
}

//------------------------------------------------------------------------------
Frame JustInTime::Begin(
  LevelOfDetailCache& levels, const FrameRequest& request, const RaySource::Progress& progress)
{
  if (!(request.Ratio >= 0 && request.Ratio <= 1))
  {
    throw Error(ErrorCode::InvalidInput, "the simplification ratio must be from 0 to 1");
  }
  this->Request = request;
  if (Simplifies(request))
  {
    levels.WaitForLevels(progress);
  }
  if (request.Budget > 0)
  {
    this->MotionBudget = request.Budget;
    return this->ChooseInMotion(levels, request);
  }
  Frame frame;
  frame.Distance = request.LeastDistance;
  const LevelsOfDetail* const detail = levels.FindLevels();
  frame.Points = detail ? CountPoints(*detail, request) : 0;
  frame.Source = detail ? levels.Get(frame.Points) : levels.GetWhole();
  return frame;
}

//------------------------------------------------------------------------------
void JustInTime::End(LevelOfDetailCache& levels, const Frame& frame, double rays,
  const RayStatistics& statistics, const FrameSeconds& seconds)
{
  const LevelsOfDetail* const detail = levels.FindLevels();
  if (frame.Points == 0)
  {
    this->AllTets = static_cast<double>(statistics.Tets);
  }
  FrameWork work;
  work.Rays = rays;
  work.Tets = frame.Points == 0 || !detail
    ? static_cast<double>(statistics.Tets)
    : static_cast<double>(detail->EstimateTets(frame.Points));

  // What threads did together, in proportion.
  const double forTets = statistics.OrderTime + statistics.SetUpTime;
  const double forRays = statistics.DrawTime + statistics.FinishTime;
  const double working = std::max(0.0, seconds.Cast - statistics.FetchTime);
  const double scale = forTets + forRays > 0 ? working / (forTets + forRays) : 0;
  FrameTime time{ forTets * scale, forRays * scale, std::max(0.0, seconds.All - seconds.Cast) };
  // Blocks are made for the first image of a mesh; what is made again each time does not fit.
  time.Tets += frame.Points == this->Last ? statistics.FetchTime : 0;
  this->Budget.Learn(work, time);
  this->Last = frame.Points;

  if (!(this->Request.Budget > 0) && detail)
  {
    FrameRequest next = this->Request;
    next.LargestDistance = std::max(next.LargestDistance, next.LeastDistance);
    const FrameLimits limits = this->GetLimits(detail, next);
    levels.Prepare({ this->Budget.ChoosePoints(this->MotionBudget, limits, this->Present) });
  }
}
}
