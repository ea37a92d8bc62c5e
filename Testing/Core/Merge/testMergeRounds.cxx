// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Rounds of merges that may be done in any order, in memory and in streams.

#include "gatunError.h"
#include "gatunMergeCodec.h"
#include "gatunTestSolids.h"
#include "gatunTestTrees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace gatun::test
{
namespace
{
const Solid& GetCube()
{
  static const Solid cube = MakeSolid(20, 0.25, [](const Position&) { return true; });
  return cube;
}

const MergeTree& GetTree()
{
  static const MergeTree tree = BuildMergeTree(GetCube().GetInput());
  return tree;
}

/** The end of each round. */
std::vector<std::uint32_t> GetEnds(const MergeTree& tree)
{
  std::vector<std::uint32_t> ends(tree.GetRounds().begin() + 1, tree.GetRounds().end());
  ends.push_back(static_cast<std::uint32_t>(tree.GetMerges().size()));
  return ends;
}

/** Numbers of points in any order. */
std::vector<std::uint32_t> Shuffle(std::size_t count, unsigned seed)
{
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::mt19937 random(seed);
  std::shuffle(numbers.begin(), numbers.end(), random);
  return numbers;
}

/** Expects that no tetrahedron is turned over, and that they meet in pairs. */
void ExpectValid(const MergeTree& tree, std::size_t merges)
{
  const Solid& cube = GetCube();
  const auto ancestors = tree.FindAncestors(merges);
  std::vector<MergeTree::Tet> left;
  std::set<Simplex> places;
  for (const auto& tet : cube.Tets)
  {
    auto moved = tet;
    if (Simplify(moved, ancestors))
    {
      ASSERT_GT(GetTetVolume(cube.Points, moved) * GetTetVolume(cube.Points, tet), 0) << merges;
      left.push_back(moved);
      ASSERT_TRUE(places.emplace(moved.begin(), moved.end()).second) << merges;
    }
  }
  for (const auto& [face, count] : CountFaces(left))
  {
    ASSERT_LE(count, 2) << merges;
  }
}

TEST(MergeRounds, TheirMergesMayBeDoneInAnyOrder)
{
  const MergeTree& tree = GetTree();
  ASSERT_FALSE(tree.GetRounds().empty());
  const auto ends = GetEnds(tree);
  EXPECT_LT(ends.size(), tree.GetMerges().size() - 3000); // the last ones are single
  for (unsigned seed = 0; seed < 3; ++seed)
  {
    auto merges = tree.GetMerges();
    std::mt19937 random(seed);
    std::uint32_t first = 0;
    for (const auto end : ends)
    {
      std::shuffle(merges.begin() + first, merges.begin() + end, random);
      EXPECT_EQ(merges[first].Error, merges[end - 1].Error);
      first = end;
    }
    const MergeTree other(tree.GetNumberOfPoints(), merges);
    for (std::size_t n = 150 + seed; n < 5000; n += 487)
    {
      ExpectValid(other, n);
    }
  }
}

TEST(MergeRounds, AreSortedByNumbers)
{
  const MergeTree& tree = GetTree();
  const auto numbers = Shuffle(tree.GetNumberOfPoints(), 7);
  const std::uint32_t inside = tree.GetRounds()[3] + 1;
  ASSERT_LT(inside, tree.GetRounds()[4]);
  const MergeTree sorted = SortRounds(tree, numbers, std::vector<std::uint32_t>{ inside });
  EXPECT_EQ(sorted.GetRounds(), tree.GetRounds());
  const auto pointOf = [](const Merge& merge) { return merge.Point; };
  std::uint32_t first = 0;
  auto ends = GetEnds(tree);
  ends.insert(std::lower_bound(ends.begin(), ends.end(), inside), inside);
  for (const auto end : ends)
  {
    std::vector<std::uint32_t> before, after;
    std::transform(tree.GetMerges().begin() + first, tree.GetMerges().begin() + end,
      std::back_inserter(before), pointOf);
    std::transform(sorted.GetMerges().begin() + first, sorted.GetMerges().begin() + end,
      std::back_inserter(after), pointOf);
    std::sort(before.begin(), before.end(),
      [&](std::uint32_t a, std::uint32_t b) { return numbers[a] < numbers[b]; });
    EXPECT_EQ(before, after);
    first = end;
  }
}

TEST(MergeRounds, MergesThatBelongTogetherStayTogether)
{
  const std::vector<Merge> merges{ { 5, 0, 1 }, { 3, 1, 1 }, { 4, 2, 1 }, { 2, 0, 2 } };
  const MergeTree tree(6, merges, { false, true, false, false }, { 0, 3 });
  const MergeTree sorted = SortRounds(tree, std::vector<std::uint32_t>{ 0, 1, 2, 3, 4, 5 });
  const MergeTree expected(6, { { 3, 1, 1 }, { 4, 2, 1 }, { 5, 0, 1 }, { 2, 0, 2 } },
    { true, false, false, false }, { 0, 3 });
  ExpectSame(sorted, expected);
  EXPECT_EQ(sorted.GetBonds(), expected.GetBonds());
  EXPECT_EQ(tree.CountMergesOfRounds(1), 3u);
  EXPECT_EQ(tree.CountMergesOfRounds(3), 3u);
  EXPECT_EQ(tree.CountMergesForPoints(2), 4u);
  EXPECT_EQ(tree.CountMergesForPoints(5), 3u);
  EXPECT_THROW(MergeTree(6, merges, { false, true, false, false }, { 0, 2 }), Error);
  EXPECT_THROW(MergeTree(6, merges, {}, { 1 }), Error);
  EXPECT_THROW(MergeTree(6, merges, {}, { 0, 2, 2 }), Error);
  EXPECT_THROW(MergeTree(6, merges, {}, { 0, 4 }), Error);
}

TEST(MergeRounds, AreInStreams)
{
  const MergeTree sorted =
    SortRounds(GetTree(), Shuffle(GetTree().GetNumberOfPoints(), 3)); // by no number of the stream
  for (const MergeTree& tree : { GetTree(), sorted })
  {
    const auto points = tree.GetNumberOfPoints();
    const auto merges = static_cast<std::uint32_t>(tree.GetMerges().size());
    const auto back = DecodeMerges(EncodeMerges(tree, points, merges, MergeKind::Tetrahedra),
      points, merges, MergeKind::Tetrahedra);
    ExpectSame(tree, back);
    EXPECT_EQ(tree.GetRounds(), back.GetRounds());
  }
}

/** The merges of a mesh from a base mesh on are stored in the numbers of that. */
TEST(MergeRounds, PartsOfATreeAreJoined)
{
  const MergeTree& tree = GetTree();
  const auto points = tree.GetNumberOfPoints();
  const auto count = tree.GetRounds()[5];
  const std::vector<Merge> all = tree.GetMerges();
  const MergeTree first(points, { all.begin(), all.begin() + count }, {},
    { tree.GetRounds().begin(), tree.GetRounds().begin() + 5 });
  const auto ancestors = tree.FindAncestors(count);
  const auto map = DecodePointMap(EncodePointMap(Shuffle(points - count, 11)), points - count);
  ASSERT_EQ(map, Shuffle(points - count, 11));
  std::vector<std::uint32_t> numbers(points);
  auto next = map.begin();
  for (std::uint32_t i = 0; i < points; ++i)
  {
    numbers[i] = ancestors[i] == i ? *next++ : 0;
  }
  std::vector<Merge> rest(all.begin() + count, all.end());
  for (Merge& merge : rest)
  {
    merge.Point = numbers[merge.Point];
    merge.Into = numbers[merge.Into];
  }
  std::vector<std::uint32_t> rounds(tree.GetRounds().begin() + 5, tree.GetRounds().end());
  for (auto& round : rounds)
  {
    round -= count;
  }
  const MergeTree joined = JoinMerges(first, MergeTree(points - count, rest, {}, rounds), map);
  ExpectSame(joined, tree);
  EXPECT_EQ(joined.GetRounds(), tree.GetRounds());
  // Without the rounds of a part, nothing is known about them.
  EXPECT_TRUE(JoinMerges(first, MergeTree(points - count, rest), map).GetRounds().empty());
}

TEST(MergeRounds, DamagedNumbersOfPointsAreRefused)
{
  const auto numbers = Shuffle(300, 2);
  const auto good = EncodePointMap(numbers);
  std::vector<std::uint32_t> all(300);
  std::iota(all.begin(), all.end(), 0u);
  const auto refused = CountRefused(good, 500,
    [&](const Bytes& bad)
    {
      auto decoded = DecodePointMap(bad, 300);
      std::sort(decoded.begin(), decoded.end());
      EXPECT_EQ(decoded, all);
    });
  EXPECT_GT(refused, 400u);
  EXPECT_THROW(DecodePointMap(good, 299), Error);
}
}
}
