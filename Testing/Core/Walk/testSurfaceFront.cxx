// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// What a walk over surfaces knows about its open edges and the places around them.

#include "gatunPlaceGrid.h"
#include "gatunSurfaceFront.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace
{
using namespace gatun;

Vec3 MakeVector(double x, double y)
{
  return { Float4{ static_cast<float>(x), static_cast<float>(y), 0, 0 } };
}
}

//------------------------------------------------------------------------------
TEST(SurfaceFront, GradesAngles)
{
  // In the plane, the edge before runs along x; the free side is on the left.
  const auto grade = [](double degrees)
  {
    const double turn = (180 - degrees) * 3.14159265358979 / 180;
    return GradeCorner(
      MakeVector(1, 0), MakeVector(std::cos(turn), std::sin(turn)), { Float4{ 0, 0, 1, 0 } });
  };
  EXPECT_EQ(grade(0.01), 0u);
  EXPECT_EQ(grade(60), 2u);
  EXPECT_EQ(grade(90), 4u);
  EXPECT_EQ(grade(120), 6u);
  EXPECT_EQ(grade(179.9), 8u);
  EXPECT_EQ(grade(180.1), 8u);
  EXPECT_EQ(grade(359.9), 14u);
  for (double degrees = 1; degrees < 360; degrees += 1)
  {
    EXPECT_LE(grade(degrees - 1), grade(degrees));
  }
  EXPECT_LE(GradeCorner(MakeVector(0, 0), MakeVector(0, 0), MakeVector(0, 0)), 14u);
}

TEST(PlaceGrid, FindsAllVerticesAroundAPlace)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(0, 255.9F);
  PlaceGrid grid(150);
  std::vector<LatticePoint> points;
  for (int i = 0; i < 150; ++i)
  {
    points.push_back({ place(random), place(random), place(random) / 100, 0 });
  }
  for (const float distance : { 0.5F, 3.0F, 16.0F, 40.0F })
  {
    for (int i = 0; i < 50; ++i)
    {
      const LatticePoint center{ place(random) * 1.2F - 20, place(random), 1, 0 };
      std::set<Vertex> found;
      grid.ForEachAround(
        center, distance, static_cast<Vertex>(points.size()),
        [&](Vertex v) -> const LatticePoint& { return points[v]; },
        [&](Vertex v) { found.insert(v); });
      for (Vertex v = 0; v < points.size(); ++v)
      {
        const auto d = ToVector(points[v]) - ToVector(center);
        EXPECT_TRUE(Dot(d, d) > distance * distance || found.count(v) != 0);
      }
    }
  }
}
