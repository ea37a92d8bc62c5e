// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The list of merges; and which merges of the boundary come first.

#include "gatunError.h"
#include "gatunMergeBuilder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace gatun::test
{
namespace
{
//------------------------------------------------------------------------------
TEST(MergeBuilder, SmoothBoundariesBecomeCoarserBeforeSharpPartsVanish)
{
  // Two cones on deep columns, one flat and wide, one narrow and high. The flat one has the larger
  // volume.
  constexpr unsigned sides = 6;
  std::vector<std::array<double, 3>> points;
  std::vector<MergeTree::Tet> tets;
  const auto addCone = [&](double x, double radius, double height)
  {
    const auto tip = static_cast<std::uint32_t>(points.size());
    points.push_back({ x, 0, height });
    points.push_back({ x, 0, -20 });
    for (unsigned i = 0; i < sides; ++i)
    {
      const double angle = 2 * std::acos(-1.0) * i / sides;
      points.push_back({ x + radius * std::cos(angle), radius * std::sin(angle), 0 });
      tets.push_back({ tip + 1, tip + 2 + i, tip + 2 + (i + 1) % sides, tip });
    }
    return tip;
  };
  const auto flat = addCone(0, 1, 0.05);
  const auto sharp = addCone(5, 0.3, 0.5);
  const auto tree = BuildMergeTree({ points, tets, {} });
  const auto& merges = tree.GetMerges();
  const auto find = [&](std::uint32_t point)
  {
    return std::find_if(
      merges.begin(), merges.end(), [=](const Merge& merge) { return merge.Point == point; });
  };
  ASSERT_NE(find(flat), merges.end());
  EXPECT_LT(find(flat), find(sharp));
}

//------------------------------------------------------------------------------
TEST(MergeTree, DoesNotSeparateMergesThatBelongTogether)
{
  const std::vector<Merge> merges{ { 1, 0, 1 }, { 2, 3, 1 }, { 4, 3, 1 }, { 0, 3, 2 } };
  const MergeTree free(6, merges);
  const MergeTree bound(6, merges, { false, true, true, false });
  for (std::size_t n = 0; n < 7; ++n)
  {
    const std::size_t most = std::min<std::size_t>(n, 4);
    EXPECT_EQ(free.CountWholeMerges(n), most);
    EXPECT_EQ(bound.CountWholeMerges(n), n == 2 || n == 3 ? 1 : most);
  }
  EXPECT_THROW(MergeTree(6, merges, { false, true, true }), Error);
  EXPECT_THROW(MergeTree(6, merges, { false, true, true, true }), Error);
}

//------------------------------------------------------------------------------
TEST(MergeTree, OnlyTrianglesWithCornersThatBecomeOneVanish)
{
  const std::vector<std::uint32_t> ancestors{ 0, 0, 2, 2, 4 };
  const auto simplify = [&](MergeTree::Triangle triangle)
  {
    const bool isLeft = Simplify(triangle, ancestors);
    return std::pair(isLeft, triangle);
  };
  EXPECT_EQ(simplify({ 1, 3, 4 }), std::pair(true, MergeTree::Triangle{ 0, 2, 4 }));
  EXPECT_FALSE(simplify({ 0, 1, 4 }).first);
  EXPECT_FALSE(simplify({ 4, 3, 2 }).first);
  // One that has a corner twice from the beginning.
  EXPECT_EQ(simplify({ 1, 1, 3 }), std::pair(true, MergeTree::Triangle{ 0, 0, 2 }));
  EXPECT_EQ(simplify({ 1, 1, 1 }), std::pair(true, MergeTree::Triangle{ 0, 0, 0 }));
  EXPECT_FALSE(simplify({ 1, 1, 0 }).first);
}

//------------------------------------------------------------------------------
TEST(MergeTree, CountsMerges)
{
  const MergeTree tree(6, { { 1, 0, 1 }, { 2, 3, 5 }, { 0, 3, 2 }, { 4, 5, 9 } });
  EXPECT_EQ(tree.CountMergesForPoints(6), 0u);
  EXPECT_EQ(tree.CountMergesForPoints(7), 0u);
  EXPECT_EQ(tree.CountMergesForPoints(4), 2u);
  EXPECT_EQ(tree.CountMergesForPoints(0), 4u);
  EXPECT_EQ(tree.CountMergesForError(0.5), 0u);
  EXPECT_EQ(tree.CountMergesForError(1), 1u);
  EXPECT_EQ(tree.CountMergesForError(4), 1u); // the third one is cheaper than the second
  EXPECT_EQ(tree.CountMergesForError(5), 3u);
  EXPECT_EQ(tree.CountMergesForError(1e9), 4u);
  EXPECT_EQ(tree.CountMergesForError(std::nan("")), 0u);
  using Ids = std::vector<std::uint32_t>;
  EXPECT_EQ(tree.FindAncestors(0), (Ids{ 0, 1, 2, 3, 4, 5 }));
  EXPECT_EQ(tree.FindAncestors(1), (Ids{ 0, 0, 2, 3, 4, 5 }));
  EXPECT_EQ(tree.FindAncestors(3), (Ids{ 3, 3, 3, 3, 4, 5 }));
  EXPECT_EQ(tree.FindAncestors(99), (Ids{ 3, 3, 3, 3, 5, 5 }));
}

//------------------------------------------------------------------------------
TEST(MergeTree, RefusesMergesThatCannotBe)
{
  const auto refuses = [](std::vector<Merge> merges)
  { EXPECT_THROW(MergeTree(4, std::move(merges)), Error); };
  refuses({ { 4, 0, 1 } });
  refuses({ { 0, 4, 1 } });
  refuses({ { 2, 2, 1 } });
  refuses({ { 0, 1, 1 }, { 0, 2, 1 } }); // gone
  refuses({ { 0, 1, 1 }, { 2, 0, 1 } });
  refuses({ { 0, 1, -1 } });
  refuses({ { 0, 1, std::nanf("") } });
}
} // anonymous namespace
}
