// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunJustInTime.h"

#include "gatunError.h"
#include "gatunSimplifyProperties.h"

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

/** Whether an image at rest depends on the view. */
bool FollowsViewAtRest(const FrameRequest& request)
{
  return request.View && request.View->PixelError > 0;
}

bool Simplifies(const FrameRequest& request)
{
  return request.Ratio > 0 || request.Merges > 0 || FollowsViewAtRest(request);
}

/** What is likely to be drawn next. */
std::vector<DetailRequest> ListNext(const DetailRequest& wanted, const FrameLimits& limits)
{
  if (wanted.View)
  {
    // The view will be another one, and so will be all levels for views.
    return { wanted, { limits.MostPoints, nullptr } };
  }
  return { wanted, { FrameBudget::StepUp(wanted.Points, limits), nullptr },
    { FrameBudget::StepDown(wanted.Points, limits), nullptr }, { limits.MostPoints, nullptr } };
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
  // With all the points that there are to be, the image is that at rest.
  const bool followsView = wanted < limits.MostPoints || FollowsViewAtRest(request);
  const DetailRequest next{ wanted, followsView ? request.View : nullptr };
  DetailRequest best = next;
  if (!request.Waits && (wanted != limits.MostPoints || Simplifies(request)))
  {
    // Another one than what would be best, as long as that is not ready.
    const auto ready = levels.FindReady(best);
    if (ready.Points != 0 && ready.Points <= limits.MostPoints)
    {
      best = ready;
    }
  }
  if (!request.Waits)
  {
    levels.Prepare(ListNext(next, limits));
    frame.NextPoints = next.View ? wanted : 0;
  }
  frame.Level = best;
  const DetailLevel level = levels.Get(best);
  frame.Source = level.Source;
  frame.Points = level.Points;
  frame.Distance = this->Budget.ChooseDistance(request.Budget, limits, frame.Points, this->Present);
  this->Present = { best.Points, frame.Distance };
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
  if (!detail)
  {
    frame.Source = levels.GetWhole();
    return frame;
  }
  frame.Level = { CountPoints(*detail, request),
    FollowsViewAtRest(request) ? request.View : nullptr };
  const DetailLevel level = levels.Get(frame.Level);
  frame.Source = level.Source;
  frame.Points = level.Points;
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

  if (!(this->Request.Budget > 0) && detail && !this->Request.Waits)
  {
    FrameRequest next = this->Request;
    next.LargestDistance = std::max(next.LargestDistance, next.LeastDistance);
    const FrameLimits limits = this->GetLimits(detail, next);
    levels.Prepare(
      { { this->Budget.ChoosePoints(this->MotionBudget, limits, this->Present), next.View } });
  }
}
}
