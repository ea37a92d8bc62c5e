// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Where the blocks of a picture come from: what a mesh in memory, a file or a cache hands out is
// what was put in, and what is passed over cannot be seen.

#include "gatunRayPictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace gatun::test
{
namespace
{
Picture DrawSource(RaySource& source, const Viewer& viewer)
{
  return RenderSource(source, viewer, Ramp, 0);
}

//------------------------------------------------------------------------------
TEST(RayCaster, NoBlockThatIsSeenIsPassedOver)
{
  const auto mesh = ToReference(MakeCubes(6, 0.2));
  for (const bool parallel : { false, true })
  {
    // From without, from within, and very near.
    auto viewers = MakeViewers(6, parallel);
    for (int i = 0; i < 4; ++i)
    {
      const auto& v = viewers[static_cast<std::size_t>(i)];
      viewers.push_back(Viewer::LookAt(v.Eye, { 1.0 + i, 5.0 - i, 2.0 }, parallel, 0.7));
    }
    for (auto& viewer : viewers)
    {
      viewer.Frustum.Near = 0.8;
      viewer.Frustum.Far = 19;
      CountingSource source(mesh, 24);
      EXPECT_LE(
        GetLargestDifference(Render(mesh, viewer, {}), DrawSource(source, viewer)), 2.0f / 255);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, MeshesInMemoryAreDrawnInBlocksOfAnySizeWithAnyBudget)
{
  const auto cubes = MakeCubes(5, 0.2);
  auto mesh = ToReference(cubes);
  const auto viewer = MakeViewers(5, false)[6];
  std::vector<unsigned char> hidden(mesh.Tets.size(), 0);
  for (std::size_t i = 0; i < hidden.size(); i += 3)
  {
    hidden[i] = static_cast<unsigned char>(1 + i % 200);
  }
  const auto whole = Render(mesh, viewer, {});
  auto rest = mesh;
  rest.Tets.clear();
  for (std::size_t i = 0; i < hidden.size(); ++i)
  {
    if (hidden[i] == 0)
    {
      rest.Tets.push_back(mesh.Tets[i]);
    }
  }
  const auto seen = Render(rest, viewer, {});
  EXPECT_GT(GetLargestDifference(whole, seen), 0.02f);
  const RayValuesInput values{ Association::Point, ScalarType::Float64, 1, 0, mesh.Values.data() };
  for (const std::uint32_t blockTets : { 1, 50, 100000 })
  {
    for (const std::uint64_t budget : { 0, 20000, 1 << 30 })
    {
      MemoryRaySource all(cubes.GetInput(), values, nullptr, budget, blockTets);
      MemoryRaySource some(cubes.GetInput(), values, hidden.data(), budget, blockTets);
      for (int again = 0; again < 3; ++again)
      {
        EXPECT_LE(GetLargestDifference(whole, DrawSource(all, viewer)), 1.0f / 255);
        EXPECT_LE(GetLargestDifference(seen, DrawSource(some, viewer)), 1.0f / 255);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, ComponentsAndValuesOfCellsAreThoseOfTheMesh)
{
  const auto cubes = MakeCubes(4, 0.1);
  const auto mesh = ToReference(cubes);
  const auto viewer = MakeViewers(4, true)[4];
  const RayTable table(RayMode::Composite, Ramp, { 0, 1 }, 0.1, 1);

  // Tuples (0.6 v, 0.8 v, another), of which the length of the first two is v.
  std::vector<float> tuples;
  for (const double value : mesh.Values)
  {
    tuples.insert(
      tuples.end(), { static_cast<float>(0.6 * value), static_cast<float>(0.8 * value) });
  }
  const auto draw = [&](const RayValuesInput& values, std::uint32_t blockTets)
  {
    MemoryRaySource source(cubes.GetInput(), values, nullptr, 1 << 30, blockTets);
    return DrawSource(source, viewer);
  };
  const auto expect = [&](auto&& getValue)
  {
    auto changed = mesh;
    std::transform(changed.Values.begin(), changed.Values.end(), changed.Values.begin(), getValue);
    return Render(changed, viewer, {});
  };
  RayValuesInput values{ Association::Point, ScalarType::Float32, 2, -1, tuples.data() };
  EXPECT_LE(GetLargestDifference(expect([](double v) { return v; }), draw(values, 70)), 1.0f / 255);
  values.Component = 1;
  EXPECT_LE(
    GetLargestDifference(expect([](double v) { return 0.8 * v; }), draw(values, 70)), 1.0f / 255);

  // Values of cells: as a mesh in which each tetrahedron has points of its own.
  std::vector<std::uint8_t> ofCells;
  ReferenceMesh apart;
  for (const auto& tet : mesh.Tets)
  {
    const auto value = static_cast<std::uint8_t>(ofCells.size() * 37 % 11 < 5 ? 1 : 0);
    ofCells.push_back(value);
    auto& own = apart.Tets.emplace_back();
    for (std::size_t c = 0; c < 4; ++c)
    {
      own[c] = static_cast<std::uint32_t>(apart.Points.size());
      apart.Points.push_back(mesh.Points[tet[c]]);
      apart.Values.push_back(value);
    }
  }
  const RayValuesInput cells{ Association::Cell, ScalarType::UInt8, 1, 0, ofCells.data() };
  for (const std::uint32_t blockTets : { 1, 70, 100000 })
  {
    EXPECT_LE(GetLargestDifference(Render(apart, viewer, {}), draw(cells, blockTets)), 1.0f / 255);
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, CacheKeepsTheBlocksThatWereUsedLastWithinItsBudget)
{
  const auto blocks = MakeBlocks(ToReference(MakeCubes(4, 0.1)), 48);
  const auto size = blocks[0]->GetMemorySize();
  RayBlockCache cache(3 * size + size / 2);
  for (std::size_t i = 0; i < 3; ++i)
  {
    cache.Add(i, blocks[0]);
  }
  EXPECT_EQ(cache.GetBytes(), 3 * size);
  EXPECT_NE(cache.Find(0), nullptr); // now 1 was not used for longest
  cache.Add(7, blocks[0]);
  EXPECT_EQ(cache.GetBytes(), 3 * size);
  EXPECT_EQ(cache.Find(1), nullptr);
  for (const std::size_t kept : { 0, 2, 7 })
  {
    EXPECT_EQ(cache.Find(kept), blocks[0]);
  }
  RayBlockCache none(size - 1);
  none.Add(0, blocks[0]);
  EXPECT_EQ(none.GetBytes(), 0u);
  EXPECT_EQ(none.Find(0), nullptr);
}
}
}
