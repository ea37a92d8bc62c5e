// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The partition of a mesh against one that sorts all centroids and counts the users of all points.

#include "gatunPartition.h"

#include "gatunBisection.h"
#include "gatunLocalIds.h"
#include "gatunParallel.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Four times the centroid, with NaN before all numbers. */
float GetPlace(const TestMesh& mesh, std::uint32_t tet, std::size_t axis)
{
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    sum += mesh.Coordinates[3 * static_cast<std::size_t>(mesh.Ids[4 * tet + i]) + axis];
  }
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(sum != sum ? -largest : std::clamp(sum, -largest, largest));
}

/** Sorts and halves. */
void Halve(const TestMesh& mesh, std::vector<std::uint32_t> tets, std::size_t most,
  std::vector<std::vector<std::uint32_t>>& parts)
{
  if (tets.size() <= most)
  {
    std::sort(tets.begin(), tets.end());
    parts.push_back(std::move(tets));
    return;
  }
  std::size_t longest = 0;
  std::array<double, 3> length{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = std::minmax_element(tets.begin(), tets.end(),
      [&](auto l, auto r) { return GetPlace(mesh, l, axis) < GetPlace(mesh, r, axis); });
    length[axis] = double{ GetPlace(mesh, *high, axis) } - double{ GetPlace(mesh, *low, axis) };
    longest = length[axis] > length[longest] ? axis : longest;
  }
  std::sort(tets.begin(), tets.end(),
    [&](auto l, auto r)
    {
      const auto left = GetPlace(mesh, l, longest);
      const auto right = GetPlace(mesh, r, longest);
      return left < right || (left == right && l < r);
    });
  const auto count = (tets.size() + most - 1) / most;
  const auto middle = tets.begin() + static_cast<std::ptrdiff_t>(tets.size() * (count / 2) / count);
  Halve(mesh, { tets.begin(), middle }, most, parts);
  Halve(mesh, { middle, tets.end() }, most, parts);
}

void ExpectBisected(const TestMesh& mesh, std::uint32_t most)
{
  std::vector<std::uint32_t> all(mesh.GetTets());
  std::iota(all.begin(), all.end(), 0u);
  std::vector<std::vector<std::uint32_t>> right;
  Halve(mesh, all, most, right);
  for (const int threads : { 1, 3 })
  {
    WithNumberOfThreads(threads,
      [&]
      {
        auto tets = all;
        const std::vector<std::size_t> whole{ 0, tets.size() };
        const auto starts =
          Bisect(MeshAccess(mesh.GetInput()), tets, whole, std::array{ most }, {});
        ASSERT_EQ(starts.size(), right.size() + 1);
        for (std::size_t i = 0; i < right.size(); ++i)
        {
          EXPECT_TRUE(std::equal(right[i].begin(), right[i].end(),
            tets.begin() + static_cast<std::ptrdiff_t>(starts[i]),
            tets.begin() + static_cast<std::ptrdiff_t>(starts[i + 1])))
            << "part " << i;
        }
      });
  }
}
}

TEST(Partition, BisectsAlongTheLongestAxis)
{
  ExpectBisected(MakeCubes(25, 0.3), 3000); // several tasks
  ExpectBisected(MakeCubes(12, 0), 64);     // many equal centroids
  ExpectBisected(MakeSoup(300, 5000), 100);
}

TEST(Partition, BisectsOddCoordinates)
{
  auto mesh = MakeCubes(12, 0.2);
  const double infinity = std::numeric_limits<double>::infinity();
  std::size_t at = 0;
  for (const double odd :
    { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300, -1e300, -0.0 })
  {
    for (int i = 0; i < 20; ++i)
    {
      mesh.Coordinates[at += 53] = odd;
    }
  }
  ExpectBisected(mesh, 100);
  std::fill(mesh.Coordinates.begin(), mesh.Coordinates.end(), -0.0);
  ExpectBisected(mesh, 100);
  for (std::size_t i = 0; i < mesh.Coordinates.size(); ++i)
  {
    mesh.Coordinates[i] = static_cast<double>(i % 7) * 1e-45; // denormal lengths
  }
  ExpectBisected(mesh, 100);
}

TEST(Partition, FindsOwnSharedAndUnusedPoints)
{
  for (auto mesh : { MakeCubes(10, 0.3), MakeSoup(3000, 2000) })
  {
    mesh.Coordinates.resize(mesh.Coordinates.size() + 30, 0.5); // unused
    const auto parts = MakePartition(MeshAccess(mesh.GetInput()), { 100 }, {});
    std::vector<std::set<std::uint32_t>> users(mesh.GetPoints());
    for (std::uint32_t c = 0; c < parts.GetChunkCount(); ++c)
    {
      for (auto t = parts.ChunkStart[c]; t < parts.ChunkStart[c + 1]; ++t)
      {
        for (std::size_t i = 0; i < 4; ++i)
        {
          users[static_cast<std::size_t>(mesh.Ids[4 * parts.Cells[t] + i])].insert(c);
        }
      }
    }
    std::vector<std::vector<std::uint32_t>> own(parts.GetChunkCount());
    std::map<ChunkGroup, std::set<std::uint32_t>> shared;
    std::vector<std::uint32_t> unused;
    for (std::uint32_t p = 0; p < users.size(); ++p)
    {
      if (users[p].empty())
      {
        unused.push_back(p);
      }
      else if (users[p].size() == 1)
      {
        own[*users[p].begin()].push_back(p);
      }
      else
      {
        shared[{ users[p].begin(), users[p].end() }].insert(p);
      }
    }
    EXPECT_EQ(parts.OwnPoints, own);
    EXPECT_EQ(parts.UnusedPoints, unused);
    ASSERT_EQ(parts.SharedPoints.size(), shared.size());
    const auto box = FindBox(MeshAccess(mesh.GetInput()));
    for (const auto& [chunks, points] : parts.SharedPoints)
    {
      const std::set<std::uint32_t> found(points.begin(), points.end());
      EXPECT_EQ(found, shared[chunks]);
      EXPECT_EQ(found.size(), points.size());
      EXPECT_TRUE(std::is_sorted(points.begin(), points.end(),
        [&](auto l, auto r)
        {
          const MeshAccess access(mesh.GetInput());
          return FindMortonCode(access, box, l) < FindMortonCode(access, box, r);
        }));
    }
  }
}

TEST(SharedGroups, PutsSmallGroupsOfAChunkIntoOneBlock)
{
  SharedGroups groups;
  groups.Add({ 0, 1 }, 5);
  groups.Add({ 0, 1, 2 }, 300);
  groups.Add({ 0, 2 }, 255);
  groups.Add({ 1, 2 }, 4);
  groups.Add({ 1, 3 }, 4);
  groups.Add({ 1, 3 }, 255);
  groups.Add({ 1, 2 }, -4);
  const auto blocks = groups.MakeBlocks();
  ASSERT_EQ(blocks.size(), 3u);
  EXPECT_EQ(blocks[0].Points, 300u);
  EXPECT_EQ(blocks[0].Groups[0].Chunks, (ChunkGroup{ 0, 1, 2 }));
  EXPECT_EQ(blocks[1].Points, 260u);
  ASSERT_EQ(blocks[1].Groups.size(), 2u);
  EXPECT_EQ(blocks[1].Groups[0].Chunks, (ChunkGroup{ 0, 1 }));
  EXPECT_EQ(blocks[1].Groups[1].Points, 255u);
  EXPECT_EQ(blocks[2].Points, 259u);
  EXPECT_EQ(blocks[2].Groups[0].Chunks, (ChunkGroup{ 1, 3 }));
}

TEST(LocalIds, NumbersPointsAsTheyCome)
{
  LocalIds ids(1); // grows
  std::vector<std::uint32_t> points;
  std::mt19937 random(1);
  for (int i = 0; i < 4000; ++i)
  {
    const auto point = static_cast<std::uint32_t>(random() % 500) << (i % 20);
    const auto number = ids.Add(point);
    const auto known = std::find(points.begin(), points.end(), point) - points.begin();
    ASSERT_EQ(number, static_cast<std::uint32_t>(known));
    if (number == points.size())
    {
      points.push_back(point);
    }
    ASSERT_EQ(ids[point], number);
  }
  EXPECT_EQ(ids.GetPoints(), points);
}

namespace
{
/** Counts the chunks with tetrahedra and other cells of a mesh of 24,000 tetrahedra to which faces
 * of some of them are added: those of the first tetrahedra, or of one in each step. */
std::size_t CountMixedChunks(std::int64_t faces, std::int64_t step)
{
  auto mesh = MakeCubes(16, 0.3);
  const auto tets = static_cast<std::int64_t>(mesh.GetTets());
  std::vector<std::uint8_t> types(mesh.GetTets(), TetraType);
  std::vector<std::int64_t> offsets;
  for (std::int64_t t = 0; t <= tets; ++t)
  {
    offsets.push_back(4 * t);
  }
  for (std::int64_t f = 0; f < faces; ++f)
  {
    for (std::int64_t i = 0; i < 3; ++i)
    {
      mesh.Ids.push_back(mesh.Ids[static_cast<std::size_t>(4 * (f * step) + i)]);
    }
    types.push_back(5);
    offsets.push_back(offsets.back() + 3);
  }
  auto input = mesh.GetInput();
  input.Cells = types.size();
  input.Connectivity = mesh.Ids.data();
  input.Types = types.data();
  input.Offsets = offsets.data();
  const auto parts = MakePartition(MeshAccess(input), { 5000 }, {});
  std::set<std::uint32_t> seen;
  std::size_t mixed = 0;
  for (std::size_t c = 0; c < parts.GetChunkCount(); ++c)
  {
    std::set<bool> kinds;
    for (auto i = parts.ChunkStart[c]; i < parts.ChunkStart[c + 1]; ++i)
    {
      kinds.insert(types[parts.Cells[i]] == TetraType);
      seen.insert(parts.Cells[i]);
    }
    EXPECT_TRUE(
      std::is_sorted(parts.Cells.begin() + static_cast<std::ptrdiff_t>(parts.ChunkStart[c]),
        parts.Cells.begin() + static_cast<std::ptrdiff_t>(parts.ChunkStart[c + 1])));
    mixed += kinds.size() == 2;
  }
  EXPECT_EQ(seen.size(), types.size());
  return mixed;
}
}

TEST(Partition, LimitsThePointsOfChunks)
{
  constexpr std::uint32_t most = 300;
  for (auto mesh : { MakeCubes(10, 0.3), MakeSoup(3000, 2000) })
  {
    // Polygons, which have one or two tetrahedra's points; the last one has too many.
    std::vector<std::int64_t> offsets{ 0 };
    while (offsets.back() + 500 < static_cast<std::int64_t>(mesh.Ids.size()))
    {
      offsets.push_back(offsets.back() + (offsets.size() % 3 == 0 ? 8 : 4));
    }
    offsets.push_back(static_cast<std::int64_t>(mesh.Ids.size()));
    const std::vector<std::uint8_t> types(offsets.size() - 1, 7);
    auto input = mesh.GetInput();
    input.Cells = types.size();
    input.Types = types.data();
    input.Offsets = offsets.data();
    for (const std::uint32_t cells : { 70u, 1000000u })
    {
      const auto parts = MakePartition(MeshAccess(input), { cells, most }, {});
      std::vector<char> isThere(types.size(), 0);
      for (std::size_t c = 0; c < parts.GetChunkCount(); ++c)
      {
        std::set<std::int64_t> points;
        for (auto i = parts.ChunkStart[c]; i < parts.ChunkStart[c + 1]; ++i)
        {
          EXPECT_EQ(isThere[parts.Cells[i]]++, 0);
          const auto cell = offsets.begin() + parts.Cells[i];
          points.insert(mesh.Ids.begin() + cell[0], mesh.Ids.begin() + cell[1]);
        }
        const auto size = parts.ChunkStart[c + 1] - parts.ChunkStart[c];
        EXPECT_LE(size, cells);
        EXPECT_TRUE(points.size() <= most || size == 1) << points.size();
      }
      EXPECT_EQ(
        std::count(isThere.begin(), isThere.end(), 1), static_cast<std::ptrdiff_t>(types.size()));
      EXPECT_LT(parts.GetChunkCount(), types.size() / 8);
    }
  }
}

TEST(Partition, ChunksAreLargerInLargerMeshes)
{
  EXPECT_EQ(GetDefaultChunkSize(0, false), 65536u);
  EXPECT_EQ(GetDefaultChunkSize(1'000'000, false), 65536u);
  EXPECT_EQ(GetDefaultChunkSize(1'000'001, false), 131072u);
  EXPECT_EQ(GetDefaultChunkSize(10'000'000, false), 131072u);
  EXPECT_EQ(GetDefaultChunkSize(10'000'001, false), 262144u);
  EXPECT_EQ(GetDefaultChunkSize(1'000'000, true), 16384u);
  EXPECT_EQ(GetDefaultChunkSize(10'000'001, true), 65536u);
}

TEST(Partition, SeparatesTetrahedraWhereTheyShareFewPointsWithOtherCells)
{
  EXPECT_EQ(CountMixedChunks(300, 1), 0u);
  EXPECT_EQ(CountMixedChunks(60, 300), 0u);
  EXPECT_GT(CountMixedChunks(4000, 6), 3u);
}
