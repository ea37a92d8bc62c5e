// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Merges of a mesh in parts are as good as those of the whole, whatever the parts are.

#include "gatunDependencyCheck.h"
#include "gatunError.h"
#include "gatunMergeBuilder.h"
#include "gatunParallel.h"
#include "gatunTestSolids.h"
#include "gatunTestTrees.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <numeric>

namespace gatun::test
{
namespace
{
PartMergeSettings MakeSettings(std::uint64_t tetsOfGroup)
{
  PartMergeSettings settings;
  settings.TetsOfGroup = tetsOfGroup;
  settings.Folder = GATUN_TEST_TEMP;
  return settings;
}

Solid MakeBlock(std::int64_t n)
{
  return MakeSolid(n, 0.2, [](const Position&) { return true; });
}

/** The root mean square error of the field at the points that are gone, where it is interpolated in
 * the tetrahedron that has them. */
double MeasureError(const Solid& solid, const MergeTree& tree, std::size_t merges)
{
  const auto tets = SimplifyAll(solid.Tets, tree, merges);
  std::vector<double> inside(solid.Points.size(), -std::numeric_limits<double>::max());
  std::vector<double> values(solid.Points.size());
  for (const auto& tet : tets)
  {
    const double whole = GetTetVolume(solid.Points, tet);
    Position low = solid.Points[tet[0]];
    Position high = low;
    for (const auto corner : tet)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], solid.Points[corner][axis]);
        high[axis] = std::max(high[axis], solid.Points[corner][axis]);
      }
    }
    for (std::uint32_t point = 0; point < solid.Points.size(); ++point)
    {
      const Position& p = solid.Points[point];
      if (p[0] < low[0] || p[1] < low[1] || p[2] < low[2] || p[0] > high[0] || p[1] > high[1] ||
        p[2] > high[2])
      {
        continue;
      }
      double least = 1;
      double value = 0;
      for (std::size_t i = 0; i < 4; ++i)
      {
        auto other = tet;
        other[i] = point;
        const double part = GetTetVolume(solid.Points, other) / whole;
        least = std::min(least, part);
        value += part * solid.Values[tet[i]];
      }
      if (least > inside[point])
      {
        inside[point] = least;
        values[point] = value;
      }
    }
  }
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double difference = inside[i] > -0.1 ? values[i] - solid.Values[i] : 0;
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}
}

//------------------------------------------------------------------------------
TEST(PartMerges, AreNearlyAsGoodAsThoseOfTheWhole)
{
  // 63,888 tetrahedra. The boundary is flat, so that all points stay inside.
  const Solid solid = MakeSolid(22, 0, [](const Position&) { return true; });
  const MergeTree whole = BuildMergeTree(solid.GetInput());
  const MergeTree parts = BuildInParts(solid, 1, MakeSettings(10000));
  EXPECT_NEAR(static_cast<double>(parts.GetMerges().size()),
    static_cast<double>(whole.GetMerges().size()), 20);
  for (const double part : { 0.5, 0.75, 0.9, 0.98 })
  {
    const auto merges = static_cast<std::size_t>(part * static_cast<double>(solid.Points.size()));
    const double error = MeasureError(solid, whole, merges);
    EXPECT_LT(MeasureError(solid, parts, merges), 1.08 * error) << part;
    EXPECT_GT(error, 0);
  }
}

//------------------------------------------------------------------------------
TEST(PartMerges, DoNotDependOnThreads)
{
  const Solid solid = MakeBlock(9);
  MergeTree first;
  WithNumberOfThreads(1, [&] { first = BuildInParts(solid, 3, MakeSettings(700)); });
  EXPECT_GT(first.GetMerges().size(), solid.Points.size() / 2);
  for (const int threads : { 2, 5 })
  {
    MergeTree other;
    WithNumberOfThreads(threads, [&] { other = BuildInParts(solid, 3, MakeSettings(700)); });
    ExpectSame(first, other);
  }
}

//------------------------------------------------------------------------------
TEST(PartMerges, OfOneGroupAreThoseOfTheWhole)
{
  // In an order that may differ where a merge makes others cheaper.
  const Solid solid = MakeBlock(6);
  const auto list = [](const MergeTree& tree)
  {
    std::map<std::uint32_t, std::uint32_t> intoOf;
    for (const Merge& merge : tree.GetMerges())
    {
      intoOf[merge.Point] = merge.Into;
    }
    return intoOf;
  };
  EXPECT_EQ(
    list(BuildInParts(solid, 1, MakeSettings(100000))), list(BuildMergeTree(solid.GetInput())));
}

//------------------------------------------------------------------------------
TEST(PartMerges, ComeInAnOrderInWhichEachIsPossible)
{
  const Solid solid = MakeBlock(8);
  const MergeTree tree = BuildInParts(solid, 2, MakeSettings(500));
  auto tets = solid.Tets;
  for (const Merge& merge : tree.GetMerges())
  {
    bool isEdge = false;
    for (auto& tet : tets)
    {
      const auto has = [&](std::uint32_t point)
      { return std::find(tet.begin(), tet.end(), point) != tet.end(); };
      isEdge = isEdge || (has(merge.Point) && has(merge.Into));
      std::replace(tet.begin(), tet.end(), merge.Point, merge.Into);
    }
    ASSERT_TRUE(isEdge) << merge.Point;
    std::erase_if(tets, [](const auto& tet) { return Simplex(tet.begin(), tet.end()).size() < 4; });
  }
}

//------------------------------------------------------------------------------
TEST(PartMerges, HaveTheDependenciesOfAReplay)
{
  for (const char* const name : { "Block", "Lattice", "Ring", "Void", "Parts" })
  {
    const Solid solid = MakeSolid(name);
    for (const std::uint64_t most : { 100000, 700, 200 })
    {
      MergeDependencies dependencies;
      const MergeTree tree = BuildInParts(solid, 3, MakeSettings(most), &dependencies);
      const MergeDependencies replay(tree, solid.Tets);
      ASSERT_EQ(dependencies.GetNumberOfMerges(), replay.GetNumberOfMerges());
      for (std::size_t i = 0; i < replay.GetNumberOfMerges(); ++i)
      {
        const auto got = dependencies.Get(i);
        const auto expected = replay.Get(i);
        ASSERT_TRUE(std::equal(got.begin(), got.end(), expected.begin(), expected.end()))
          << name << " " << most << " " << i;
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(PartMerges, HaveDependenciesOfMergesInOtherGroups)
{
  // Where the boundary is rough, merges bare sides of tetrahedra in other groups of the pass.
  const Solid solid = MakeSolid(14, 0.3, [](const Position&) { return true; });
  for (const std::uint64_t most : { 3000, 1500, 700, 300 })
  {
    MergeDependencies dependencies;
    const MergeTree tree = BuildInParts(solid, 2, MakeSettings(most), &dependencies);
    EXPECT_TRUE(AreEquivalent(dependencies, MergeDependencies(tree, solid.Tets))) << most;
  }
}

//------------------------------------------------------------------------------
TEST(PartMerges, TakeWhatCannotBeMerged)
{
  // Tetrahedra with nothing in common do not get fewer, however long one tries.
  Solid solid;
  for (std::uint32_t i = 0; i < 500; ++i)
  {
    const double x = 3 * i;
    solid.Points.insert(
      solid.Points.end(), { { x, 0, 0 }, { x + 1, 0, 0 }, { x, 1, 0 }, { x, 0, 1 } });
    solid.Tets.push_back({ 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3 });
    solid.Values.insert(solid.Values.end(), { 1, 2, 3, 4 });
  }
  EXPECT_TRUE(BuildInParts(solid, 2, MakeSettings(50)).GetMerges().empty());
  EXPECT_TRUE(BuildInParts(Solid(), 1, MakeSettings(50)).GetMerges().empty());
  // A value that is not a number stays.
  Solid block = MakeBlock(6);
  constexpr std::uint32_t strange = 171;
  block.Values[strange] = std::numeric_limits<double>::quiet_NaN();
  const MergeTree tree = BuildInParts(block, 2, MakeSettings(300));
  EXPECT_GT(tree.GetMerges().size(), 100u);
  for (const Merge& merge : tree.GetMerges())
  {
    EXPECT_NE(merge.Point, strange);
  }
}

//------------------------------------------------------------------------------
TEST(PartMerges, StopWhenTheyShouldAndRefuseWhatDoesNotFit)
{
  const Solid solid = MakeBlock(6);
  std::vector<std::uint32_t> numbers(solid.Points.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  const auto points = static_cast<std::uint32_t>(numbers.size());
  PartMerges aborted(points, 1, MakeSettings(200));
  aborted.Add({ solid.GetInput(), numbers });
  double last = 0;
  EXPECT_THROW(aborted.Build(
                 [&](double done)
                 {
                   EXPECT_GE(done, last);
                   last = done;
                   return done < 0.4;
                 }),
    Error);
  PartMerges merges(points, 1, MakeSettings(200));
  numbers.back() = points;
  EXPECT_THROW(merges.Add({ solid.GetInput(), numbers }), Error);
  numbers.pop_back();
  EXPECT_THROW(merges.Add({ solid.GetInput(), numbers }), Error);
  auto settings = MakeSettings(200);
  settings.Merges.PartAtOnce = 0.5;
  EXPECT_THROW(PartMerges(points, 1, settings), Error);
  settings = MakeSettings(200);
  settings.Folder = "no such folder";
  EXPECT_THROW(PartMerges(points, 1, settings), Error);
}
}
