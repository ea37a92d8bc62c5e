// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTestTrees_h
#define gatunTestTrees_h

#include "gatunMergeTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace gatun::test
{
inline void ExpectSame(const MergeTree& a, const MergeTree& b)
{
  ASSERT_EQ(a.GetNumberOfPoints(), b.GetNumberOfPoints());
  ASSERT_EQ(a.GetMerges().size(), b.GetMerges().size());
  for (std::size_t i = 0; i < a.GetMerges().size(); ++i)
  {
    const Merge& x = a.GetMerges()[i];
    const Merge& y = b.GetMerges()[i];
    ASSERT_TRUE(x.Point == y.Point && x.Into == y.Into && x.Error == y.Error) << i;
  }
}

/** Merges of any points into any others, with errors of all magnitudes. */
inline MergeTree MakeWildTree(std::uint32_t points, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::uint32_t> left(points);
  std::iota(left.begin(), left.end(), 0u);
  std::shuffle(left.begin(), left.end(), random);
  std::vector<Merge> merges;
  const float errors[] = { 0, std::numeric_limits<float>::denorm_min(), 1e-20f, 1, 1e30f,
    std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity() };
  while (left.size() > 1)
  {
    const auto point = left.back();
    left.pop_back();
    const auto done = merges.size() * std::size(errors) / points;
    merges.push_back({ point, left[random() % left.size()], errors[done] });
  }
  return { points, std::move(merges) };
}
}

#endif
