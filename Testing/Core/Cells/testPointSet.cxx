// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Convex point sets: the faces of their hulls, and their tetrahedra.

#include "gatunCellSplitter.h"
#include "gatunPointSet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace gatun::test
{
namespace
{
using Place = std::array<double, 3>;
using Places = std::vector<Place>;
using Tets = std::set<std::set<std::uint32_t>>;

/** Turned around two axes, so that no face is parallel to an axis. */
template <typename T>
std::vector<T> Turn(const Places& places)
{
  std::vector<T> turned;
  for (const auto& [x, y, z] : places)
  {
    const double u = 0.8 * x - 0.6 * y;
    const double v = 0.6 * x + 0.8 * y;
    for (const double c : { u, 0.28 * v - 0.96 * z, 0.96 * v + 0.28 * z })
    {
      turned.push_back(static_cast<T>(100 + 3 * c));
    }
  }
  return turned;
}

template <typename T>
Tets Split(int type, const std::vector<std::uint32_t>& corners, const std::vector<T>& places)
{
  CellSplitter<std::uint32_t, PointOrder<T>> splitter{ PointOrder<T>(places.data()) };
  Tets tets;
  splitter.Split(type, std::span<const std::uint32_t>(corners), std::span<const std::uint32_t>(),
    [&](const auto& tet) { tets.insert(std::set<std::uint32_t>(tet.begin(), tet.end())); });
  return tets;
}

template <typename T>
void ExpectSplitAsShape(int type, const Places& places)
{
  const auto turned = Turn<T>(places);
  std::vector<std::uint32_t> corners(places.size());
  std::iota(corners.begin(), corners.end(), 0u);
  const Tets right = Split(type, corners, turned);
  ASSERT_FALSE(right.empty());
  std::mt19937 random(3);
  for (int turn = 0; turn < 10; ++turn)
  {
    std::shuffle(corners.begin(), corners.end(), random);
    EXPECT_EQ(Split(ConvexPointSetType, corners, turned), right) << type;
  }
}

template <typename T>
void ExpectAllSplitAsShapes()
{
  const Places cube{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 } };
  ExpectSplitAsShape<T>(12, cube);
  ExpectSplitAsShape<T>(13, { cube[0], cube[1], cube[3], cube[4], cube[5], cube[7] });
  ExpectSplitAsShape<T>(14, { cube[0], cube[1], cube[2], cube[3], { 0.5, 0.5, 1 } });
  Places prism;
  for (const double z : { 0.0, 1.0 })
  {
    for (const double angle : { 0.0, 1.0, 2.0, 3.0, 4.0, 5.0 })
    {
      prism.push_back({ std::cos(angle * std::acos(0.5)), std::sin(angle * std::acos(0.5)), z });
    }
  }
  ExpectSplitAsShape<T>(16, prism);
}
}

TEST(PointSet, IsSplitAsTheShapeWithTheSameCorners)
{
  ExpectAllSplitAsShapes<float>();
  ExpectAllSplitAsShapes<double>();
}

TEST(PointSet, HasAClosedHullAroundAllPoints)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const std::size_t count : { 4, 5, 12, 64 })
  {
    Places places(count);
    for (auto& place : places)
    {
      place = { 1e6 * normal(random), 1e6 * normal(random), 1e6 * normal(random) };
    }
    places.back() = places.front(); // one place counts once
    places.resize(std::max<std::size_t>(count, 5), { 3, 4, 5 });
    std::multiset<std::pair<int, int>> edges;
    for (const auto& face : FindHullFaces(places))
    {
      ASSERT_GE(face.size(), 3u);
      const Place& a = places[face[0]];
      const Place& b = places[face[1]];
      const Place& c = places[face[2]];
      for (const Place& p : places)
      {
        const Place u{ b[0] - a[0], b[1] - a[1], b[2] - a[2] };
        const Place v{ c[0] - a[0], c[1] - a[1], c[2] - a[2] };
        const double side = (p[0] - a[0]) * (u[1] * v[2] - u[2] * v[1]) +
          (p[1] - a[1]) * (u[2] * v[0] - u[0] * v[2]) + (p[2] - a[2]) * (u[0] * v[1] - u[1] * v[0]);
        EXPECT_LE(side, 1e13); // of 1e18: all are below
      }
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        edges.insert({ face[i], face[(i + 1) % face.size()] });
      }
    }
    ASSERT_FALSE(edges.empty());
    for (const auto& [from, to] : edges)
    {
      EXPECT_EQ(edges.count({ from, to }), 1u);
      EXPECT_EQ(edges.count({ to, from }), 1u);
    }
  }
}

TEST(PointSet, HasNoFacesWithoutAVolume)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(FindHullFaces({}).empty());
  EXPECT_TRUE(FindHullFaces(Places(10, Place{ 1, 2, 3 })).empty());
  Places places{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0.5, 0.25, 0 } };
  EXPECT_TRUE(FindHullFaces(places).empty());
  places.push_back({ 0, 0, 1 });
  EXPECT_EQ(FindHullFaces(places).size(), 5u);
  places.push_back({ 0, 0, infinity });
  EXPECT_TRUE(FindHullFaces(places).empty());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere;
  places.clear();
  for (int i = 0; i < 65; ++i)
  {
    places.push_back({ anywhere(random), anywhere(random), anywhere(random) });
  }
  EXPECT_TRUE(FindHullFaces(places).empty());
  places.pop_back();
  EXPECT_FALSE(FindHullFaces(places).empty());
}
}
