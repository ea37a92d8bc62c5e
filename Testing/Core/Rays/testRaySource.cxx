// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Where the blocks of an image come from: what a mesh in memory, a file or a cache hands out is
// what was put in, and what is passed over cannot be seen.

#include "gatunChunkCache.h"
#include "gatunFileRaySource.h"
#include "gatunFileReader.h"
#include "gatunFileWriter.h"
#include "gatunMemoryRaySource.h"
#include "gatunRayBlockCache.h"
#include "gatunRayImages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace gatun::test
{
namespace
{
Image DrawSource(RaySource& source, const Viewer& viewer)
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
TEST(RayCaster, BlocksThatPlanesCutAwayAreNeverAskedFor)
{
  // Blocks are bars along x. A slab of them, and those in a corner.
  const auto mesh = ToReference(MakeCubes(8, 0.2));
  const std::vector<std::array<double, 4>> slab{ { 0, 0.1, 1, -3.3 }, { 0, 0.1, -1, 4.4 } };
  const std::vector<std::array<double, 4>> corner{ { 0, 0, 1, -5.2 }, { 0, 1, 0, -5.2 } };
  for (const auto& planes : { slab, corner })
  {
    for (const bool parallel : { false, true })
    {
      std::size_t asked = 0;
      std::size_t all = 0;
      for (const Viewer& viewer : MakeViewers(8, parallel))
      {
        Setting setting;
        setting.Planes = planes;
        CountingSource source(mesh, 24);
        RayLimits limits;
        const RayView view = viewer.GetView();
        for (const auto& plane : planes)
        {
          ClipByPlane(view, plane, limits);
        }
        RayCaster caster(
          view, RayTable(RayMode::Composite, Ramp, { 0, 1 }, viewer.SampleDistance, 1), limits);
        caster.Draw(source);
        Image image{ std::vector<float>(4u * viewer.Width * viewer.Height), {} };
        caster.Finish(image.Colors.data());
        EXPECT_LE(GetLargestDifference(Render(mesh, viewer, setting), image), 2.0f / 255);
        asked += source.Asked;
        all += source.GetNumberOfBlocks();
      }
      EXPECT_LT(asked, all / 2);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, ABlockThatReachesBehindTheEyeIsNotPassedOver)
{
  // A bar from one side in front of the eye, outside of the image, to the other side behind it.
  auto mesh = ToReference(MakeCubes(3, 0));
  for (auto& point : mesh.Points)
  {
    point = { 10 * point[0] / 3 - 4.5, point[1] / 3 - 0.5, point[2] / 3 - 1.7 };
  }
  const double angle = std::acos(-1) / 6;
  Viewer viewer;
  viewer.Width = viewer.Height = 80;
  viewer.Frustum.Left = viewer.Frustum.Bottom = -0.5;
  viewer.Frustum.Right = viewer.Frustum.Top = 0.5;
  viewer.Forward = { -std::sin(angle), 0, -std::cos(angle) };
  viewer.Right = { std::cos(angle), 0, -std::sin(angle) };
  for (int turn = 0; turn < 4; ++turn)
  {
    SCOPED_TRACE(turn);
    // Towards each border of the image once.
    viewer.Up = std::exchange(viewer.Right, -1 * viewer.Up);
    CountingSource source(mesh, mesh.Tets.size());
    const auto view = viewer.GetView();
    const auto& box = source.GetBounds(0);
    int behind = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const auto get = [&](unsigned axis)
      { return (corner >> axis & 1) != 0 ? box[axis].Max : box[axis].Min; };
      const auto p = view.Transform({ get(0), get(1), get(2) });
      const auto isIn = [&](double x) { return x >= -1 && x <= 81; };
      behind += p[2] < 0 ? 1 : 0;
      EXPECT_FALSE(p[2] > 0 && isIn(p[0] / p[2]) && isIn(p[1] / p[2]));
    }
    EXPECT_EQ(behind, 4);
    const auto expected = Render(mesh, viewer, {});
    EXPECT_GT(*std::max_element(expected.Colors.begin(), expected.Colors.end()), 0.05f);
    EXPECT_LE(GetLargestDifference(expected, DrawSource(source, viewer)), 1.0f / 255);
    EXPECT_EQ(source.Asked, 1u);
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
TEST(RayCaster, RangesOfChunksAreThoseOfWhatIsDrawn)
{
  // Tuples (v, -2 v), and one component that is negative, or either, or positive.
  const auto cubes = MakeCubes(5, 0.1);
  const auto mesh = ToReference(cubes);
  std::vector<float> tuples;
  std::vector<float> singles;
  for (const Vec& p : mesh.Points)
  {
    const auto value = static_cast<float>(p[0] - 2.5);
    tuples.insert(tuples.end(), { value, -2 * value });
    singles.push_back(value);
  }
  std::vector<ArrayDescription> arrays(2);
  arrays[0].Name = "tuples";
  arrays[0].Components = 2;
  arrays[1].Name = "singles";
  const std::string path = std::string(GATUN_TEST_TEMP) + "/drawn_ranges.gtn";
  WriterOptions options;
  options.ChunkSize = 64;
  FileWriter writer(path, cubes.GetInput(), arrays, options);
  const std::array<const void*, 2> values{ tuples.data(), singles.data() };
  writer.WriteStep(values, {}, false, 0);
  writer.Finish();
  const auto file = std::make_shared<const FileReader>(path);
  for (const RayValues& drawn : { RayValues{ 0, 0, 0 }, RayValues{ 0, 1, 0 }, RayValues{ 0, -1, 0 },
         RayValues{ 1, 0, 0 }, RayValues{ 1, -1, 0 } })
  {
    SCOPED_TRACE(testing::Message() << file->GetArrays()[drawn.Array].Name << drawn.Component);
    FileRaySource source(file, drawn, 1 << 20);
    ASSERT_GT(source.GetNumberOfBlocks(), 5u);
    Range whole;
    for (std::size_t i = 0; i < source.GetNumberOfBlocks(); ++i)
    {
      const auto block = source.GetBlocks({ &i, 1 }, {}).front();
      const auto [low, high] = std::minmax_element(block->Points.begin(), block->Points.end(),
        [](const RayPoint& a, const RayPoint& b) { return a.Value < b.Value; });
      const Range range = source.GetRange(i);
      EXPECT_EQ(range.Max, high->Value);
      // The lengths of one component are kept nowhere: where there are both signs, they may be 0.
      const bool isBound = range.Min == 0 && drawn.Array == 1 && drawn.Component < 0;
      EXPECT_TRUE(isBound ? low->Value >= 0 : low->Value == range.Min);
      whole.Min = std::min(whole.Min, range.Min);
      whole.Max = std::max(whole.Max, range.Max);
    }
    const Range all = GetDrawnRange(file->GetRanges(drawn.Array, 0), drawn.Component);
    EXPECT_EQ(all.Min, whole.Min);
    EXPECT_EQ(all.Max, whole.Max);
  }
  const Range none = GetDrawnRange({ Range{} }, -1); // of nothing but NaN
  EXPECT_FALSE(none.Min <= none.Max);
}

//------------------------------------------------------------------------------
TEST(RayCaster, CacheKeepsTheBlocksThatWereUsedLastWithinItsBudget)
{
  const auto blocks = MakeBlocks(ToReference(MakeCubes(4, 0.1)), 48);
  RayBlockCache one(std::uint64_t{ 1 } << 30);
  one.Add(0, blocks[0]);
  const auto size = one.GetStatistics().Bytes;
  EXPECT_GE(size, blocks[0]->GetMemorySize());
  RayBlockCache cache(3 * size + size / 2);
  for (std::size_t i = 0; i < 3; ++i)
  {
    cache.Add(i, blocks[0]);
  }
  EXPECT_EQ(cache.GetStatistics().Bytes, 3 * size);
  EXPECT_NE(cache.Find(0), nullptr); // now 1 was not used for longest
  cache.Add(7, blocks[0]);
  EXPECT_EQ(cache.GetStatistics().Bytes, 3 * size);
  EXPECT_EQ(cache.Find(1), nullptr);
  for (const std::size_t kept : { 0, 2, 7 })
  {
    EXPECT_EQ(cache.Find(kept), blocks[0]);
  }
  RayBlockCache none(size - 1);
  none.Add(0, blocks[0]);
  EXPECT_EQ(none.GetStatistics().Bytes, 0u);
  EXPECT_EQ(none.Find(0), nullptr);
}

//------------------------------------------------------------------------------
TEST(RayCaster, SourcesOfAFileShareItsCacheAndOneBudget)
{
  const auto cubes = MakeCubes(6, 0.1);
  std::vector<ArrayDescription> arrays(2);
  arrays[0].Name = "first";
  arrays[1].Name = "second";
  const std::string path = std::string(GATUN_TEST_TEMP) + "/shared_cache.gtn";
  WriterOptions options;
  options.ChunkSize = 100;
  FileWriter writer(path, cubes.GetInput(), arrays, options);
  std::vector<float> values(cubes.GetPoints());
  std::iota(values.begin(), values.end(), 0.0f);
  const std::array<const void*, 2> both{ values.data(), values.data() };
  writer.WriteStep(both, {}, false, 0);
  writer.Finish();
  const auto file = std::make_shared<const FileReader>(path);
  const auto chunks = file->GetChunks().size();
  FileRaySource alone(file, {}, 0);
  std::vector<std::size_t> all(chunks);
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  const auto expected = alone.GetBlocks(all, {});
  for (const std::uint64_t bytes : { 0, 50000, 100000000 })
  {
    const auto budget = std::make_shared<CacheBudget>(bytes);
    const auto parts = std::make_shared<ChunkCache>(file, budget);
    FileRaySource first(parts, { 0, 0, 0 });
    FileRaySource second(parts, { 1, 0, 0 });
    for (int round = 0; round < 2; ++round)
    {
      for (auto* const source : { &first, &second })
      {
        const auto blocks = source->GetBlocks(all, {});
        for (const auto i : all)
        {
          EXPECT_EQ(blocks[i]->Tets, expected[i]->Tets);
        }
      }
    }
    EXPECT_LE(budget->GetStatistics().PeakBytes, bytes);
    const bool isEnough = bytes > 50000;
    EXPECT_EQ(budget->GetStatistics().Entries > 2 * chunks, isEnough);
    EXPECT_EQ(parts->GetStatistics().MeshesDecoded == chunks, isEnough) << "by the two together";
  }
}
}
}
