// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A camera that frames an object shows all of it, as large and as much in the middle as possible,
// from any direction, and looks at few of its points for that.

#include "gatunFraming.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace
{
using namespace gatun;
using Point = PointBlocks::Point;

double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Point Normalize(const Point& a)
{
  const double length = std::sqrt(Dot(a, a));
  return { a[0] / length, a[1] / length, a[2] / length };
}

FramingView MakeRandomView(std::mt19937& random, bool parallel)
{
  std::uniform_real_distribution<double> any(-1, 1);
  FramingView view;
  view.Back = Normalize({ any(random), any(random), any(random) });
  view.Right = Normalize(Cross(view.Back, { any(random), any(random), any(random) }));
  view.Up = Cross(view.Back, view.Right);
  view.IsParallel = parallel;
  view.TangentOfHalfAngle = std::tan(0.1 + 0.2 * (any(random) + 1));
  view.Aspect = std::exp(1.5 * any(random));
  return view;
}

/** Where the points are in the image, whose borders are at -1 and 1. */
struct Seen
{
  Range Across;
  Range Up;
  Range Depths;

  Seen(const std::vector<Point>& points, const FramingView& view, const Framing& framing)
  {
    for (const Point& point : points)
    {
      Point from{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        from[axis] = point[axis] - framing.FocalPoint[axis];
      }
      const double depth = framing.Distance - Dot(view.Back, from);
      EXPECT_GT(depth, 0);
      this->Depths.Include(depth);
      const double half = view.IsParallel ? framing.ParallelScale : depth * view.TangentOfHalfAngle;
      this->Across.Include(Dot(view.Right, from) / half / view.Aspect);
      this->Up.Include(Dot(view.Up, from) / half);
    }
  }

  double GetLargest() const
  {
    return std::max({ -this->Across.Min, this->Across.Max, -this->Up.Min, this->Up.Max });
  }
};

/** Points in a crooked cloud far from the origin. */
std::vector<Point> MakeCloud(std::mt19937& random, std::size_t count)
{
  std::normal_distribution<double> near(0, 1);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double a = near(random);
    points.push_back({ 1000 + 5 * a, -300 + 0.3 * near(random) + a * a, 20 + near(random) - a });
  }
  return points;
}

/** Consecutive points in blocks, counting the blocks that are visited. */
PointBlocks MakeBlocks(
  const std::vector<Point>& points, std::size_t size, std::size_t most, std::size_t& visits)
{
  std::vector<Bounds> boxes((points.size() + size - 1) / size);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    boxes[i / size].Include(points[i]);
  }
  return PointBlocks(std::move(boxes),
    [&points, &visits, size, most](std::size_t block, const PointBlocks::Use& use)
    {
      if (block >= most)
      {
        return false;
      }
      ++visits;
      const std::size_t end = std::min(points.size(), (block + 1) * size);
      std::for_each(points.begin() + static_cast<std::ptrdiff_t>(block * size),
        points.begin() + static_cast<std::ptrdiff_t>(end), use);
      return true;
    });
}

TEST(Framing, FillsTheImageFromAnyDirection)
{
  std::mt19937 random(7);
  const auto cloud = MakeCloud(random, 500);
  const PointBlocks points(cloud);
  int near = 0;
  for (int i = 0; i < 100; ++i)
  {
    const FramingView view = MakeRandomView(random, i % 2 == 0);
    const Seen seen(cloud, view, FrameObject(points, view));
    const double width = seen.Across.Max - seen.Across.Min;
    const double height = seen.Up.Max - seen.Up.Min;
    // Unless the eye would touch what points at it.
    const bool isNear = !view.IsParallel && seen.Depths.Min < 0.05 * seen.Depths.Max;
    EXPECT_TRUE(isNear || std::abs(std::max(width, height) - 2 * FramingFill) < 1e-3) << i;
    near += isNear ? 1 : 0;
    EXPECT_LE(seen.GetLargest(), FramingFill + 1e-3) << i;
    // In the middle both ways.
    EXPECT_NEAR(seen.Across.Min, -seen.Across.Max, 2e-3) << i;
    EXPECT_NEAR(seen.Up.Min, -seen.Up.Max, 2e-3) << i;
  }
  EXPECT_LT(near, 5);
}

TEST(Framing, BlocksGiveTheSameAsTheirPoints)
{
  std::mt19937 random(8);
  auto cloud = MakeCloud(random, 20000);
  std::sort(cloud.begin(), cloud.end()); // along x
  const PointBlocks points(cloud);
  std::size_t visits = 0;
  const PointBlocks blocks = MakeBlocks(cloud, 100, 200, visits);
  for (int i = 0; i < 6; ++i)
  {
    const FramingView view = MakeRandomView(random, i % 2 == 0);
    const Framing expected = FrameObject(points, view);
    const Framing found = FrameObject(blocks, view);
    EXPECT_EQ(found.FocalPoint, expected.FocalPoint);
    EXPECT_EQ(found.Distance, expected.Distance);
    EXPECT_EQ(found.ParallelScale, expected.ParallelScale);
  }
  // A search that passed over nothing would visit all blocks.
  visits = 0;
  blocks.FindLargest([](const Point& point) { return point[0]; });
  EXPECT_EQ(visits, 1u);
}

TEST(Framing, BoxesStandForBlocksThatAreNotAvailable)
{
  std::mt19937 random(9);
  auto cloud = MakeCloud(random, 2000);
  std::sort(cloud.begin(), cloud.end());
  std::size_t visits = 0;
  for (const std::size_t most : { 0, 3, 10 })
  {
    const PointBlocks blocks = MakeBlocks(cloud, 100, most, visits);
    for (int i = 0; i < 20; ++i)
    {
      const FramingView view = MakeRandomView(random, i % 2 == 0);
      const Seen seen(cloud, view, FrameObject(blocks, view));
      EXPECT_LE(seen.GetLargest(), FramingFill + 1e-3);
      EXPECT_GE(seen.GetLargest(), 0.3);
    }
  }
}

TEST(Framing, AGivenPointIsInTheMiddle)
{
  std::mt19937 random(10);
  const auto cloud = MakeCloud(random, 300);
  const PointBlocks points(cloud);
  for (const bool parallel : { false, true })
  {
    for (int i = 0; i < 12; ++i)
    {
      FramingView view;
      const double angle = i * std::acos(-1) / 6;
      view.Back = { std::sin(angle), 0, std::cos(angle) };
      view.Right = { std::cos(angle), 0, -std::sin(angle) };
      view.IsParallel = parallel;
      view.Aspect = 1.5;
      const Point middle{ 1000, -299, 20 };
      const Framing framing = FrameAround(points, middle, view);
      EXPECT_EQ(framing.FocalPoint, middle);
      EXPECT_NEAR(Seen(cloud, view, framing).GetLargest(), FramingFill, 1e-6);
    }
  }
}

TEST(Framing, WhatHasNoExtentIsSeen)
{
  const std::vector<Point> one{ { 3, 4, 5 } };
  const std::vector<Point> line{ { 3, 4, 5 }, { 3, 4, 6 } };
  for (const auto& cloud : { one, line })
  {
    const PointBlocks points(cloud);
    for (const bool parallel : { false, true })
    {
      FramingView view; // along the line
      view.IsParallel = parallel;
      for (const Framing& framing :
        { FrameObject(points, view), FrameAround(points, { 3, 4, 5 }, view) })
      {
        const Seen seen(cloud, view, framing);
        EXPECT_LE(seen.GetLargest(), 2e-3);
        EXPECT_GT(framing.ParallelScale, 0);
        EXPECT_TRUE(std::isfinite(framing.Distance + framing.ParallelScale));
      }
    }
  }
  const PointBlocks none(std::vector<Bounds>(5));
  EXPECT_TRUE(none.IsEmpty());
  const Framing framing = FrameObject(none, {});
  EXPECT_GT(framing.Distance, 0);
}
}
