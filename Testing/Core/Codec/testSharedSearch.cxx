// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The search for the best shared vertex against the search for the list of the best ones.

#include "gatunSharedSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace gatun;

LatticePoint Pick(std::mt19937& random, unsigned steps)
{
  const auto pick = [&] { return static_cast<float>(random() % steps) * (255.0F / 256.0F); };
  return { pick(), pick(), pick(), 0 };
}

/** Compares both searches for random gates, while vertices are removed. Returns how many gates had
 * a vertex. Steps: the places along an axis; few of them give equal ranks. */
template <typename MakeRanks>
unsigned Compare(std::size_t vertices, unsigned steps, float reach, MakeRanks&& makeRanks)
{
  std::mt19937 random(static_cast<unsigned>(vertices) + steps);
  std::vector<LatticePoint> points(vertices);
  std::generate(points.begin(), points.end(), [&] { return Pick(random, steps); });
  SharedSearch search(points);
  unsigned found = 0;
  for (int i = 0; i < 500; ++i)
  {
    const auto a = Pick(random, steps);
    const auto b = Pick(random, steps);
    const auto c = Pick(random, steps);
    const GatePlane plane(a, b, c);
    const GateCircle circle(plane);
    const auto ranks = makeRanks(plane, circle);
    const auto list = search.Find(plane, reach, ranks);
    const auto best = search.FindBest(plane, reach, ranks);
    EXPECT_EQ(best, list.Count > 0 ? list.List[0].Id : NoVertex);
    if (best != NoVertex && !search.IsGone(best))
    {
      ++found;
      if (i % 3 == 0)
      {
        search.Remove(best);
      }
    }
  }
  return found;
}
}

TEST(SharedSearch, FindsTheBestVertexFirst)
{
  const auto spheres = [](const GatePlane& plane, const GateCircle& circle)
  { return [&](const Vec3x4& places, Float4) { return circle.GetSpheres(plane, places); }; };
  const auto distances = [](const GatePlane& plane, const GateCircle&)
  {
    return [&](const Vec3x4& places, Float4 squares)
    { return plane.SelectInFront(places, squares); };
  };
  for (const std::size_t vertices : { 0, 1, 2, 3, 5, 100, 5000 })
  {
    for (const unsigned steps : { 3u, 9u, 256u })
    {
      for (const float reach : { 0.2F, 1.25F, 3.0F })
      {
        const auto found =
          Compare(vertices, steps, reach, spheres) + Compare(vertices, steps, reach, distances);
        EXPECT_TRUE(vertices < 100 || reach < 1 || found > 100) << vertices << " " << steps;
      }
    }
  }
}

TEST(SharedSearch, PassesOverRanksThatAreNotNumbers)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto never = [](const GatePlane&, const GateCircle&)
  { return [](const Vec3x4&, Float4) { return Splat(NeverRank); }; };
  const auto odd = [nan](const GatePlane&, const GateCircle&)
  {
    return [nan](const Vec3x4& places, Float4)
    { return SelectGreater(places.X, Splat(100.0F), Splat(nan), places.Y); };
  };
  EXPECT_EQ(Compare(1000, 256, 3.0F, never), 0u);
  EXPECT_GT(Compare(1000, 256, 3.0F, odd), 100u);
}
