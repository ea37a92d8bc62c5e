// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files that are organized by layers: the layers, their contents, and that nothing else changes.

#include "gatunError.h"
#include "gatunFileReaderInternals.h"
#include "gatunHostile.h"
#include "gatunLayerPartition.h"
#include "gatunPieceDecoder.h"
#include "gatunTestFile.h"
#include "gatunTreeSample.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gatun::test
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr LayerSpacing AllSpacings[] = { LayerSpacing::Uniform, LayerSpacing::Normal,
  LayerSpacing::Histogram };

LayerRequest Ask(const void* values, std::uint32_t count,
  LayerSpacing spacing = LayerSpacing::Histogram, int component = 0)
{
  LayerRequest request;
  request.Component = component;
  request.Count = count;
  request.Spacing = spacing;
  request.Values = values;
  return request;
}

/** Writes a mesh with the arrays of Values and layers of "field". */
void WriteLayered(const std::string& path, const TestMesh& mesh, std::uint32_t count,
  LayerSpacing spacing, WriterOptions options, int steps = 1)
{
  const Values values(mesh);
  options.Layers = Ask(values.Field.data(), count, spacing);
  Write(path, mesh, options, steps);
}

/** A row of tetrahedra with one value at each point, as doubles. */
struct LayerRow
{
  explicit LayerRow(std::vector<double> values)
    : Numbers(std::move(values))
  {
    const auto points = static_cast<std::int64_t>(this->Numbers.size());
    for (std::int64_t p = 0; p < points; ++p)
    {
      const auto x = static_cast<double>(p);
      this->Mesh.Coordinates.insert(
        this->Mesh.Coordinates.end(), { x, std::sin(x), std::cos(2 * x) });
    }
    for (std::int64_t p = 0; p + 3 < points; ++p)
    {
      this->Mesh.Ids.insert(this->Mesh.Ids.end(), { p, p + 1, p + 2, p + 3 });
    }
    this->Description.Type = ScalarType::Float64;
  }

  std::vector<double> FindBounds(LayerSpacing spacing, std::uint32_t count) const
  {
    return FindLayerBounds(MeshAccess(this->Mesh.GetInput()),
      LayerValues(this->Description, Ask(this->Numbers.data(), count)), spacing, count);
  }

  /** A file of the row, and its layers. */
  Layers Write(const std::string& path, std::uint32_t count, LayerSpacing spacing) const
  {
    WriterOptions options;
    options.ChunkSize = 64;
    options.Layers = Ask(this->Numbers.data(), count, spacing);
    FileWriter writer(path, this->Mesh.GetInput(), { this->Description }, options);
    const void* values[] = { this->Numbers.data() };
    writer.WriteStep(values);
    writer.Finish();
    const FileReader file(path);
    EXPECT_TRUE(VerifyFile(file));
    return file.GetLayers();
  }

  TestMesh Mesh;
  std::vector<double> Numbers;
  ArrayDescription Description;
};

std::vector<double> Count(std::size_t n)
{
  std::vector<double> values(n);
  std::iota(values.begin(), values.end(), 0.0);
  return values;
}

TEST(Layers, UniformOnesAreAsWideAsEachOther)
{
  EXPECT_EQ(
    LayerRow(Count(101)).FindBounds(LayerSpacing::Uniform, 4), (std::vector<double>{ 25, 50, 75 }));
  EXPECT_TRUE(LayerRow(Count(101)).FindBounds(LayerSpacing::Uniform, 1).empty());
  // Neither their sum nor their difference is finite.
  EXPECT_EQ(LayerRow({ -1.5e308, 0, 0, 1.5e308 }).FindBounds(LayerSpacing::Uniform, 2),
    (std::vector<double>{ 0 }));
}

TEST(Layers, NormalOnesFollowMeanAndDeviation)
{
  const LayerRow row(Count(101));
  const double deviation = std::sqrt((101.0 * 101 - 1) / 12);
  const auto bounds = row.FindBounds(LayerSpacing::Normal, 4);
  ASSERT_EQ(bounds.size(), 3u);
  EXPECT_NEAR(bounds[0], 50 - 0.6744897501960817 * deviation, 1e-9);
  EXPECT_NEAR(bounds[1], 50, 1e-9);
  EXPECT_NEAR(bounds[2], 50 + 0.6744897501960817 * deviation, 1e-9);
  // The last ones would be beyond the values.
  EXPECT_LT(row.FindBounds(LayerSpacing::Normal, 1000).size(), 950u);
  // The mean of numbers whose sums are not finite.
  const auto middle = LayerRow({ -1.5e308, 0, 0, 1.5e308 }).FindBounds(LayerSpacing::Normal, 2);
  ASSERT_EQ(middle.size(), 1u);
  EXPECT_NEAR(middle[0], 0, 1e295);
}

TEST(Layers, ThoseByHistogramHoldAsManyTetrahedra)
{
  auto mesh = MakeCubes(12, 0.2);
  std::vector<float> cubes; // far from uniform
  for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
  {
    cubes.push_back(static_cast<float>(std::pow(mesh.Coordinates[3 * p], 3)));
  }
  const MeshAccess access(mesh.GetInput());
  const LayerValues values({}, Ask(cubes.data(), 8));
  Layers layers;
  layers.Bounds = FindLayerBounds(access, values, LayerSpacing::Histogram, 8);
  ASSERT_EQ(layers.GetCount(), 8u);
  std::vector<double> tets(8);
  for (std::size_t t = 0; t < mesh.GetTets(); ++t)
  {
    const auto range = values.GetRange(access, t);
    tets[layers.Find((range.Min + range.Max) / 2)] += 1;
  }
  for (const double count : tets)
  {
    // Six tetrahedra around a diagonal may have one value in the middle.
    EXPECT_NEAR(count, static_cast<double>(mesh.GetTets()) / 8, 6);
  }
}

TEST(Layers, NoneIsWithoutValues)
{
  for (const auto spacing : AllSpacings)
  {
    EXPECT_TRUE(LayerRow(std::vector<double>(20, 3.5)).FindBounds(spacing, 8).empty());
    EXPECT_TRUE(LayerRow(std::vector<double>(20, std::nan(""))).FindBounds(spacing, 8).empty());
    EXPECT_TRUE(LayerRow(std::vector<double>(20, Infinity)).FindBounds(spacing, 8).empty());
    EXPECT_TRUE(LayerRow(std::vector<double>{}).FindBounds(spacing, 8).empty());
  }
  // Two values, and tetrahedra of one of them, of the other, or both.
  std::vector<double> two(20, 1);
  std::fill(two.begin() + 10, two.end(), 2);
  const auto bounds = LayerRow(two).FindBounds(LayerSpacing::Histogram, 64);
  ASSERT_FALSE(bounds.empty());
  EXPECT_LE(bounds.size(), 2u);
  for (const double bound : bounds)
  {
    EXPECT_TRUE(bound > 1 && bound <= 2);
  }
}

TEST(Layers, PointsOfNoTetrahedronDoNotCount)
{
  const auto values = Count(101);
  LayerRow row(values);
  row.Numbers.push_back(1e6);
  row.Mesh.Coordinates.insert(row.Mesh.Coordinates.end(), { 0, 0, 0 });
  for (const auto spacing : AllSpacings)
  {
    EXPECT_EQ(row.FindBounds(spacing, 5), LayerRow(values).FindBounds(spacing, 5));
  }
}

TEST(Layers, ABoundIsTheFirstValueOfItsLayer)
{
  Layers layers;
  layers.Bounds = { -1, 0, 5 };
  EXPECT_EQ(layers.GetCount(), 4u);
  const std::pair<double, std::uint32_t> cases[] = { { -Infinity, 0 }, { -1.5, 0 }, { -1, 1 },
    { -0.0, 2 }, { 0, 2 }, { 4.9, 2 }, { 5, 3 }, { Infinity, 3 }, { std::nan(""), 0 } };
  for (const auto& [value, layer] : cases)
  {
    EXPECT_EQ(layers.Find(value), layer) << value;
  }
}

TEST(Layers, OneMeshIsReadWhicheverWayItIsOrganised)
{
  const auto mesh = MakeCubes(7, 0.3);
  const auto path = GetPath("layers.gtn");
  for (const auto spacing : AllSpacings)
  {
    for (const std::uint32_t count : { 0u, 1u, 5u, 4096u })
    {
      for (const std::uint8_t keep : { KeepNone, KeepAll })
      {
        WriterOptions options;
        options.ChunkSize = 200;
        options.Keep = keep;
        WriteLayered(path, mesh, count, spacing, options);
        const auto file = std::make_shared<FileReader>(path);
        PieceDecoder decoder(file);
        const Piece piece(decoder, AskForAll(*file));
        const Values values(mesh);
        EXPECT_EQ(GetCells(piece.Mesh, piece), GetCells(mesh, values));
        if (keep == KeepAll)
        {
          EXPECT_EQ(piece.Mesh.Coordinates, mesh.Coordinates);
          EXPECT_EQ(piece.Mesh.Ids, mesh.Ids);
          EXPECT_EQ(piece.Field, values.Field);
          EXPECT_EQ(piece.Material, values.Material);
        }
        EXPECT_TRUE(VerifyFile(*file));
      }
    }
  }
}

TEST(Layers, PiecesWithGhostsMakeTheWhole)
{
  const auto mesh = MakeCubes(7, 0.3);
  const auto path = GetPath("layers.gtn");
  WriterOptions options;
  options.ChunkSize = 200;
  WriteLayered(path, mesh, 5, LayerSpacing::Histogram, options);
  const auto file = std::make_shared<FileReader>(path);
  PieceDecoder decoder(file);
  std::multiset<CellContent> all;
  std::size_t owned = 0;
  for (std::uint32_t chunk = 0; chunk < file->GetChunks().size(); ++chunk)
  {
    auto request = AskForAll(*file);
    request.Chunks = { chunk };
    request.WithUnusedPoints = false;
    all.merge(GetCells(Piece(decoder, request).Mesh, Piece(decoder, request)));
    request.GhostLevels = 1;
    const Piece piece(decoder, request);
    owned +=
      static_cast<std::size_t>(std::count(piece.PointGhosts.begin(), piece.PointGhosts.end(), 0));
    // Whatever has a point in common with the chunk is there.
    std::set<std::int64_t> points;
    for (std::size_t t = 0; t < piece.Mesh.GetTets(); ++t)
    {
      for (std::size_t i = 4 * t; piece.CellGhosts[t] == 0 && i < 4 * t + 4; ++i)
      {
        points.insert(piece.PointIds[static_cast<std::size_t>(piece.Mesh.Ids[i])]);
      }
    }
    std::size_t around = 0;
    const Piece whole(decoder, AskForAll(*file));
    for (std::size_t t = 0; t < whole.Mesh.GetTets(); ++t)
    {
      around += std::any_of(&whole.Mesh.Ids[4 * t], &whole.Mesh.Ids[4 * t] + 4,
                  [&](std::int64_t p)
                  { return points.count(whole.PointIds[static_cast<std::size_t>(p)]) > 0; })
        ? 1
        : 0;
    }
    EXPECT_EQ(piece.Mesh.GetTets(), around);
  }
  EXPECT_EQ(all, GetCells(mesh, Values(mesh)));
  EXPECT_EQ(owned, mesh.GetPoints());
}

TEST(Layers, AValueIsInFewerChunks)
{
  const auto mesh = MakeCubes(16, 0.2);
  const auto countTets = [&](bool layered)
  {
    const auto path = GetPath("some.gtn");
    WriterOptions options;
    options.ChunkSize = 1024;
    if (layered)
    {
      WriteLayered(path, mesh, 8, LayerSpacing::Histogram, options);
    }
    else
    {
      Write(path, mesh, options);
    }
    const FileReader file(path);
    EXPECT_EQ(file.HasLayers(), layered);
    std::uint64_t tets = 0;
    for (const double value : { 2.0, 6.0, 8.0, 10.0, 14.0 })
    {
      for (std::size_t c = 0; c < file.GetChunks().size(); ++c)
      {
        const Range range = file.GetChunkRanges(0, 0, c)[0];
        tets += range.Min < value && value <= range.Max ? file.GetChunks()[c].Tets : 0;
      }
    }
    return static_cast<double>(tets);
  };
  EXPECT_LT(countTets(true), 0.75 * countTets(false));
}

TEST(Layers, NoChunkIsTinyHoweverManyLayersThereAre)
{
  const auto mesh = MakeCubes(14, 0.3);
  const auto path = GetPath("many.gtn");
  WriterOptions options;
  options.ChunkSize = 1600;
  for (const std::uint32_t count : { 20u, 200u, 4096u })
  {
    WriteLayered(path, mesh, count, LayerSpacing::Uniform, options);
    const FileReader file(path);
    EXPECT_GT(file.GetLayers().GetCount(), count / 2);
    for (const ChunkInfo& chunk : file.GetChunks())
    {
      EXPECT_GE(chunk.Tets, 100u) << count;
      EXPECT_LE(chunk.Tets, 1600u) << count;
    }
  }
}

TEST(Layers, TheFileTellsThem)
{
  const auto mesh = MakeCubes(8, 0.3);
  const auto path = GetPath("layers.gtn");
  const Values values(mesh);
  WriterOptions options;
  options.ChunkSize = 256;
  Write(path, mesh, options);
  EXPECT_FALSE(FileReader(path).HasLayers());
  EXPECT_TRUE(FileReader(path).GetLayers().Chunks.empty());

  // The length of the vector.
  options.Layers = Ask(values.Vector.data(), 6, LayerSpacing::Uniform, -1);
  options.Layers->Array = 1;
  Write(path, mesh, options);
  const FileReader file(path);
  ASSERT_TRUE(file.HasLayers());
  const Layers& layers = file.GetLayers();
  EXPECT_EQ(layers.Array, 1u);
  EXPECT_EQ(layers.Component, -1);
  EXPECT_EQ(layers.Spacing, LayerSpacing::Uniform);
  const Range all = file.GetRanges(1, 0)[3];
  ASSERT_EQ(layers.GetCount(), 6u);
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(layers.Bounds[i], all.Min + (all.Max - all.Min) * static_cast<double>(i + 1) / 6,
      1e-9 * all.Max);
  }
  ASSERT_EQ(layers.Chunks.size(), file.GetChunks().size());
  LayerSpan last;
  for (std::size_t c = 0; c < layers.Chunks.size(); ++c)
  {
    const Range range = file.GetChunkRanges(1, 0, c)[3];
    const LayerSpan expected{ layers.Find(range.Min), layers.Find(range.Max) };
    EXPECT_EQ(layers.Chunks[c], expected);
    EXPECT_GE(expected.First, last.First > 0 ? last.First - 1 : 0);
    last = expected;
  }
}

TEST(Layers, ThoseOfTheFirstStepAreForAll)
{
  const auto mesh = MakeCubes(7, 0.3);
  const auto path = GetPath("steps.gtn");
  WriterOptions options;
  options.ChunkSize = 256;
  WriteLayered(path, mesh, 6, LayerSpacing::Histogram, options, 4);
  const auto file = std::make_shared<FileReader>(path);
  EXPECT_TRUE(VerifyFile(*file));
  PieceDecoder decoder(file);
  for (std::size_t step = 0; step < 4; ++step)
  {
    auto request = AskForAll(*file);
    request.Step = step;
    const Piece piece(decoder, request);
    EXPECT_EQ(
      GetCells(piece.Mesh, piece), GetCells(mesh, Values(mesh, 0.25 * static_cast<double>(step))));
  }
}

TEST(Layers, WhatIsNoNumberIsInTheFirstAndInfinityAtTheEnds)
{
  auto values = Count(400);
  std::fill(values.begin(), values.begin() + 40, std::nan(""));
  values[100] = std::nan("");
  std::fill(values.begin() + 200, values.begin() + 240, Infinity);
  std::fill(values.begin() + 300, values.begin() + 340, -Infinity);
  for (const auto spacing : AllSpacings)
  {
    const auto layers = LayerRow(values).Write(GetPath("odd.gtn"), 4, spacing);
    ASSERT_EQ(layers.GetCount(), 4u);
    for (const double bound : layers.Bounds)
    {
      EXPECT_TRUE(bound > 40 && bound < 400) << bound;
    }
  }
  const LayerRow row(values);
  const MeshAccess mesh(row.Mesh.GetInput());
  const LayerValues numbers(row.Description, Ask(row.Numbers.data(), 4));
  Layers layers;
  layers.Bounds = { 100, 200, 300 };
  const auto find = [&](std::uint32_t tet)
  { return FindLayerSpan(mesh, numbers, layers, std::span(&tet, 1)); };
  EXPECT_EQ(find(5), (LayerSpan{ 0, 0 }));   // no number at all
  EXPECT_EQ(find(39), (LayerSpan{ 0, 0 }));  // from NaN to 42
  EXPECT_EQ(find(100), (LayerSpan{ 1, 1 })); // 101 to 103
  EXPECT_EQ(find(210), (LayerSpan{ 3, 3 }));
  EXPECT_EQ(find(238), (LayerSpan{ 2, 3 }));
  EXPECT_EQ(find(310), (LayerSpan{ 0, 0 }));
  EXPECT_EQ(find(338), (LayerSpan{ 0, 3 }));
  // All go somewhere.
  const auto buckets = SortByLayers(mesh, numbers, layers, 1);
  EXPECT_EQ(buckets.Cells.size(), 397u);
  EXPECT_EQ(std::set<std::uint32_t>(buckets.Cells.begin(), buckets.Cells.end()).size(), 397u);
}

TEST(Layers, MeshesOfOneValueOrOfNothingHaveOne)
{
  const auto path = GetPath("one.gtn");
  for (const auto spacing : AllSpacings)
  {
    EXPECT_EQ(LayerRow(std::vector<double>(300, -7)).Write(path, 9, spacing).GetCount(), 1u);
    EXPECT_EQ(
      LayerRow(std::vector<double>(300, std::nan(""))).Write(path, 9, spacing).GetCount(), 1u);
    EXPECT_EQ(LayerRow(std::vector<double>(2, 1)).Write(path, 9, spacing).GetCount(), 1u);
    EXPECT_EQ(LayerRow(std::vector<double>{}).Write(path, 9, spacing).Chunks.size(), 0u);
  }
}

TEST(Layers, LargerMeshesHaveMore)
{
  EXPECT_EQ(GetDefaultLayers(0), 4u);
  EXPECT_EQ(GetDefaultLayers(100'000), 6u); // of 16384 tetrahedra and more
  EXPECT_EQ(GetDefaultLayers(200'000), 10u);
  EXPECT_EQ(GetDefaultLayers(10'000'000), 10u);
  EXPECT_EQ(GetDefaultLayers(80'000'000), 20u);
  EXPECT_EQ(GetDefaultLayers(~std::uint64_t{ 0 }), MaxLayers);
}

TEST(Layers, TheSmallestBucketsAreJoinedWithTheirNeighbors)
{
  // Many of layer 0, few of layers 0 and 1, many of layer 1, few of layer 9.
  std::vector<double> values(100, 0);
  values.insert(values.end(), 100, 1.0);
  values.insert(values.end(), 8, 9.0);
  const LayerRow row(values);
  const MeshAccess mesh(row.Mesh.GetInput());
  const LayerValues numbers(row.Description, Ask(row.Numbers.data(), 10));
  Layers layers;
  for (int i = 1; i < 10; ++i)
  {
    layers.Bounds.push_back(i - 0.5);
  }
  // 97 tets of 0, 3 of 0 and 1, 97 of 1, 3 of 1 and 9, 5 of 9.
  EXPECT_EQ(SortByLayers(mesh, numbers, layers, 1).Start,
    (std::vector<std::size_t>{ 0, 97, 100, 197, 200, 205 }));
  // The two of three are better off together than making 97 others wider.
  EXPECT_EQ(SortByLayers(mesh, numbers, layers, 4).Start,
    (std::vector<std::size_t>{ 0, 97, 103, 200, 205 }));
  EXPECT_EQ(
    SortByLayers(mesh, numbers, layers, 6).Start, (std::vector<std::size_t>{ 0, 97, 108, 205 }));
  EXPECT_EQ(SortByLayers(mesh, numbers, layers, 1000).Start, (std::vector<std::size_t>{ 0, 205 }));
}

TEST(Layers, BaseMeshesHaveThemToo)
{
  const auto mesh = MakeCubes(18, 0.2);
  TreeSample sample(mesh);
  const Values values(mesh);
  sample.BuildTree({ values.Field.begin(), values.Field.end() });
  const auto path = GetPath("levels.gtn");
  WriterOptions options;
  options.ChunkSize = 1024;
  options.Tree = &sample.Tree;
  options.Levels = 4;
  WriteLayered(path, mesh, 5, LayerSpacing::Histogram, options);
  const auto file = std::make_shared<FileReader>(path);
  EXPECT_TRUE(VerifyFile(*file));
  ASSERT_GT(file->GetLevels().size(), 0u);
  for (std::size_t i = 0; i < file->GetLevels().size(); ++i)
  {
    const auto level = file->OpenLevel(i);
    ASSERT_TRUE(level->HasLayers());
    EXPECT_EQ(level->GetLayers().GetCount(), 5u);
    // Its own layers, of the remaining values.
    EXPECT_NE(level->GetLayers().Bounds, file->GetLayers().Bounds);
  }
  // A mesh after merges is that of the file without layers.
  const auto plain = GetPath("plain.gtn");
  Write(plain, mesh, options);
  const auto other = std::make_shared<FileReader>(plain);
  for (const std::size_t merges : { 500u, 3000u })
  {
    const auto read = [&](const std::shared_ptr<FileReader>& from)
    {
      auto request = AskForAll(*from);
      request.Tree = std::make_shared<const MergeTree>(from->GetMergeTree());
      request.Merges = request.Tree->CountMergesOfRounds(merges);
      PieceDecoder decoder(from);
      const Piece piece(decoder, request);
      return GetCells(piece.Mesh, piece);
    };
    EXPECT_EQ(read(file), read(other));
  }
}

TEST(Layers, WhatCannotBeLayersIsRefused)
{
  const auto mesh = MakeCubes(2, 0);
  const auto path = GetPath("never.gtn");
  const Values values(mesh);
  const auto expect = [&](const std::string& what, const std::function<void(LayerRequest&)>& change)
  {
    WriterOptions options;
    options.Layers = Ask(values.Field.data(), 4);
    change(*options.Layers);
    try
    {
      FileWriter(path, mesh.GetInput(), Values::Describe(), options);
      ADD_FAILURE() << "no error, but expected: " << what;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
      EXPECT_EQ(error.what(), what);
    }
  };
  expect(
    "the array that layers are to be made of is not there", [](LayerRequest& r) { r.Array = 3; });
  expect("layers need a point array, and 'material' is one of cells",
    [](LayerRequest& r) { r.Array = 2; });
  expect(
    "array 'field' has no component 1 to make layers of", [](LayerRequest& r) { r.Component = 1; });
  expect("array 'vector' has no component 4 to make layers of",
    [](LayerRequest& r)
    {
      r.Array = 1;
      r.Component = 4;
    });
  expect("there must be from 1 to 4096 layers, not 4097", [](LayerRequest& r) { r.Count = 4097; });
  expect("the spacing of the layers is unknown",
    [](LayerRequest& r) { r.Spacing = LayerSpacing::Other; });
  expect("the spacing of the layers is unknown",
    [](LayerRequest& r) { r.Spacing = static_cast<LayerSpacing>(4); });
  expect("layers need the values of array 'field'", [](LayerRequest& r) { r.Values = nullptr; });
  EXPECT_TRUE(ListFolder(path).empty());
}

TEST(Layers, AStepOfOtherValuesIsRefused)
{
  const auto mesh = MakeCubes(6, 0.1);
  const Values values(mesh);
  const Values others(mesh, 2);
  WriterOptions options;
  options.ChunkSize = 100;
  options.Layers = Ask(values.Field.data(), 4);
  FileWriter writer(GetPath("never.gtn"), mesh.GetInput(), Values::Describe(), options);
  EXPECT_THROW(writer.WriteStep(others.Get()), Error);
}

TEST(Layers, WhatPiecesTakeAddsUp)
{
  const auto mesh = MakeCubes(8, 0.3);
  const auto path = GetPath("layers.gtn");
  WriterOptions options;
  options.ChunkSize = 256;
  WriteLayered(path, mesh, 5, LayerSpacing::Histogram, options, 2);
  const FileReader file(path);
  std::vector<std::uint32_t> chunks(file.GetChunks().size());
  std::iota(chunks.begin(), chunks.end(), 0u);
  const std::vector<std::uint32_t> arrays{ 0, 1, 2 };
  const auto all = file.GetStatistics();
  // Small meshes have no palettes of double values that differ, and there are no unused points.
  std::uint64_t bytes = file.GetPieceBytes(chunks, {}, 0);
  EXPECT_EQ(bytes, all.ConnectivityBytes + all.GeometryBytes + all.SharedGeometryBytes);
  for (const std::uint32_t array : { 0u, 1u })
  {
    EXPECT_EQ(file.GetPieceBytes({}, { &array, 1 }, 0), 0u);
    EXPECT_EQ(file.GetPieceBytes(chunks, { &array, 1 }, 0) +
        file.GetPieceBytes(chunks, { &array, 1 }, 1) - 2 * bytes,
      all.ArrayBytes[array]);
  }
  const std::uint32_t some[] = { 0, 1 };
  EXPECT_LT(file.GetPieceBytes(some, arrays, 0), file.GetPieceBytes(chunks, arrays, 0));
  EXPECT_LE(file.GetPieceBytes(some, arrays, 0),
    file.GetPieceBytes({ some, 1 }, arrays, 0) + file.GetPieceBytes({ some + 1, 1 }, arrays, 0));
}
}
}
