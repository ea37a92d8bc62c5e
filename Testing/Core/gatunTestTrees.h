// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTestTrees_h
#define gatunTestTrees_h

#include "gatunBytes.h"
#include "gatunError.h"
#include "gatunMergeBuilder.h"
#include "gatunMergeTree.h"
#include "gatunTestFile.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace gatun::test
{
/** The tree of a mesh by its field. */
inline MergeTree BuildTree(const TestMesh& mesh)
{
  std::vector<std::array<double, 3>> points(mesh.GetPoints());
  std::vector<MergeTree::Tet> tets(mesh.GetTets());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::copy_n(&mesh.Coordinates[3 * i], 3, points[i].begin());
  }
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    std::copy_n(&mesh.Ids[4 * i], 4, tets[i].begin());
  }
  const Values values(mesh);
  const std::vector<double> field(values.Field.begin(), values.Field.end());
  return BuildMergeTree({ points, tets, { { field, 1 } } });
}

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

/** Damages a stream in many ways, and calls decode with it, which may check what it decodes.
 * Returns how often it throws; all errors must be those of a damaged stream. */
template <typename Decode>
std::size_t CountRefused(const Bytes& good, unsigned tries, Decode&& decode)
{
  std::mt19937 random(3);
  std::size_t refused = 0;
  for (unsigned i = 0; i < tries; ++i)
  {
    auto bad = good;
    if (i % 3 == 0)
    {
      bad.resize(random() % bad.size());
    }
    else
    {
      bad[random() % bad.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
    }
    try
    {
      decode(bad);
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Corrupt);
      ++refused;
    }
  }
  return refused;
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
