// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a view needs detail.

#include "gatunDetailWeights.h"
#include "gatunError.h"
#include "gatunMergeSelection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace gatun::test
{
namespace
{
using Vec = std::array<double, 3>;

constexpr int Pixels = 200;

/** From (0, 0, 10) towards the origin, with y upwards. In perspective, 90 degrees wide. */
RayView MakeView(bool isParallel)
{
  RayFrustum frustum;
  frustum.Parallel = isParallel;
  frustum.Near = 0.5;
  frustum.Far = 100;
  return { { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, -10 } } }, frustum, Pixels, Pixels, 0.1 };
}

TEST(DetailWeights, AreTheLengthOfTheObjectInPixels)
{
  const DetailWeights perspective(MakeView(false), 3);
  // Two units wide at a distance of 1: 100 pixels a unit.
  EXPECT_FLOAT_EQ(perspective.Get(Vec{ 0, 0, 9 }), 300);
  EXPECT_FLOAT_EQ(perspective.Get(Vec{ 0.5, -3, 6 }), 75);
  EXPECT_FLOAT_EQ(perspective.Get(Vec{ 0, 0, 0 }), 30);
  const DetailWeights parallel(MakeView(true), 3);
  for (const double z : { 9.0, 6.0, 0.0 })
  {
    EXPECT_FLOAT_EQ(parallel.Get(Vec{ 0.5, 0.25, z }), 300);
  }
}

TEST(DetailWeights, FallToZeroOutsideOfTheView)
{
  for (const bool isParallel : { false, true })
  {
    const DetailWeights weights(MakeView(isParallel), 2);
    const double border = isParallel ? 1 : 5; // at z = 5
    float last = weights.Get(Vec{ border - 0.01, 0, 5 });
    EXPECT_GT(last, 0);
    // A tenth of the size, perpendicularly to the side of the view.
    const double far = 0.2 * (isParallel ? 1 : std::numbers::sqrt2);
    for (const double part : { 0.25, 0.5, 0.75 })
    {
      const float here = weights.Get(Vec{ border + part * far, 0, 5 });
      EXPECT_GT(here, 0);
      EXPECT_LT(here, last);
      last = here;
    }
    for (const Vec& p : { Vec{ border + 1.01 * far, 0, 5 }, Vec{ -border - 1.01 * far, 0, 5 },
           Vec{ 0, border + 1.01 * far, 5 }, Vec{ 0, -border - 1.01 * far, 5 }, Vec{ 0, 0, 9.71 },
           Vec{ 0, 0, 20 }, Vec{ 0, 0, -90.21 } })
    {
      EXPECT_EQ(weights.Get(p), 0) << p[0] << " " << p[1] << " " << p[2];
    }
  }
}

TEST(DetailWeights, OfABoxAreAtLeastThoseOfItsPoints)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-12, 12);
  for (const bool isParallel : { false, true })
  {
    const DetailWeights weights(MakeView(isParallel), 4);
    std::size_t zeros = 0;
    for (int i = 0; i < 2000; ++i)
    {
      Bounds box;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double one = any(random);
        const double other = one + 0.2 * any(random);
        box[axis] = { std::min(one, other), std::max(one, other) };
      }
      const float most = weights.Get(box);
      zeros += most == 0 ? 1 : 0;
      for (int k = 0; k < 20; ++k)
      {
        Vec p{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          p[axis] = std::uniform_real_distribution<double>(box[axis].Min, box[axis].Max)(random);
        }
        EXPECT_LE(weights.Get(p), most * 1.00001f);
      }
    }
    EXPECT_GT(zeros, 100u);
    EXPECT_LT(zeros, 1970u);
  }
}

TEST(DetailWeights, AreFiniteAnywhere)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double far = std::numeric_limits<double>::max();
  const DetailWeights weights(MakeView(false), 2);
  EXPECT_EQ(weights.Get(Vec{ nan, 0, 0 }), 0);
  EXPECT_EQ(weights.Get(Vec{ far, far, far }), 0);
  EXPECT_EQ(weights.Get(Bounds{}), 0);
  EXPECT_TRUE(std::isfinite(weights.Get(Vec{ 0, 0, 10 }))); // the eye
}

TEST(MergeSelection, TakesCheapMergesWhereLittleCounts)
{
  const MergeTree tree(4, { { 0, 3, 1 }, { 1, 3, 2 }, { 2, 3, 4 } });
  EXPECT_EQ(SelectMerges(tree, std::vector<float>{ 1, 1, 1, 1 }, 2),
    (std::vector<bool>{ true, true, false }));
  EXPECT_EQ(SelectMerges(tree, std::vector<float>{ 3, 1, 0, 1 }, 2),
    (std::vector<bool>{ false, true, true }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double tolerance : { 0.0, -1.0, nan })
  {
    EXPECT_EQ(SelectMerges(tree, std::vector<float>{ 3, 1, 0, 1 }, tolerance),
      (std::vector<bool>{ false, false, true }));
  }
  EXPECT_THROW(SelectMerges(tree, std::vector<float>{ 1 }, 1), Error);
}

TEST(MergeSelection, FindsTheToleranceForANumber)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<float> any(0, 5);
  std::vector<Merge> merges;
  std::vector<float> weights{ 1 };
  for (std::uint32_t i = 1; i < 300; ++i)
  {
    merges.push_back({ i, 0, static_cast<float>(i) });
    weights.push_back(any(random));
  }
  const MergeTree tree(300, std::move(merges));
  for (const std::size_t number : { 1u, 17u, 150u, 299u })
  {
    const auto wanted = SelectMerges(tree, weights, FindTolerance(tree, weights, number));
    EXPECT_EQ(static_cast<std::size_t>(std::count(wanted.begin(), wanted.end(), true)), number);
  }
  EXPECT_EQ(FindTolerance(tree, weights, 0), 0);
  EXPECT_EQ(FindTolerance(tree, weights, 299), FindTolerance(tree, weights, 5000));
}
}
}
