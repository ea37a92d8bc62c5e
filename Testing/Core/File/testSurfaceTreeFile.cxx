// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of surfaces with a merge tree. A surface that is read after a number of merges must equal
// the result of merging in memory.

#include "gatunHostileTrees.h"
#include "gatunSharedFile.h"
#include "gatunSurfaceTrees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Coordinates and values of a point. */
using PointContent = std::array<double, 5>;

/** Type, corners and value of a cell. A triangle begins with its smallest corner. */
using CellContent = std::tuple<int, std::vector<PointContent>, int>;

CellContent MakeContent(int type, std::vector<PointContent> corners, int value)
{
  if (type == 5)
  {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  return { type, std::move(corners), value };
}

/** What is left of a surface. */
struct Left
{
  std::vector<PointContent> Points;
  std::vector<CellContent> Cells;
  std::vector<unsigned char> PointGhosts;
  std::vector<unsigned char> CellGhosts;
  std::vector<std::int64_t> CellIds;

  std::multiset<PointContent> GetPoints(bool owned = false) const
  {
    std::multiset<PointContent> points;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      if (!owned || this->PointGhosts[i] == 0)
      {
        points.insert(this->Points[i]);
      }
    }
    return points;
  }
  std::multiset<CellContent> GetCells() const { return { this->Cells.begin(), this->Cells.end() }; }
};

template <typename T>
T Read(const Bytes& bytes, std::size_t at)
{
  T value;
  std::memcpy(&value, bytes.data() + at * sizeof(T), sizeof(T));
  return value;
}

/** The result of merging in memory: the specification, done again. */
Left Merge(const TreeSample& sample, std::size_t merges, std::size_t step)
{
  Left left;
  const auto ancestors = sample.Tree.FindAncestors(merges);
  const auto contentOf = [&](std::uint32_t i) -> PointContent
  {
    const auto& wave = sample.Steps[step][0];
    return { sample.Coordinates[3 * i], sample.Coordinates[3 * i + 1],
      sample.Coordinates[3 * i + 2], static_cast<double>(Read<float>(wave, 2 * i)),
      static_cast<double>(Read<float>(wave, 2 * i + 1)) };
  };
  for (std::uint32_t i = 0; i < ancestors.size(); ++i)
  {
    if (ancestors[i] == i)
    {
      left.Points.push_back(contentOf(i));
    }
  }
  for (std::size_t cell = 0; cell < sample.Types.size(); ++cell)
  {
    std::set<std::int64_t> before;
    std::set<std::uint32_t> after;
    std::vector<PointContent> corners;
    for (auto i = sample.Offsets[cell]; i < sample.Offsets[cell + 1]; ++i)
    {
      const auto id = static_cast<std::size_t>(sample.Ids[static_cast<std::size_t>(i)]);
      before.insert(static_cast<std::int64_t>(id));
      after.insert(ancestors[id]);
      corners.push_back(contentOf(ancestors[id]));
    }
    if (sample.Types[cell] != 5 || before.size() == after.size())
    {
      left.Cells.push_back(
        MakeContent(sample.Types[cell], corners, Read<std::int16_t>(sample.Steps[step][1], cell)));
      left.CellIds.push_back(static_cast<std::int64_t>(cell));
    }
  }
  return left;
}

Left Decode(const std::shared_ptr<const FileReader>& file, const PieceRequest& request)
{
  PieceDecoder decoder(file);
  decoder.SetRequest(request);
  EXPECT_FALSE(decoder.IsTetrahedral());
  EXPECT_EQ(decoder.GetFacesSize(), 0u);
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  const auto cells = static_cast<std::size_t>(decoder.GetNumberOfCells());
  std::vector<double> coordinates(3 * points);
  std::vector<std::int32_t> ids(static_cast<std::size_t>(decoder.GetConnectivitySize()));
  std::vector<std::int32_t> offsets(cells + 1);
  std::vector<std::uint8_t> types(cells);
  std::vector<float> wave(2 * points);
  std::vector<std::int16_t> material(cells);
  Left left;
  left.PointGhosts.resize(points);
  left.CellGhosts.resize(cells);
  left.CellIds.resize(cells);
  PieceTarget target;
  target.Points = coordinates.data();
  target.Connectivity = ids.data();
  target.WideIds = false;
  target.Offsets = offsets.data();
  target.Types = types.data();
  target.Arrays = { wave.data(), material.data() };
  target.PointGhosts = left.PointGhosts.data();
  target.CellGhosts = left.CellGhosts.data();
  target.GlobalCellIds = left.CellIds.data();
  decoder.Fill(target);
  for (std::size_t i = 0; i < points; ++i)
  {
    left.Points.push_back({ coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2],
      static_cast<double>(wave[2 * i]), static_cast<double>(wave[2 * i + 1]) });
  }
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    std::vector<PointContent> corners;
    for (auto i = offsets[cell]; i < offsets[cell + 1]; ++i)
    {
      corners.push_back(left.Points.at(static_cast<std::size_t>(ids[static_cast<std::size_t>(i)])));
    }
    left.Cells.push_back(MakeContent(types[cell], corners, material[cell]));
  }
  return left;
}

class SurfaceTreeFile : public testing::TestWithParam<std::pair<std::uint32_t, std::uint8_t>>
{
protected:
  SurfaceTreeFile()
    : Sample(MakeSurfaceSample(40, 16, 2))
  {
    WriterOptions options;
    options.ChunkSize = GetParam().first;
    options.Keep = GetParam().second;
    const auto all = static_cast<std::uint32_t>(this->Sample.Tree.GetMerges().size());
    this->Levels = { static_cast<std::uint32_t>(this->Sample.Tree.CountMergesOfRounds(all / 3)),
      static_cast<std::uint32_t>(this->Sample.Tree.CountMergesOfRounds(3 * all / 4)) };
    const auto path = GetPath("surface_tree" + std::to_string(GetParam().first) + "_" +
      std::to_string(GetParam().second) + ".gtn");
    WriteTreeSample(path, this->Sample, options, this->Levels);
    this->File = std::make_shared<const FileReader>(path);
    this->Tree = std::make_shared<const MergeTree>(this->File->GetMergeTree());
  }

  std::vector<std::size_t> SomeMerges() const
  {
    const auto all = this->Tree->GetMerges().size();
    return { 1, 2, 3, all / 10, all / 3, all / 2, all * 9 / 10, all - 1, all };
  }

  PieceRequest Ask(std::size_t merges, std::size_t step) const
  {
    auto request = AskForAll(*this->File, merges);
    request.Tree = this->Tree;
    request.Step = step;
    return request;
  }

  TreeSample Sample;
  std::vector<std::uint32_t> Levels;
  std::shared_ptr<const FileReader> File;
  std::shared_ptr<const MergeTree> Tree;
};

TEST_P(SurfaceTreeFile, TheTreeIsThatOfTheSurface)
{
  const auto& merges = this->Sample.Tree.GetMerges();
  ASSERT_GT(merges.size(), 500u);
  ASSERT_EQ(this->Tree->GetMerges().size(), merges.size());
  for (std::size_t i = 0; i < merges.size(); ++i)
  {
    ASSERT_EQ(this->Tree->GetMerges()[i].Error, merges[i].Error);
  }
  const auto& bonds = this->Sample.Tree.GetBonds();
  EXPECT_GT(std::count(bonds.begin(), bonds.end(), true), 20);
  EXPECT_EQ(this->Tree->GetBonds(), bonds);
  EXPECT_TRUE(VerifyFile(*this->File));
}

TEST_P(SurfaceTreeFile, SimplifiedSurfaceIsThatOfTheTree)
{
  for (const auto merges : this->SomeMerges())
  {
    for (const std::size_t step : { 0, 1 })
    {
      const Left left = Decode(this->File, this->Ask(merges, step));
      const Left expected = Merge(this->Sample, merges, step);
      EXPECT_EQ(left.GetPoints(true), expected.GetPoints()) << merges;
      EXPECT_EQ(left.GetCells(), expected.GetCells()) << merges;
      if (GetParam().second & KeepPoints)
      {
        EXPECT_EQ(left.Points, expected.Points) << merges;
      }
      if (GetParam().second & KeepCells)
      {
        EXPECT_EQ(left.Cells, expected.Cells) << merges;
        EXPECT_EQ(left.CellIds, expected.CellIds) << merges;
      }
    }
  }
}

TEST_P(SurfaceTreeFile, PiecesMakeUpTheWhole)
{
  const auto chunks = this->File->GetChunks().size();
  for (const auto merges : this->SomeMerges())
  {
    const Left whole = Merge(this->Sample, merges, 1);
    for (const unsigned ghosts : { 0u, 1u, 2u })
    {
      std::multiset<CellContent> cells;
      std::multiset<PointContent> points;
      for (std::size_t i = 0; i < 3; ++i)
      {
        auto request = this->Ask(merges, 1);
        request.Chunks.clear();
        for (auto c = chunks * i / 3; c < chunks * (i + 1) / 3; ++c)
        {
          request.Chunks.push_back(static_cast<std::uint32_t>(c));
        }
        request.WithUnusedPoints = i == 0;
        request.GhostLevels = ghosts;
        const Left piece = Decode(this->File, request);
        points.merge(piece.GetPoints(true));
        std::multiset<CellContent> around;
        std::set<PointContent> reached;
        for (std::size_t c = 0; c < piece.Cells.size(); ++c)
        {
          (piece.CellGhosts[c] == 0 ? cells : around).insert(piece.Cells[c]);
          if (piece.CellGhosts[c] == 0)
          {
            reached.insert(std::get<1>(piece.Cells[c]).begin(), std::get<1>(piece.Cells[c]).end());
          }
        }
        if (ghosts == 1) // points of other cells at the same place have other values or are shared
        {
          for (const CellContent& cell : around)
          {
            EXPECT_TRUE(std::any_of(std::get<1>(cell).begin(), std::get<1>(cell).end(),
              [&](const PointContent& corner) { return reached.count(corner) == 1; }));
          }
        }
        else if (ghosts == 0)
        {
          EXPECT_TRUE(around.empty());
        }
      }
      EXPECT_EQ(cells, whole.GetCells()) << merges << " " << ghosts;
      EXPECT_EQ(points, whole.GetPoints()) << merges << " " << ghosts;
    }
  }
}

TEST_P(SurfaceTreeFile, BaseMeshesGiveTheSame)
{
  SharedFile file(this->File);
  const auto all = this->Tree->GetMerges().size();
  std::set<const FileReader*> meshes;
  for (std::size_t merges = 0; merges <= all; merges += all / 37)
  {
    const auto place = file.Find(merges);
    meshes.insert(place.File.get());
    EXPECT_TRUE(place.File->IsSurface());
    auto request = AskForAll(*place.File, place.Merges);
    request.Tree = place.Tree;
    request.Step = 1;
    const auto whole = this->Tree->CountMergesOfRounds(merges);
    const Left left = Decode(place.File, request);
    const Left expected = Merge(this->Sample, whole, 1);
    EXPECT_EQ(left.GetPoints(true), expected.GetPoints()) << merges;
    EXPECT_EQ(left.GetCells(), expected.GetCells()) << merges;
  }
  EXPECT_EQ(meshes.size(), 3u);
  EXPECT_NEAR(static_cast<double>(file.EstimateCells(all / 2)),
    static_cast<double>(Merge(this->Sample, all / 2, 0).Cells.size()), 100);
}

TEST_P(SurfaceTreeFile, NoSeamIsOpened)
{
  SharedFile file(this->File);
  const auto& merges = this->Tree->GetMerges();
  std::size_t raised = 0;
  for (std::size_t n = 1; n < merges.size(); ++n)
  {
    const auto place = file.Find(n, false);
    ASSERT_EQ(place.Merges, this->Tree->CountMergesOfRounds(n));
    ASSERT_EQ(place.Tree == nullptr, place.Merges == 0);
    raised += place.Merges != n;
  }
  const auto& bonds = this->Tree->GetBonds();
  EXPECT_EQ(raised, static_cast<std::size_t>(std::count(bonds.begin(), bonds.end(), true)));
  EXPECT_THROW(Decode(this->File, this->Ask(merges.size() + 1, 0)), Error);
}

TEST_P(SurfaceTreeFile, BoundsAndRangesOfChunksHold)
{
  for (const auto merges : this->SomeMerges())
  {
    for (std::uint32_t chunk = 0; chunk < this->File->GetChunks().size(); ++chunk)
    {
      auto request = this->Ask(merges, 1);
      request.Chunks = { chunk };
      request.WithUnusedPoints = false;
      const auto& box = this->File->GetChunkBounds(chunk, merges);
      const auto& wave = this->File->GetChunkRanges(0, 1, chunk, merges);
      for (const PointContent& point : Decode(this->File, request).Points)
      {
        for (std::size_t i = 0; i < 5; ++i)
        {
          const Range& range = i < 3 ? box[i] : wave[i - 3];
          ASSERT_TRUE(range.Min <= point[i] && point[i] <= range.Max);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, SurfaceTreeFile,
  testing::Values(std::pair{ 64u, KeepNone }, std::pair{ 64u, KeepAll },
    std::pair{ 100000u, KeepAll }, std::pair{ 300u, KeepPoints }, std::pair{ 300u, KeepCells }));

TEST(SurfaceTree, ATreeOfNoMergesLeavesAll)
{
  auto sample = MakeSurfaceSample(8, 6, 1);
  sample.Tree = MergeTree(static_cast<std::uint32_t>(sample.GetPoints()), {});
  const auto path = GetPath("surface_without_merges.gtn");
  WriteTreeSample(path, sample, {});
  EXPECT_EQ(FileReader(path).GetNumberOfMerges(), 0u);
  EXPECT_TRUE(VerifyFile(FileReader(path)));
}

TEST(SurfaceTree, WriterMakesBaseMeshesOfWholeMerges)
{
  const auto sheet = MakeSheet(260, 100, true, true, PlaceOnTorus, true);
  auto sample = ToSample(sheet, 1);
  BuildSurfaceTree(sample, sheet.Values);
  // The number of merges that leaves half of the points is not a whole one.
  auto bonds = sample.Tree.GetBonds();
  const auto half = sample.GetPoints() - (sample.GetPoints() + 1) / 2;
  bonds[half - 1] = true;
  sample.Tree = MergeTree(
    static_cast<std::uint32_t>(sample.GetPoints()), sample.Tree.GetMerges(), std::move(bonds));
  const auto path = GetPath("surface_levels.gtn");
  WriterOptions options;
  options.Tree = &sample.Tree;
  options.IsSurface = true;
  options.Levels = 8;
  FileWriter writer(path, sample.GetInput(), sample.Arrays, options);
  writer.WriteStep(
    std::vector<const void*>{ sample.Steps[0][0].data(), sample.Steps[0][1].data() }, {}, false, 0);
  EXPECT_GT(writer.Finish().LevelBytes, 1000u);
  const FileReader file(path);
  ASSERT_EQ(file.GetLevels().size(), 2u); // of 52,000 triangles, 26,000 and 13,000
  EXPECT_EQ(file.GetLevels()[0], sample.Tree.CountMergesOfRounds(half));
  EXPECT_GT(file.GetLevels()[0], half);
  for (const auto merges : file.GetLevels())
  {
    EXPECT_EQ(sample.Tree.CountWholeMerges(merges), merges);
  }
  EXPECT_LT(file.OpenLevel(1)->GetNumberOfCells(), 20000u);
  EXPECT_TRUE(VerifyFile(file));
}
}
