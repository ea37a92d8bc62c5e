// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunIntervalTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace gatun::test
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/** By looking at every range: a corner whose value is the isovalue is one above it. */
std::vector<std::uint32_t> FindSlowly(const std::vector<Range>& ranges, double value)
{
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < ranges.size(); ++i)
  {
    if (ranges[i].Min < value && value <= ranges[i].Max)
    {
      found.push_back(i);
    }
  }
  return found;
}

/** What Find calls, each once. */
std::vector<std::uint32_t> FindOne(const IntervalTree& tree, double value)
{
  std::vector<std::uint32_t> found;
  tree.Find(value, [&](std::uint32_t i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

void ExpectSame(const std::vector<Range>& ranges, const std::vector<double>& values)
{
  const IntervalTree tree(ranges);
  std::vector<std::uint32_t> any;
  for (const double value : values)
  {
    const auto expected = FindSlowly(ranges, value);
    ASSERT_EQ(FindOne(tree, value), expected) << value << " in " << ranges.size() << " ranges";
    any.insert(any.end(), expected.begin(), expected.end());
  }
  std::sort(any.begin(), any.end());
  any.erase(std::unique(any.begin(), any.end()), any.end());
  EXPECT_EQ(tree.FindAny(values), any);
}
}

//------------------------------------------------------------------------------
TEST(IntervalTree, FindsWhatBruteForceFinds)
{
  std::mt19937 random(1);
  for (const std::size_t count : { 1, 2, 3, 10, 100, 3000 })
  {
    for (const int ends : { 3, 20, 1000000 }) // few: many ends are equal
    {
      std::uniform_int_distribution<int> pick(-ends, ends);
      std::vector<Range> ranges(count);
      for (auto& range : ranges)
      {
        range = { static_cast<double>(pick(random)), static_cast<double>(pick(random)) };
        if (pick(random) % 4 != 0 && range.Min > range.Max)
        {
          std::swap(range.Min, range.Max); // the others stay empty
        }
      }
      std::vector<double> values;
      for (int i = 0; i < 1000; ++i)
      {
        values.push_back(pick(random) + (i % 3 == 0 ? 0.5 : 0));
        const auto& range = ranges[static_cast<std::size_t>(i) % count];
        values.push_back(i % 2 == 0 ? range.Min : range.Max);
      }
      ExpectSame(ranges, values);
    }
  }
}

//------------------------------------------------------------------------------
TEST(IntervalTree, LowerEndIsOutsideAndUpperEndIsInside)
{
  const std::vector<Range> ranges = { { 1, 2 }, { 2, 3 }, { 2, 2 }, { 1, 3 } };
  const IntervalTree tree(ranges);
  using Found = std::vector<std::uint32_t>;
  EXPECT_EQ(FindOne(tree, 1), Found());
  EXPECT_EQ(FindOne(tree, std::nextafter(1.0, 2.0)), (Found{ 0, 3 }));
  EXPECT_EQ(FindOne(tree, 2), (Found{ 0, 3 }));
  EXPECT_EQ(FindOne(tree, std::nextafter(2.0, 3.0)), (Found{ 1, 3 }));
  EXPECT_EQ(FindOne(tree, 3), (Found{ 1, 3 }));
  EXPECT_EQ(FindOne(tree, std::nextafter(3.0, 4.0)), Found());
}

//------------------------------------------------------------------------------
TEST(IntervalTree, TakesInfiniteEndsAndEmptyRanges)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double largest = std::numeric_limits<double>::max();
  const std::vector<Range> ranges = { { -Infinity, Infinity }, { 0, Infinity }, { -Infinity, 0 },
    { Infinity, Infinity }, { -Infinity, -Infinity }, {}, { Infinity, -Infinity }, { nan, 1 },
    { 0, nan }, { -largest, largest }, { 0, 0 }, { -0.0, 0.0 },
    { 0, std::numeric_limits<double>::denorm_min() } };
  ExpectSame(ranges,
    { 0, -0.0, 1, -1, largest, -largest, 1e300, -1e300, Infinity, -Infinity,
      std::numeric_limits<double>::denorm_min() });
  EXPECT_TRUE(FindOne(IntervalTree({}), 0).empty());
  EXPECT_TRUE(IntervalTree(std::vector<Range>{ Range{} }).FindAny(std::vector{ 0.0 }).empty());
  EXPECT_TRUE(IntervalTree(ranges).FindAny({}).empty());
}

//------------------------------------------------------------------------------
TEST(IntervalTree, ManyRangesOfOneKindDoNotNestDeeply)
{
  // All the same, all with one lower end, all with one upper end, one behind the other, nested: a
  // tree as deep as there are ranges would not fit the stack.
  constexpr std::size_t count = 1000000;
  const std::vector<double> values = { 0, 0.5, 1, 2, 499999.5, 500000, 999999, 1e6, 1e6 + 1 };
  for (int kind = 0; kind < 5; ++kind)
  {
    std::vector<Range> ranges(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto x = static_cast<double>(i);
      const Range kinds[] = { { 0, 1 }, { 0, x + 1 }, { x, 1e6 }, { x, x + 1 }, { -x, x + 1 } };
      ranges[i] = kinds[kind];
    }
    ExpectSame(ranges, values);
  }
}
}
