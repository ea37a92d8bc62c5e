// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMarch.h"
#include "gatunStrips.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gatun::test
{
namespace
{
using StripTriangle = std::array<std::uint32_t, 3>;

/** Sorted, each beginning with its smallest corner, but turned no other way. */
std::vector<StripTriangle> Sort(std::vector<StripTriangle> triangles)
{
  for (auto& t : triangles)
  {
    const StripTriangle turns[] = { t, { t[1], t[2], t[0] }, { t[2], t[0], t[1] } };
    t = *std::min_element(std::begin(turns), std::end(turns));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/** Makes strips and checks that they are the same triangles; returns how many strips there are. */
std::size_t ExpectSame(const std::vector<StripTriangle>& triangles)
{
  const auto strips = MakeStrips(triangles);
  std::vector<StripTriangle> found;
  for (const auto& strip : strips)
  {
    EXPECT_GE(strip.size(), 3u);
    for (std::size_t i = 0; i + 2 < strip.size(); ++i)
    {
      found.push_back(i % 2 == 0 ? StripTriangle{ strip[i], strip[i + 1], strip[i + 2] }
                                 : StripTriangle{ strip[i + 1], strip[i], strip[i + 2] });
    }
  }
  EXPECT_EQ(Sort(found), Sort(triangles));
  return strips.size();
}
}

//------------------------------------------------------------------------------
TEST(Strips, FewTriangles)
{
  EXPECT_EQ(ExpectSame({}), 0u);
  EXPECT_EQ(ExpectSame({ { 7, 3, 5 } }), 1u);
  EXPECT_EQ(ExpectSame({ { 0, 1, 2 }, { 3, 4, 5 } }), 2u);
  EXPECT_EQ(ExpectSame({ { 0, 1, 2 }, { 2, 1, 3 } }), 1u);
  // The other way round at the edge: the fronts do not fit.
  EXPECT_EQ(ExpectSame({ { 0, 1, 2 }, { 1, 2, 3 } }), 2u);
}

//------------------------------------------------------------------------------
TEST(Strips, TwoNeighborsAlwaysJoin)
{
  // Every way to write both triangles, and every edge of the first.
  const StripTriangle first = { 4, 9, 2 };
  for (unsigned turn = 0; turn < 3; ++turn)
  {
    for (unsigned edge = 0; edge < 3; ++edge)
    {
      const StripTriangle second = { first[(edge + 1) % 3], first[edge], 6 };
      for (unsigned other = 0; other < 3; ++other)
      {
        EXPECT_EQ(ExpectSame({ { first[turn], first[(turn + 1) % 3], first[(turn + 2) % 3] },
                    { second[other], second[(other + 1) % 3], second[(other + 2) % 3] } }),
          1u);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(Strips, RibbonIsOneStrip)
{
  std::vector<StripTriangle> ribbon;
  for (std::uint32_t i = 0; i < 1000; ++i)
  {
    ribbon.push_back(
      i % 2 == 0 ? StripTriangle{ i, i + 1, i + 2 } : StripTriangle{ i + 1, i, i + 2 });
  }
  EXPECT_EQ(ExpectSame(ribbon), 1u);
}

//------------------------------------------------------------------------------
TEST(Strips, RandomTrianglesHoweverTheyMeet)
{
  std::mt19937 random(3);
  for (const std::uint32_t points : { 4u, 6u, 10u, 100u })
  {
    for (int run = 0; run < 100; ++run)
    {
      std::uniform_int_distribution<std::uint32_t> pick(0, points - 1);
      std::vector<StripTriangle> triangles;
      while (triangles.size() < 200)
      {
        const StripTriangle t = { pick(random), pick(random), pick(random) };
        // Now and then corners fall together; the same triangle comes again and again.
        if (run % 4 == 0 || (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]))
        {
          triangles.push_back(t);
        }
      }
      ExpectSame(triangles);
    }
  }
}

//------------------------------------------------------------------------------
TEST(Strips, SurfaceOfAMeshBecomesMuchLess)
{
  const auto mesh = MakeCubes(12, 0.2);
  std::vector<double> values(mesh.GetPoints());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double* x = &mesh.Coordinates[3 * i];
    values[i] = std::hypot(x[0] - 6, x[1] - 6, x[2] - 6);
  }
  MarchInput input;
  input.Points = mesh.GetPoints();
  input.Connectivity = mesh.Ids.data();
  input.Values = values.data();
  const auto surface = March(input, 0, mesh.GetTets(), std::vector{ 2.0, 4.5 });
  ASSERT_GT(surface.Triangles.size(), 2000u);
  EXPECT_LT(2 * ExpectSame(surface.Triangles), surface.Triangles.size());
}
}
