// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of surfaces with valid checksums and invalid merge trees, and damaged files.

#include "gatunHostileTrees.h"
#include "gatunSurfaceTrees.h"

#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Several chunks with shared points, steps, and two base meshes. */
const TreeImage& GetGoodSurface()
{
  static const TreeImage image = []
  {
    const auto path = GetPath("surface_sample.gtn");
    WriterOptions options;
    options.ChunkSize = 64;
    options.Keep = KeepAll;
    const auto sample = MakeSurfaceSample(14, 8, Steps);
    const auto merges = sample.Tree.GetMerges().size();
    WriteTreeSample(path, sample, options,
      { static_cast<std::uint32_t>(sample.Tree.CountWholeMerges(merges / 3)),
        static_cast<std::uint32_t>(sample.Tree.CountWholeMerges(merges / 2)) });
    return TreeImage(path);
  }();
  return image;
}

void ExpectSurfaceRefused(const std::string& what, const std::function<void(TreeImage&)>& change)
{
  ExpectRefused(what, change, ErrorCode::Corrupt, GetGoodSurface());
}

/** A grid with a tree, as a base mesh would be. */
Bytes MakeGrid()
{
  const auto path = GetPath("grid_level.gtn");
  WriteTreeSample(path, MakeTreeSample(2, Steps), {});
  return ReadFile(path);
}

TEST(HostileSurfaceTrees, TheUnchangedFileIsRead)
{
  const auto path = PutFile("same_surface.gtn", GetGoodSurface().Build());
  EXPECT_NO_THROW(ReadTree(path));
  EXPECT_TRUE(VerifyFile(FileReader(path)));
  EXPECT_EQ(FileReader(path).GetLevels().size(), 2u);
}

TEST(HostileSurfaceTrees, ATreeMustBeThatOfTheSurface)
{
  const auto points = static_cast<std::uint32_t>(GetGoodSurface().Meta.Points);
  ExpectSurfaceRefused("there are more merges than points",
    [=](TreeImage& f)
    {
      f.Tree.Merges = points + 1;
      f.Tree.MergeCounts.back() = points + 1;
    });
  ExpectSurfaceRefused(
    "the merges have no stream", [](TreeImage& f) { f.Parts[0].Merges.clear(); });
  ExpectSurfaceRefused("the bounds of chunks after merges are not all there",
    [](TreeImage& f) { f.Tree.Boxes.resize(1); });
  ExpectSurfaceRefused("the ranges after merges of some time steps are missing",
    [](TreeImage& f) { f.TreeSteps.pop_back(); });
}

TEST(HostileSurfaceTrees, NothingBelongsToTheLastMerge)
{
  const auto points = static_cast<std::uint32_t>(GetGoodSurface().Meta.Points);
  const auto encode = [=](std::uint32_t merges)
  {
    // The last merge of the stream is bound to one that the table does not count.
    return [=](TreeImage& f)
    {
      f.SetMerges(
        MergeTree(points, { { 7, 8, 0 }, { 5, 6, 0 }, { 3, 4, 0 } }, { false, true, false }));
      f.Tree.Merges = merges;
      f.Tree.MergeCounts = { merges };
      for (auto& boxes : f.Tree.Boxes)
      {
        boxes.resize(1);
      }
      for (auto& step : f.TreeSteps)
      {
        for (auto& chunks : step.Ranges)
        {
          for (auto& ranges : chunks)
          {
            ranges.resize(1);
          }
        }
      }
    };
  };
  ExpectSurfaceRefused("there is no merge that belongs to the last one", encode(2));
  auto good = GetGoodSurface();
  encode(3)(good);
  const auto path = PutFile("bound.gtn", good.Build());
  EXPECT_NO_THROW(ReadTree(path));
  EXPECT_EQ(FileReader(path).GetMergeTree().CountWholeMerges(2), 1u);
}

TEST(HostileSurfaceTrees, ABaseMeshMustBeOneOfTheSurface)
{
  const auto refuse = [](const std::function<void(Bytes&)>& change)
  {
    auto image = GetGoodSurface();
    change(image.Levels[0]);
    const auto path = PutFile("changed_level.gtn", image.Build());
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path + ", base mesh 1",
      "it is not what is left of the mesh after its merges",
      [&] { FileReader(path).OpenLevel(0); });
    EXPECT_THROW(VerifyFile(FileReader(path)), Error);
  };
  refuse([](Bytes& level) { level = GetGoodSurface().Levels[1]; });
  refuse([](Bytes& level) { level = MakeGrid(); });
  // A surface without the mark of one is a grid of cells.
  refuse(
    [](Bytes& level)
    {
      TreeImage image(PutFile("level.gtn", level));
      for (auto& section : image.Rest)
      {
        section.Name = section.Name == SectionSurface ? MakeFourCC("ROOM") : section.Name;
      }
      level = image.Build();
    });
}

TEST(HostileSurfaceTrees, ABaseMeshMustNotOpenASeam)
{
  const auto sample = MakeSurfaceSample(14, 8, 1);
  const auto& bonds = sample.Tree.GetBonds();
  const auto open =
    static_cast<std::uint32_t>(std::find(bonds.begin(), bonds.end(), true) - bonds.begin() + 1);
  const auto path = GetPath("open.gtn");
  WriteTreeSample(path, sample, {}, { open });
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, "there is no merge that belongs to the last one",
    [&] { FileReader(path).GetMergeTree(); });
}

/** Merges of any points into any others, those of lines, quadrilaterals and strips, too. */
TEST(HostileSurfaceTrees, TreesThatDoNotFitTheSurfaceAreReadAllTheSame)
{
  auto image = GetGoodSurface();
  const auto points = static_cast<std::uint32_t>(image.Meta.Points);
  const auto used = points - static_cast<std::uint32_t>(image.Meta.UnusedPoints);
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> left(used);
    std::iota(left.begin(), left.end(), 0u);
    std::shuffle(left.begin(), left.end(), random);
    std::vector<Merge> merges;
    std::vector<bool> bonds;
    if (seed % 2 == 0)
    {
      merges.push_back({ points - 1, left[0], 0 }); // one of no cell
      bonds.push_back(true);
    }
    while (left.size() > 1 + seed % 3)
    {
      const auto point = left.back();
      left.pop_back();
      merges.push_back({ point, left[random() % left.size()], 0 });
      bonds.push_back(random() % 2 == 0);
    }
    bonds.back() = false;
    image.SetMerges(MergeTree(points, std::move(merges), std::move(bonds)));
    const auto path = PutFile("wild_surface.gtn", image.Build());
    EXPECT_NO_THROW(ReadTree(path));
  }
  // But not into one of no cell, which no chunk provides.
  image.SetMerges(MergeTree(points, { { 1, points - 1, 0 } }));
  const auto path = PutFile("wild_surface.gtn", image.Build());
  EXPECT_THROW(ReadTree(path), Error);
}

TEST(HostileSurfaceTrees, EveryFlippedBitIsFound)
{
  TreeSample sample;
  sample.Coordinates = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 1, 1, 0, 1, 0, 0, 2, 0, 0 };
  sample.Ids = { 0, 1, 2, 1, 3, 2, 4, 5, 6 };
  sample.Types = { 5, 5, 5 };
  sample.Offsets = { 0, 3, 6, 9 };
  sample.AddArray<float>("T", Association::Point, ScalarType::Float32, 1, 1,
    [](std::size_t i, std::size_t, std::size_t) { return i * i; });
  sample.Tree = MergeTree(7, { { 0, 2, 0.5f }, { 3, 1, 2 }, { 4, 5, 2 } }, { false, true, false });
  const auto path = GetPath("small_surface.gtn");
  WriteTreeSample(path, sample, {}, { 1 });
  EXPECT_NO_THROW(ReadTree(path));
  EXPECT_TRUE(VerifyFile(FileReader(path)));
  const auto good = ReadFile(path);
  ASSERT_LT(good.size(), 3000u);
  for (std::size_t at = 0; at < good.size(); ++at)
  {
    auto bytes = good;
    bytes[at] ^= static_cast<std::uint8_t>(1u << at % 8);
    const auto flipped = PutFile("flipped_surface.gtn", bytes);
    try
    {
      ReadTree(flipped);
    }
    catch (const Error& error)
    {
      EXPECT_EQ(std::string(error.what()).find(flipped), 0u) << error.what();
    }
    EXPECT_THROW(VerifyFile(FileReader(flipped)), Error) << at;
  }
  for (std::size_t size = 0; size < good.size(); ++size)
  {
    const auto cut = PutFile("short_surface.gtn", Bytes(good.data(), good.data() + size));
    EXPECT_THROW(FileReader{ cut }, Error) << size;
  }
}
}
