// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFrameBudget_h
#define gatunFrameBudget_h

#include "vtkGatunCoreModule.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace gatun
{
/** What a picture is made of. */
struct FrameWork
{
  double Tets = 0; ///< that are drawn
  double Rays = 0; ///< that are cast
};

/** Where its time went, in seconds. */
struct FrameTime
{
  double Tets = 0;  ///< what is done once for each tetrahedron: making, ordering, planes
  double Rays = 0;  ///< what is done for samples and pixels
  double Fixed = 0; ///< the rest
};

/** How a picture is drawn so that it takes no longer than it may. */
struct FrameChoice
{
  std::uint64_t Points = 0; ///< of the mesh; 0: none has been drawn yet
  double Distance = 1;      ///< of rays, in pixels
};

/** Between what a picture can be chosen. */
struct FrameLimits
{
  std::uint64_t MostPoints = 0; ///< all of them
  std::uint64_t FewestPoints = 0;
  double Pixels = 0;        ///< rays where their distance is 1
  double LeastDistance = 1; ///< of rays
  double LargestDistance = 1;
  std::function<std::uint64_t(std::uint64_t)> EstimateTets; ///< of a number of points
};

/**
 * Chooses how simple a mesh and how coarse a picture must be for the time that there is, by what
 * the last pictures took. The mesh comes first: it is simplified until what is done for its
 * tetrahedra takes at most a quarter of the time; if that is not enough, as most of the time goes
 * into samples, rays are cast farther apart. Numbers of points are steps of a ladder, four to a
 * halving, and the present one is kept as long as it does about as well: to draw another number,
 * blocks have to be made. The distance of rays follows at once.
 *
 * Time for samples is taken to grow with the rays to the power 1.2 (coarser pictures have coarser
 * samples) and with the tetrahedra to the power 0.2, as it was measured. Of each kind of cost, the
 * median of the last three pictures counts, so that one that was disturbed changes nothing.
 */
class VTKGATUNCORE_EXPORT FrameBudget
{
public:
  void Learn(const FrameWork& work, const FrameTime& time);

  /** How long a picture will take, in seconds. */
  double Predict(const FrameWork& work) const;

  /** How many points fit a budget of seconds, if the present choice has to change at all. */
  std::uint64_t ChoosePoints(
    double budget, const FrameLimits& limits, const FrameChoice& present) const;

  /** How far apart rays are, where so many points are drawn. */
  double ChooseDistance(double budget, const FrameLimits& limits, std::uint64_t points,
    const FrameChoice& present) const;

  /** The step of the ladder below a number of points, or that of the fewest. */
  static std::uint64_t StepDown(std::uint64_t points, const FrameLimits& limits);

  /** The next step above a number of points, or all. */
  static std::uint64_t StepUp(std::uint64_t points, const FrameLimits& limits);

private:
  /** The median of the last three numbers. */
  class Recent
  {
  public:
    explicit Recent(double guess)
      : Guess(guess)
    {
    }
    void Add(double number);
    double Get() const;

  private:
    double Guess; // until there is any
    std::array<double, 3> Last{};
    std::size_t Count = 0;
  };

  double GetTetTime(const FrameLimits& limits, std::uint64_t points) const;
  double GetTime(const FrameLimits& limits, std::uint64_t points, double distance) const;

  Recent PerTet{ 3e-7 };
  Recent PerRay{ 5e-9 }; // times the powers
  Recent Fixed{ 5e-3 };
};
}

#endif
