// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The queue of merges against containers of the standard library.

#include "gatunMergeQueue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace gatun::test
{
namespace
{
//------------------------------------------------------------------------------
TEST(MergeQueue, KeysAscendWithTheCostsAndDifferForDistantOnes)
{
  for (double cost = 1e-300; cost < 1e300; cost *= 1.01)
  {
    EXPECT_LE(MergeQueue::GetKey(cost), MergeQueue::GetKey(cost * 1.01));
    EXPECT_LT(MergeQueue::GetKey(cost), MergeQueue::GetKey(cost * 1.07));
  }
  EXPECT_EQ(MergeQueue::GetKey(0), 0);
}

//------------------------------------------------------------------------------
TEST(MergeQueue, TakesTheCheapestFirstInOrderOfThePoints)
{
  std::mt19937 random(1);
  std::map<MergeQueue::Key, std::multiset<std::uint32_t>> expected;
  MergeQueue queue;
  std::vector<std::uint32_t> points;
  MergeQueue::Key key = 0;
  const auto push = [&]
  {
    // Costs below the last ones, too.
    const MergeQueue::Key to =
      MergeQueue::GetKey(std::ldexp(1.0, -static_cast<int>(random() % 60)));
    const auto point = static_cast<std::uint32_t>(random() % 1000);
    queue.Push(to, point);
    expected[to].insert(point);
  };
  for (int i = 0; i < 500; ++i)
  {
    push();
  }
  for (int i = 0; i < 400; ++i)
  {
    ASSERT_EQ(queue.Take(key, points), !expected.empty());
    if (!expected.empty())
    {
      EXPECT_EQ(key, expected.begin()->first);
      const auto& all = expected.begin()->second;
      EXPECT_EQ(points, std::vector<std::uint32_t>(all.begin(), all.end()));
      expected.erase(expected.begin());
    }
    if (i < 200)
    {
      push();
    }
  }
  EXPECT_FALSE(queue.Take(key, points));
  EXPECT_TRUE(points.empty());
}
}
}
