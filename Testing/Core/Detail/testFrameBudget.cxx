// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Images that are to take a certain time, drawn by a machine that does nothing but tell how long
// it would have taken.

#include "gatunFrameBudget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace gatun::test
{
namespace
{
/** Costs that are not quite as the budget takes them to be, but as they were measured of one of the
 * meshes that the budget was fitted to. */
class Machine
{
public:
  double PerTet = 1.5e-7;
  double PerRay = 1.7e-7; ///< times the powers
  double Fixed = 6e-3;
  double RayPower = 0.65;
  double TetPower = 0.4;
  double Load = 1;
  double Noise = 0; ///< standard deviation of the logarithm of times

  FrameTime Draw(const FrameWork& work)
  {
    std::normal_distribution<double> normal(0, this->Noise);
    const double factor = this->Load * std::exp(this->Noise > 0 ? normal(this->Random) : 0);
    return { factor * this->PerTet * work.Tets,
      factor * this->PerRay * std::pow(work.Rays, this->RayPower) *
        std::pow(work.Tets, this->TetPower),
      factor * this->Fixed };
  }

private:
  std::mt19937 Random{ 7 };
};

FrameLimits MakeLimits(std::uint64_t points, double largestDistance)
{
  FrameLimits limits;
  limits.MostPoints = points;
  limits.FewestPoints = 100;
  limits.Pixels = 512 * 512;
  limits.LargestDistance = largestDistance;
  limits.EstimateTets = [](std::uint64_t n) { return n * 11 / 2; };
  return limits;
}

struct Frame
{
  FrameChoice Choice;
  double Seconds;
};

class Session
{
public:
  Machine Hardware;
  FrameBudget Budget;
  FrameChoice Present;

  Frame Draw(double budget, const FrameLimits& limits)
  {
    this->Present.Points = this->Budget.ChoosePoints(budget, limits, this->Present);
    this->Present.Distance =
      this->Budget.ChooseDistance(budget, limits, this->Present.Points, this->Present);
    const FrameWork work{ static_cast<double>(limits.EstimateTets(this->Present.Points)),
      limits.Pixels / (this->Present.Distance * this->Present.Distance) };
    const FrameTime time = this->Hardware.Draw(work);
    this->Budget.Learn(work, time);
    return { this->Present, time.Tets + time.Rays + time.Fixed };
  }

  std::vector<Frame> Draw(double budget, const FrameLimits& limits, int frames)
  {
    std::vector<Frame> result;
    for (int i = 0; i < frames; ++i)
    {
      result.push_back(this->Draw(budget, limits));
    }
    return result;
  }
};

/** The part of the frames that took at most 1.25 times the budget, and at least 0.75 times unless
 * there was nothing to be had for more time. */
double CountGood(const std::vector<Frame>& frames, double budget, const FrameLimits& limits)
{
  const auto good = std::count_if(frames.begin(), frames.end(),
    [&](const Frame& f)
    {
      const bool isBest = f.Choice.Points == limits.MostPoints && f.Choice.Distance == 1;
      return f.Seconds <= 1.25 * budget && (isBest || f.Seconds >= 0.75 * budget);
    });
  return static_cast<double>(good) / static_cast<double>(frames.size());
}

std::size_t CountChanges(const std::vector<Frame>& frames)
{
  std::size_t changes = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
  {
    changes += frames[i].Choice.Points != frames[i - 1].Choice.Points ? 1 : 0;
  }
  return changes;
}

//------------------------------------------------------------------------------
TEST(FrameBudget, FramesTakeTheirTimeAfterThree)
{
  for (const double budget : { 0.033, 0.1, 0.5 })
  {
    for (const std::uint64_t points : { 180000u, 900000u })
    {
      for (const double distance : { 1.0, 10.0 })
      {
        const auto limits = MakeLimits(points, distance);
        Session run;
        auto frames = run.Draw(budget, limits, 50);
        if (distance == 1 && frames.back().Choice.Points == limits.FewestPoints)
        {
          continue; // no image with all rays is as fast as that
        }
        frames.erase(frames.begin(), frames.begin() + 3);
        EXPECT_EQ(CountGood(frames, budget, limits), 1)
          << budget << " " << points << " " << distance << " " << frames.back().Seconds;
        EXPECT_LE(CountChanges(frames), 2u);
        frames.erase(frames.begin(), frames.begin() + 10);
        EXPECT_EQ(CountChanges(frames), 0u); // at rest with itself
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(FrameBudget, NoiseMovesFewFramesOut)
{
  for (const double budget : { 0.033, 0.1, 0.5 })
  {
    const auto limits = MakeLimits(900000, 10);
    Session run;
    run.Hardware.Noise = 0.08;
    run.Draw(budget, limits, 3);
    const auto frames = run.Draw(budget, limits, 500);
    EXPECT_GT(CountGood(frames, budget, limits), 0.95) << budget;
    EXPECT_LT(CountChanges(frames), 25u) << budget;
  }
}

//------------------------------------------------------------------------------
TEST(FrameBudget, OneSlowFrameChangesNothing)
{
  const auto limits = MakeLimits(900000, 10);
  Session run;
  run.Draw(0.1, limits, 20);
  const FrameChoice before = run.Present;
  run.Hardware.Load = 20;
  run.Draw(0.1, limits, 1);
  run.Hardware.Load = 1;
  for (const Frame& frame : run.Draw(0.1, limits, 10))
  {
    EXPECT_EQ(frame.Choice.Points, before.Points);
    EXPECT_NEAR(frame.Choice.Distance, before.Distance, 0.1 * before.Distance);
  }
}

//------------------------------------------------------------------------------
TEST(FrameBudget, AMachineThatIsBusyElsewhereIsNoticedWithinThreeFrames)
{
  for (const double load : { 2.5, 0.4 })
  {
    const auto limits = MakeLimits(900000, 10);
    Session run;
    run.Draw(0.1, limits, 20);
    run.Hardware.Load = load;
    run.Draw(0.1, limits, 3);
    EXPECT_EQ(CountGood(run.Draw(0.1, limits, 30), 0.1, limits), 1) << load;
  }
}

//------------------------------------------------------------------------------
TEST(FrameBudget, ThereIsNothingToChooseWhereAllFits)
{
  const auto limits = MakeLimits(5000, 10);
  Session run;
  run.Hardware.PerRay = 7e-10;
  for (const Frame& frame : run.Draw(0.5, limits, 10))
  {
    EXPECT_EQ(frame.Choice.Points, 5000u);
    EXPECT_EQ(frame.Choice.Distance, 1);
  }
}

//------------------------------------------------------------------------------
TEST(FrameBudget, TheMeshIsSimplifiedBeforeTheImageGetsCoarser)
{
  // Whatever does not fit with all tetrahedra, but does with fewer, keeps all its rays.
  const auto limits = MakeLimits(900000, 10);
  Session run;
  run.Hardware.PerRay = 7e-9;
  const auto frames = run.Draw(0.3, limits, 20);
  EXPECT_LT(frames.back().Choice.Points, 900000u);
  EXPECT_GT(frames.back().Choice.Points, 100000u);
  EXPECT_EQ(frames.back().Choice.Distance, 1);
  EXPECT_GE(frames.back().Seconds, 0.75 * 0.3);
}

//------------------------------------------------------------------------------
TEST(FrameBudget, BudgetsThatCannotBeMetGetTheLeastThereIs)
{
  const auto limits = MakeLimits(900000, 10);
  Session run;
  for (const double budget : { 0.0, 1e-9, -1.0 })
  {
    const Frame frame = run.Draw(budget, limits);
    EXPECT_EQ(frame.Choice.Points, limits.FewestPoints);
    EXPECT_EQ(frame.Choice.Distance, limits.LargestDistance);
  }
}

//------------------------------------------------------------------------------
TEST(FrameBudget, StrangeTimesAreNotLearnt)
{
  const auto limits = MakeLimits(900000, 10);
  Session run;
  run.Draw(0.1, limits, 10);
  const double before = run.Budget.Predict({ 1e5, 1e5 });
  run.Budget.Learn({ 0, 0 }, { NAN, NAN, NAN });
  run.Budget.Learn({ 1e5, 1e5 }, { -1, INFINITY, -1 });
  EXPECT_EQ(run.Budget.Predict({ 1e5, 1e5 }), before);
}

//------------------------------------------------------------------------------
TEST(FrameBudget, StepsOfTheLadderHalveThePointsInFour)
{
  const auto limits = MakeLimits(1 << 20, 10);
  std::uint64_t points = limits.MostPoints;
  EXPECT_EQ(FrameBudget::StepUp(points, limits), points);
  for (int halving = 1; halving < 13; ++halving)
  {
    for (int i = 0; i < 4; ++i)
    {
      const auto next = FrameBudget::StepDown(points, limits);
      EXPECT_LT(next, points);
      EXPECT_EQ(FrameBudget::StepUp(next, limits), points);
      EXPECT_EQ(FrameBudget::StepUp(next + 1, limits), points);
      points = next;
    }
    EXPECT_EQ(points, limits.MostPoints >> halving);
  }
  EXPECT_EQ(FrameBudget::StepDown(100, limits), 100u);
  EXPECT_EQ(FrameBudget::StepDown(3, limits), 100u);
}
}
}
