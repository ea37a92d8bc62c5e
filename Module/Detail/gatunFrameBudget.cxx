// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFrameBudget.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
// Fractions of the budget between which nothing is changed.
constexpr double Low = 0.8;
constexpr double High = 1;

// The fraction of the budget that tetrahedra may take while the number of rays is reduced.
constexpr double TetShare = 0.25;

constexpr double RayPower = 0.7;
constexpr double TetPower = 0.3;

constexpr int StepsToHalf = 4;

// A level that is at most this number of steps away from the best one is kept.
constexpr int StepsToKeep = 4;

/** The amount of work along rays. */
double GetRayWork(const FrameWork& work)
{
  return std::pow(std::max(work.Rays, 1.0), RayPower) *
    std::pow(std::max(work.Tets, 1.0), TetPower);
}

/** The number of points a given number of steps down. Halvings are exact. */
std::uint64_t GetStep(int step, const FrameLimits& limits)
{
  const std::uint64_t halved =
    step / StepsToHalf < 64 ? limits.MostPoints >> step / StepsToHalf : 0;
  const double part = std::exp2(-static_cast<double>(step % StepsToHalf) / StepsToHalf);
  const auto points = static_cast<std::uint64_t>(static_cast<double>(halved) * part);
  return std::max({ points, limits.FewestPoints, std::uint64_t{ 1 } });
}

/** The first level with at most a given number of points, or the lowest one. */
int FindStep(std::uint64_t points, const FrameLimits& limits)
{
  int step = 0;
  for (; GetStep(step, limits) > points; ++step)
  {
    if (GetStep(step, limits) <= std::max<std::uint64_t>(limits.FewestPoints, 1))
    {
      break;
    }
  }
  return step;
}
}

//------------------------------------------------------------------------------
void RecentCost::Add(double cost)
{
  if (std::isfinite(cost) && cost >= 0)
  {
    this->Last[this->Count++ % this->Last.size()] = cost;
  }
}

//------------------------------------------------------------------------------
double RecentCost::Get() const
{
  if (this->Count == 0)
  {
    return this->Guess;
  }
  auto sorted = this->Last;
  const auto count = std::min(this->Count, sorted.size());
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(count);
  // Not std::sort, for which GCC 14 issues a false warning about the bounds of the array.
  std::partial_sort(sorted.begin(), end, end);
  // The larger one of two.
  return sorted[count / 2];
}

//------------------------------------------------------------------------------
void FrameBudget::Learn(const FrameWork& work, const FrameTime& time)
{
  if (work.Tets > 0)
  {
    this->PerTet.Add(time.Tets / work.Tets);
  }
  this->PerRay.Add(time.Rays / GetRayWork(work));
  this->Fixed.Add(time.Fixed);
}

//------------------------------------------------------------------------------
double FrameBudget::Predict(const FrameWork& work) const
{
  return this->Fixed.Get() + this->PerTet.Get() * work.Tets + this->PerRay.Get() * GetRayWork(work);
}

//------------------------------------------------------------------------------
double FrameBudget::GetTetTime(const FrameLimits& limits, std::uint64_t points) const
{
  return this->PerTet.Get() * static_cast<double>(limits.EstimateTets(points));
}

//------------------------------------------------------------------------------
double FrameBudget::GetTime(const FrameLimits& limits, std::uint64_t points, double distance) const
{
  return this->Predict(
    { static_cast<double>(limits.EstimateTets(points)), limits.Pixels / (distance * distance) });
}

//------------------------------------------------------------------------------
std::uint64_t FrameBudget::ChoosePoints(
  double budget, const FrameLimits& limits, const FrameChoice& present) const
{
  const auto fits = [&](std::uint64_t points)
  {
    return this->GetTime(limits, points, limits.LeastDistance) <= FrameAim * budget ||
      (limits.LargestDistance > limits.LeastDistance &&
        this->GetTetTime(limits, points) <= TetShare * FrameAim * budget);
  };
  int best = 0;
  while (!fits(GetStep(best, limits)) && GetStep(best, limits) > GetStep(best + 1, limits))
  {
    ++best;
  }
  if (present.Points != 0 && present.Points <= limits.MostPoints)
  {
    const int step = FindStep(present.Points, limits);
    const double distance = this->ChooseDistance(budget, limits, present.Points, present);
    const double time = this->GetTime(limits, present.Points, distance);
    const bool isGood = time <= High * budget &&
      (time >= Low * budget || (step == 0 && distance <= limits.LeastDistance));
    if (isGood && std::abs(step - best) <= StepsToKeep)
    {
      return present.Points;
    }
  }
  return GetStep(best, limits);
}

//------------------------------------------------------------------------------
double FrameBudget::ChooseDistance(
  double budget, const FrameLimits& limits, std::uint64_t points, const FrameChoice& present) const
{
  if (!(limits.LargestDistance > limits.LeastDistance))
  {
    return limits.LeastDistance;
  }
  if (present.Distance >= limits.LeastDistance && present.Distance <= limits.LargestDistance)
  {
    const double time = this->GetTime(limits, points, present.Distance);
    if (time >= Low * budget && time <= High * budget)
    {
      return present.Distance;
    }
  }
  const double forRays = FrameAim * budget - this->Fixed.Get() - this->GetTetTime(limits, points);
  const double finest = this->PerRay.Get() *
    GetRayWork({ static_cast<double>(limits.EstimateTets(points)), limits.Pixels });
  const double distance = forRays > 0 ? std::pow(finest / forRays, 0.5 / RayPower) : INFINITY;
  return std::clamp(distance, limits.LeastDistance, limits.LargestDistance);
}

//------------------------------------------------------------------------------
std::uint64_t FrameBudget::StepDown(std::uint64_t points, const FrameLimits& limits)
{
  const int step = FindStep(points, limits);
  return GetStep(GetStep(step, limits) == points ? step + 1 : step, limits);
}

//------------------------------------------------------------------------------
std::uint64_t FrameBudget::StepUp(std::uint64_t points, const FrameLimits& limits)
{
  int step = FindStep(points, limits);
  while (step > 0 && GetStep(step, limits) <= points)
  {
    --step;
  }
  return GetStep(step, limits);
}
}
