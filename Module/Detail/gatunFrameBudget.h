// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFrameBudget_h
#define gatunFrameBudget_h

#include "gatunExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace gatun
{
/** The fraction of a budget that images are to take: below 1, as disturbances only make them
 * slower.
 */
constexpr double FrameAim = 0.9;

/** The median of the last three costs, the larger one of two, or a guess until there is one. One
 * disturbed image has no effect. */
class GATUN_EXPORT RecentCost
{
public:
  explicit RecentCost(double guess)
    : Guess(guess)
  {
  }
  void Add(double cost);
  double Get() const;

private:
  double Guess;
  std::array<double, 3> Last{};
  std::size_t Count = 0;
};

/** The amount of work for a frame. */
struct FrameWork
{
  double Tets = 0; ///< drawn tetrahedra
  double Rays = 0; ///< cast rays
};

/** The time of a frame, in seconds. */
struct FrameTime
{
  double Tets = 0;  ///< work for each tetrahedron: making, ordering, planes
  double Rays = 0;  ///< work along rays, and for pixels
  double Fixed = 0; ///< the rest
};

/** The resolution of a frame: level of detail and distance of rays. */
struct FrameChoice
{
  std::uint64_t Points = 0; ///< of the level of detail; 0: no frame has been drawn yet
  double Distance = 1;      ///< of rays, in pixels
};

/** The limits of the choice. */
struct FrameLimits
{
  std::uint64_t MostPoints = 0; ///< of the whole mesh
  std::uint64_t FewestPoints = 0;
  double Pixels = 0;        ///< rays where their distance is 1
  double LeastDistance = 1; ///< of rays
  double LargestDistance = 1;
  std::function<std::uint64_t(std::uint64_t)>
    EstimateTets; ///< tetrahedra of a level with this number of points
};

/**
 * Chooses the level of detail and the distance of rays for a time budget, from the times of the
 * last frames. The mesh is simplified first, until the work for its tetrahedra takes at most a
 * quarter of the time. If that is not enough, because rays take most of the time, they are cast
 * farther apart. There are four levels of detail for each factor of 2 in points. The present level
 * is kept while it is about as good as the best one, because a new level needs new blocks. The
 * distance of rays is adapted at once.
 *
 * Time along rays grows with the number of rays to the power 0.7, because nearby rays are drawn
 * together, and with the number of tetrahedra to the power 0.3, about that of the tetrahedra on a
 * ray; both were measured in mode Composite.
 */
class GATUN_EXPORT FrameBudget
{
public:
  void Learn(const FrameWork& work, const FrameTime& time);

  /** Returns the expected time of a frame, in seconds. */
  double Predict(const FrameWork& work) const;

  /** Returns the number of points for a budget in seconds; the present one if it is good enough. */
  std::uint64_t ChoosePoints(
    double budget, const FrameLimits& limits, const FrameChoice& present) const;

  /** Returns the distance of rays for a number of points. */
  double ChooseDistance(double budget, const FrameLimits& limits, std::uint64_t points,
    const FrameChoice& present) const;

  /** Returns the next level below a number of points, or the fewest points. */
  static std::uint64_t StepDown(std::uint64_t points, const FrameLimits& limits);

  /** Returns the next level above a number of points, or all points. */
  static std::uint64_t StepUp(std::uint64_t points, const FrameLimits& limits);

private:
  double GetTetTime(const FrameLimits& limits, std::uint64_t points) const;
  double GetTime(const FrameLimits& limits, std::uint64_t points, double distance) const;

  RecentCost PerTet{ 3e-7 };
  RecentCost PerRay{ 3e-7 }; // times the powers
  RecentCost Fixed{ 5e-3 };
};
}

#endif
