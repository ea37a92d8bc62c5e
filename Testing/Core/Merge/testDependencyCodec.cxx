// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Streams of dependencies between merges.

#include "gatunDependencyCodec.h"
#include "gatunError.h"
#include "gatunMergeCut.h"
#include "gatunTestMeshes.h"
#include "gatunTestTrees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace gatun::test
{
namespace
{
std::vector<MergeTree::Tet> GetTets(const TestMesh& mesh)
{
  std::vector<MergeTree::Tet> tets(mesh.GetTets());
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    std::copy_n(&mesh.Ids[4 * i], 4, tets[i].begin());
  }
  return tets;
}

/** All that a merge depends on, directly or not. */
std::vector<std::set<std::uint32_t>> GetAll(const MergeDependencies& dependencies)
{
  std::vector<std::set<std::uint32_t>> all(dependencies.GetNumberOfMerges());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (const auto earlier : dependencies.Get(i))
    {
      all[i].insert(earlier);
      all[i].insert(all[earlier].begin(), all[earlier].end());
    }
  }
  return all;
}

std::size_t Count(const MergeDependencies& dependencies)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < dependencies.GetNumberOfMerges(); ++i)
  {
    count += dependencies.Get(i).size();
  }
  return count;
}

TEST(DependencyCodec, StreamGivesThemBackButForThoseThatFollow)
{
  for (const auto& mesh : { MakeCubes(7, 0.2), MakeCubes(3, 0), MakeCubes(1, 0) })
  {
    const auto tree = BuildTree(mesh);
    const MergeDependencies dependencies(tree, GetTets(mesh));
    const auto back = DecodeDependencies(EncodeDependencies(tree, dependencies), tree);
    EXPECT_EQ(GetAll(back), GetAll(dependencies));
    EXPECT_LE(Count(back), Count(dependencies));
    if (mesh.GetTets() > 1000)
    {
      EXPECT_LT(Count(back), 2 * Count(dependencies) / 3);
    }
  }
}

TEST(DependencyCodec, AnyDependenciesComeBack)
{
  for (const std::uint32_t points : { 0u, 1u, 2u, 3u, 10u, 300u, 2000u })
  {
    const auto tree = MakeWildTree(points, points);
    std::mt19937 random(points);
    MergeDependencies dependencies;
    for (std::uint32_t i = 0; i < tree.GetMerges().size(); ++i)
    {
      std::set<std::uint32_t> earlier;
      for (auto n = i > 0 ? random() % 12 : 0; n > 0; --n)
      {
        earlier.insert(static_cast<std::uint32_t>(random() % i));
      }
      dependencies.Add(std::vector<std::uint32_t>(earlier.begin(), earlier.end()));
    }
    const auto stream = EncodeDependencies(tree, dependencies);
    EXPECT_EQ(GetAll(DecodeDependencies(stream, tree)), GetAll(dependencies)) << points;
  }
}

TEST(DependencyCodec, TooManyHaveNoStream)
{
  const auto tree = MakeWildTree(400, 1);
  MergeDependencies dependencies;
  std::vector<std::uint32_t> first(200);
  std::iota(first.begin(), first.end(), 0u);
  for (std::uint32_t i = 0; i < tree.GetMerges().size(); ++i)
  {
    dependencies.Add(i < 200 ? std::vector<std::uint32_t>{} : first);
  }
  EXPECT_TRUE(EncodeDependencies(tree, dependencies).empty());
}

TEST(DependencyCodec, DamagedStreamsAreRefusedOrGiveEarlierMerges)
{
  const auto mesh = MakeCubes(5, 0.2);
  const auto tree = BuildTree(mesh);
  const auto good = EncodeDependencies(tree, MergeDependencies(tree, GetTets(mesh)));
  std::mt19937 random(3);
  std::size_t refused = 0;
  for (int i = 0; i < 3000; ++i)
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
      const auto other = DecodeDependencies(bad, tree);
      ASSERT_EQ(other.GetNumberOfMerges(), tree.GetMerges().size());
      for (std::size_t k = 0; k < other.GetNumberOfMerges(); ++k)
      {
        const auto earlier = other.Get(k);
        ASSERT_TRUE(std::is_sorted(earlier.begin(), earlier.end()));
        ASSERT_TRUE(std::all_of(earlier.begin(), earlier.end(), [=](auto n) { return n < k; }));
      }
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Corrupt);
      ++refused;
    }
  }
  EXPECT_GT(refused, 1500u);
}
}
}
