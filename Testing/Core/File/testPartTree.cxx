// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The hierarchy of a mesh that is written in parts: what is left after merges, and the bounds of
// it.

#include "gatunHostile.h"
#include "gatunMeshParts.h"
#include "gatunParallel.h"
#include "gatunTestFile.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <vector>

namespace gatun::test
{
namespace
{
constexpr int StepsOfFile = 2;

PartWriterOptions MakeOptions()
{
  PartWriterOptions options;
  options.File.ChunkSize = 300;
  options.File.Keep = KeepCells;
  options.Weights = { 1, 0.5, 0, 0, 0 };
  return options;
}

PartMesh MakeTreeParts()
{
  auto cubes = MakeCubes(8, 0.2);
  cubes.Coordinates.insert(cubes.Coordinates.end(), { 50, 0, 0, 51, 0, 0 }); // unused
  return MakePartMesh(cubes);
}

std::string WriteTree(
  const std::string& name, std::size_t parts, bool randomly, int steps = StepsOfFile)
{
  const auto path = TempPath(name);
  const PartMesh mesh = MakeTreeParts();
  WriteParts(path,
    Divide(mesh, parts, randomly ? DealRandomly(mesh, parts, 3) : DealSlabs(mesh, parts, 8)),
    MakeOptions(), steps);
  return path;
}

/** Some chunks after merges. */
struct Rest
{
  Rest(const std::shared_ptr<const FileReader>& file, std::vector<std::uint32_t> chunks,
    std::size_t merges, std::size_t step = 0)
  {
    PieceDecoder decoder(file);
    PieceRequest request;
    request.Chunks = std::move(chunks);
    request.Arrays = { 0, 1 };
    request.Merges = merges;
    request.Tree = std::make_shared<const MergeTree>(file->GetMergeTree());
    request.Step = step;
    decoder.SetRequest(request);
    this->Coordinates.resize(3 * decoder.GetNumberOfPoints());
    this->Ids.resize(4 * decoder.GetNumberOfCells());
    this->CellIds.resize(decoder.GetNumberOfCells());
    this->Point.resize(decoder.GetNumberOfPoints());
    this->Level.resize(2 * decoder.GetNumberOfPoints());
    PieceTarget target;
    target.Points = this->Coordinates.data();
    target.Connectivity = this->Ids.data();
    target.GlobalCellIds = this->CellIds.data();
    target.Arrays = { this->Point.data(), this->Level.data() };
    decoder.Fill(target);
  }

  double GetVolume(std::size_t tet) const
  {
    std::array<std::array<double, 3>, 3> edges{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        edges[i][axis] = this->GetCoordinate(tet, i + 1, axis) - this->GetCoordinate(tet, 0, axis);
      }
    }
    const auto& [a, b, c] = edges;
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  double GetCoordinate(std::size_t tet, std::size_t corner, std::size_t axis) const
  {
    return this->Coordinates[3 * static_cast<std::size_t>(this->Ids[4 * tet + corner]) + axis];
  }

  std::vector<double> Coordinates;
  std::vector<std::int64_t> Ids;
  std::vector<std::int64_t> CellIds;
  std::vector<double> Point;
  std::vector<float> Level;
};

std::vector<std::uint32_t> ListChunks(const FileReader& file)
{
  std::vector<std::uint32_t> chunks(file.GetChunks().size());
  std::iota(chunks.begin(), chunks.end(), 0u);
  return chunks;
}

std::vector<std::size_t> ListMerges(const FileReader& file)
{
  const auto all = file.GetNumberOfMerges();
  return { 0, 1, all / 4, all / 2, all * 9 / 10, all };
}

class PartTreeFile : public testing::TestWithParam<std::pair<std::size_t, bool>>
{
protected:
  PartTreeFile()
    : File(std::make_shared<const FileReader>(WriteTree(
        "partTree" + std::to_string(GetParam().first) + (GetParam().second ? "r.gtn" : "s.gtn"),
        GetParam().first, GetParam().second)))
  {
  }

  std::shared_ptr<const FileReader> File;
};
}

TEST_P(PartTreeFile, TurnsNoTetrahedronOver)
{
  EXPECT_TRUE(VerifyFile(*std::make_shared<FileReader>(this->File->GetPath())));
  const auto points = this->File->GetNumberOfPoints() - this->File->GetNumberOfUnusedPoints();
  EXPECT_GT(this->File->GetNumberOfMerges(), points * 8 / 10);
  std::map<std::int64_t, double> volumes;
  std::size_t before = 0;
  for (const auto merges : ListMerges(*this->File))
  {
    const Rest rest(this->File, ListChunks(*this->File), merges);
    EXPECT_EQ(rest.Point.size(), points - merges);
    for (std::size_t t = 0; t < rest.CellIds.size(); ++t)
    {
      const double volume = rest.GetVolume(t);
      const auto first = volumes.try_emplace(rest.CellIds[t], volume).first;
      EXPECT_GT(volume * first->second, 0) << merges;
    }
    before = rest.CellIds.size();
    // The values are still those of the points.
    for (std::size_t p = 0; p < rest.Point.size(); ++p)
    {
      const double* const x = rest.Coordinates.data() + 3 * p;
      EXPECT_EQ(rest.Point[p], std::sin(x[0]) + x[1] * x[2]);
    }
  }
  EXPECT_LT(before, volumes.size() / 5);
}

TEST_P(PartTreeFile, BoundsAndRangesEncloseWhatIsLeft)
{
  const auto all = this->File->GetNumberOfMerges();
  for (const auto merges : ListMerges(*this->File))
  {
    for (const auto chunk : ListChunks(*this->File))
    {
      for (std::size_t step = 0; step < StepsOfFile; ++step)
      {
        const Rest rest(this->File, { chunk }, merges, step);
        const Bounds& box = this->File->GetChunkBounds(chunk, merges);
        const Range range = this->File->GetChunkRanges(0, step, chunk, merges)[0];
        for (std::size_t i = 0; i < rest.Coordinates.size(); ++i)
        {
          EXPECT_GE(rest.Coordinates[i], box[i % 3].Min);
          EXPECT_LE(rest.Coordinates[i], box[i % 3].Max);
        }
        for (const double value : rest.Point)
        {
          EXPECT_GE(value, range.Min);
          EXPECT_LE(value, range.Max);
        }
      }
    }
  }
  // And they are no larger than the mesh, which the unused points are not a part of.
  for (const auto chunk : ListChunks(*this->File))
  {
    EXPECT_LT(this->File->GetChunkBounds(chunk, all)[0].Max, 9);
  }
}

INSTANTIATE_TEST_SUITE_P(, PartTreeFile,
  testing::Values(std::pair(1u, false), std::pair(4u, false), std::pair(3u, true)),
  [](const auto& given)
  { return std::to_string(given.param.first) + (given.param.second ? "AtRandom" : "Slabs"); });

TEST(PartTree, DoesNotDependOnThreads)
{
  std::vector<char> first;
  for (const int threads : { 1, 2, 4 })
  {
    std::vector<char> bytes;
    WithNumberOfThreads(threads,
      [&]
      {
        std::ifstream in(WriteTree("partTreeThreads.gtn", 4, false), std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
      });
    first = first.empty() ? bytes : first;
    EXPECT_TRUE(bytes == first) << threads;
  }
}

TEST(PartTree, MeshesWithoutValuesAndWithOtherCells)
{
  // Without steps, only the shape counts.
  const auto path = WriteTree("partTreeBare.gtn", 3, false, 0);
  EXPECT_GT(FileReader(path).GetNumberOfMerges(), 300u);
  const auto mixed = TempPath("partTreeMixed.gtn");
  const PartMesh mesh = MakePartMesh(Mixture(5));
  WriteParts(mixed, Divide(mesh, 3, DealSlabs(mesh, 3, 5)), MakeOptions(), 1);
  EXPECT_TRUE(VerifyFile(*std::make_shared<FileReader>(mixed)));
  EXPECT_GT(FileReader(mixed).GetNumberOfMerges(), 0u);
}

TEST(PartTree, IsRefusedOrAbortedWithoutATrace)
{
  const auto path = GetPath("partTreeErrors.gtn");
  auto options = MakeOptions();
  options.Weights = { 1 };
  EXPECT_THROW(PartWriter(path, PartMesh::Describe(), options), Error);
  // Arrays of cells have no values of points, and weights are numbers.
  for (const std::vector<double>& weights : { std::vector<double>{ 0, 0, 1, 0, 0 },
         std::vector<double>{ -1, 0, 0, 0, 0 }, std::vector<double>{ std::nan(""), 0, 0, 0, 0 } })
  {
    options.Weights = weights;
    EXPECT_THROW(PartWriter(path, PartMesh::Describe(), options), Error);
  }
  options = MakeOptions();
  options.File.IsSurface = true;
  EXPECT_THROW(PartWriter(path, PartMesh::Describe(), options), Error);
  const PartMesh mesh = MakeTreeParts();
  const PartValues values(mesh, 0);
  {
    PartWriter writer(path, PartMesh::Describe(), MakeOptions());
    writer.Survey(mesh.GetInput());
    writer.SurveyStep(values.Get());
    writer.Write(mesh.GetInput());
    writer.WriteStep(values.Get());
    EXPECT_THROW(writer.Finish([](double) { return false; }), Error);
  }
  EXPECT_TRUE(ListFolder(path).empty());
}
}
