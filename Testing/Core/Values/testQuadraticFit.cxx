// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFloatEnvironment.h"
#include "gatunNeighborLists.h"
#include "gatunQuadraticLanes.h"
#include "gatunQuadraticMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <span>
#include <utility>

namespace
{
using namespace gatun;
using namespace gatun::test;

//------------------------------------------------------------------------------
// Lists of neighbors

/** Own vertices, and the vertices that they know at most two edges away, by sets. */
std::vector<std::set<Vertex>> FindKnown(const ChunkMesh& mesh)
{
  const auto& walk = mesh.Walk;
  const auto count = walk.Sources.size();
  std::vector<std::set<Vertex>> edges(count);
  for (const auto& [a, b] : walk.EdgeLog)
  {
    edges[a].insert(b);
    edges[b].insert(a);
  }
  std::vector<std::set<Vertex>> result;
  for (Vertex v = 0; v < count; ++v)
  {
    if (walk.IsShared(v))
    {
      continue;
    }
    const auto isKnown = [&](Vertex u) { return walk.IsShared(u) || u < v; };
    auto& known = result.emplace_back();
    for (const auto u : edges[v])
    {
      if (isKnown(u))
      {
        known.insert(u);
        std::copy_if(edges[u].begin(), edges[u].end(), std::inserter(known, known.end()),
          [&](Vertex w) { return w != v && isKnown(w); });
      }
    }
  }
  return result;
}

TEST(QuadraticFit, NeighborsAreTheNearestKnownVertices)
{
  const FloatEnvironment guard;
  const auto meshHeld = MakeMesh(6);
  const auto& mesh = *meshHeld;
  const auto places = mesh.GetPlaces();
  const auto lists = NeighborLists::OfWalk(mesh.Walk, places);
  const auto known = FindKnown(mesh);
  ASSERT_EQ(lists.GetCenters(), known.size());
  std::size_t full = 0;
  for (std::size_t own = 0; own < known.size(); ++own)
  {
    const auto v = mesh.OwnIds[own];
    const auto distance = [&](Vertex u)
    {
      double square = 0;
      for (unsigned i = 0; i < 3; ++i)
      {
        square += (places[u][i] - places[v][i]) * (places[u][i] - places[v][i]);
      }
      return static_cast<float>(square);
    };
    const auto list = lists.Of(own);
    const std::set<Vertex> found(list.begin(), list.end());
    EXPECT_EQ(found.size(), list.size());
    EXPECT_EQ(list.size(), std::min(NeighborLists::MaxNeighbors, known[own].size()));
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end(),
      [&](Vertex a, Vertex b) { return std::pair(distance(a), a) < std::pair(distance(b), b); }));
    float farthest = 0;
    for (const auto u : list)
    {
      EXPECT_TRUE(known[own].count(u)) << v << " " << u;
      farthest = std::max(farthest, distance(u));
    }
    for (const auto u : known[own])
    {
      EXPECT_TRUE(found.count(u) || distance(u) >= farthest) << v << " " << u;
    }
    full += list.size() == NeighborLists::MaxNeighbors && list.size() < known[own].size();
  }
  EXPECT_GT(full, known.size() / 4); // otherwise nothing was chosen
}

//------------------------------------------------------------------------------
// Weights

/** Lanes with different numbers of neighbors at random places. */
QuadraticLanes MakeLanes(unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> place(0, 60);
  QuadraticLanes lanes{};
  for (std::size_t lane = 0; lane < QuadraticLanes::Count; ++lane)
  {
    const std::size_t count = (seed + 5 * lane) % (NeighborLists::MaxNeighbors + 1);
    for (std::size_t i = 0; i < count; ++i)
    {
      auto& [x, y, z] = lanes.Offsets;
      x[i][lane] = lane == 5 ? 0 : place(random);              // all at the center
      y[i][lane] = lane == 3 || lane == 5 ? 0 : place(random); // on a line
      z[i][lane] = lane >= 3 && lane <= 5 ? 0 : place(random); // in a plane
      lanes.Share[i][lane] = i % 3 == 0 ? 0.0f : 1.0f;
    }
    lanes.Size[lane] = static_cast<float>(count);
    lanes.PerNeighbor[lane] = 3 / static_cast<float>(std::max<std::size_t>(count, 1));
    lanes.Neighbors = std::max(lanes.Neighbors, count);
  }
  return lanes;
}

TEST(QuadraticFit, AllVersionsGiveTheSameBits)
{
  const auto best = GetBestQuadraticWeights();
  if (best == GetPortableQuadraticWeights())
  {
    GTEST_SKIP() << "this processor has only the portable version";
  }
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    auto one = MakeLanes(seed);
    auto other = one;
    best(one);
    GetPortableQuadraticWeights()(other);
    for (std::size_t i = 0; i < one.Neighbors; ++i)
    {
      for (std::size_t lane = 0; lane < QuadraticLanes::Count; ++lane)
      {
        const auto expectSame = [&](float a, float b)
        {
          EXPECT_TRUE(std::isnan(a) ? std::isnan(b) : std::memcmp(&a, &b, sizeof(a)) == 0)
            << seed << " " << i << " " << lane << " " << a << " " << b;
        };
        expectSame(one.Quadratic[i][lane], other.Quadratic[i][lane]);
        expectSame(one.Linear[i][lane], other.Linear[i][lane]);
        expectSame(one.Share[i][lane], other.Share[i][lane]);
      }
    }
  }
}

TEST(QuadraticFit, OtherLanesAndTheirPaddingChangeNothing)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    auto together = MakeLanes(seed);
    for (std::size_t lane = 0; lane < QuadraticLanes::Count; ++lane)
    {
      auto alone = MakeLanes(seed);
      const auto count = (seed + 5 * lane) % (NeighborLists::MaxNeighbors + 1);
      alone.Neighbors = count;
      GetBestQuadraticWeights()(alone);
      auto all = together;
      GetBestQuadraticWeights()(all);
      for (std::size_t i = 0; i < count; ++i)
      {
        EXPECT_EQ(alone.Quadratic[i][lane], all.Quadratic[i][lane]);
        EXPECT_EQ(alone.Linear[i][lane], all.Linear[i][lane]);
        EXPECT_EQ(alone.Share[i][lane], all.Share[i][lane]);
      }
    }
  }
}

TEST(QuadraticFit, PredictsQuadraticFunctions)
{
  const FloatEnvironment guard;
  const auto meshHeld = MakeMesh(7);
  const auto& mesh = *meshHeld;
  const auto places = mesh.GetPlaces();
  const auto value = [](const std::array<double, 3>& p)
  { return 3 + p[0] - 2 * p[1] + 0.5 * p[0] * p[2] - 0.25 * p[1] * p[1]; };
  double quadratic = 0, linear = 0;
  std::size_t count = 0;
  for (std::size_t own = 0; own < mesh.OwnIds.size(); ++own)
  {
    const auto neighbors = mesh.Context.GetPoints().Quadratic->Of(own);
    if (neighbors.GetCount() < NeighborLists::MaxNeighbors)
    {
      continue;
    }
    const double actual = value(places[mesh.OwnIds[own]]);
    double a = 0, b = 0;
    for (std::size_t i = 0; i < neighbors.GetCount(); ++i)
    {
      const double difference = value(places[neighbors.Ids[i]]) - actual;
      a += neighbors.Quadratic[i] * difference;
      b += neighbors.Linear[i] * difference;
    }
    quadratic += std::abs(a);
    linear += std::abs(b);
    ++count;
  }
  ASSERT_GT(count, 50u);
  EXPECT_LT(quadratic, 0.2 * linear);
}

TEST(QuadraticFit, WeightsOfSingularNeighborhoodsAreFiniteAndSmall)
{
  const auto meshHeld = MakeMesh(6, MoveToSingular);
  const auto& mesh = *meshHeld;
  std::size_t equal = 0;
  for (std::size_t own = 0; own < mesh.OwnIds.size(); ++own)
  {
    const auto neighbors = mesh.Context.GetPoints().Quadratic->Of(own);
    double quadratic = 0, linear = 0, share = 0;
    for (std::size_t i = 0; i < neighbors.GetCount(); ++i)
    {
      quadratic += std::abs(neighbors.Quadratic[i]);
      linear += std::abs(neighbors.Linear[i]);
      share += neighbors.Shares[i];
      equal += neighbors.Quadratic[i] == 1 / static_cast<float>(neighbors.GetCount());
    }
    EXPECT_LE(quadratic, 1.001e4);
    EXPECT_LE(linear, 1.001e4);
    EXPECT_TRUE(share == 0 || std::abs(share - 1) < 1e-5) << share;
  }
  EXPECT_GT(equal, 0u); // some weights had to be replaced
}
}
