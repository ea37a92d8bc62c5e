// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes that are written in parts against the same meshes written as a whole.

#include "gatunPartWriter.h"

#include "gatunHostile.h"
#include "gatunMeshParts.h"
#include "gatunParallel.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

namespace
{
using namespace gatun;
using namespace gatun::test;

PartWriterOptions MakePartOptions(std::uint8_t keep = KeepNone)
{
  PartWriterOptions options;
  options.File.ChunkSize = 200;
  options.File.Keep = keep;
  return options;
}

/** Hexahedra, or their quadrilateral faces, or all their edges, in a cube. */
Mixture MakeGrid(std::int64_t n, std::uint8_t type)
{
  Mixture grid(n);
  Mixture result(0);
  result.Coordinates = grid.Coordinates;
  const auto row = n + 1;
  for (std::int64_t i = 0; i < n * n * n; ++i)
  {
    const auto a = (i / (n * n) * row + i / n % n) * row + i % n;
    const auto b = a + row * row;
    if (type == Hexahedron)
    {
      result.AddCell(type, { a, a + 1, a + row + 1, a + row, b, b + 1, b + row + 1, b + row });
    }
    else if (type == Quad && i < n * n)
    {
      result.AddCell(type, { a, a + 1, a + row + 1, a + row });
    }
    else if (type == Line)
    {
      result.AddCell(type, { a, a + 1 });
    }
  }
  return result;
}

/** Quadratic hexahedra: corners, then the middles of edges. */
Mixture MakeQuadraticGrid(std::int64_t n)
{
  constexpr std::int64_t places[20][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 },
    { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 },
    { 0, 1, 0 }, { 1, 0, 2 }, { 2, 1, 2 }, { 1, 2, 2 }, { 0, 1, 2 }, { 0, 0, 1 }, { 2, 0, 1 },
    { 2, 2, 1 }, { 0, 2, 1 } };
  Mixture result(0);
  result.Coordinates.clear();
  std::map<std::array<std::int64_t, 3>, std::int64_t> ids;
  for (std::int64_t i = 0; i < n * n * n; ++i)
  {
    result.AddCell(25, {});
    for (const auto& place : places)
    {
      const std::array at{ 2 * (i % n) + place[0], 2 * (i / n % n) + place[1],
        2 * (i / (n * n)) + place[2] };
      const auto [id, isNew] = ids.try_emplace(at, static_cast<std::int64_t>(ids.size()));
      if (isNew)
      {
        for (const auto x : at)
        {
          result.Coordinates.push_back(static_cast<double>(x) / 2);
        }
      }
      result.Ids.push_back(id->second);
    }
    result.Offsets.back() = static_cast<std::int64_t>(result.Ids.size());
  }
  return result;
}

/** The points that cells use. */
std::size_t CountUsed(const PartMesh& mesh)
{
  return std::set<std::int64_t>(mesh.Cells.Ids.begin(), mesh.Cells.Ids.end()).size();
}

/** Expects that a file has all of a mesh at a step. */
void ExpectMesh(const std::string& path, const PartMesh& mesh, int step)
{
  const PartContent back(path, static_cast<std::size_t>(step));
  EXPECT_EQ(back.Mesh.GetPoints(), mesh.GetPoints());
  EXPECT_EQ(CountUsed(back.Mesh), CountUsed(mesh));
  EXPECT_EQ(ListCells(back.Mesh, back.Values) == ListCells(mesh, PartValues(mesh, step)), true);
}

/** byIds: by global ids, wherever the points are. */
void ExpectJoined(const PartMesh& mesh, bool byIds)
{
  const auto whole = GetPath("whole.gtn");
  const auto path = GetPath("parts.gtn");
  auto options = MakePartOptions();
  options.JoinByIdsOnly = byIds;
  WriteWhole(whole, mesh, options.File);
  ExpectMesh(whole, mesh, 0);
  for (const std::size_t parts : { 1, 2, 7, 20 })
  {
    for (const bool randomly : { false, true })
    {
      SCOPED_TRACE(std::to_string(parts) + (randomly ? " at random" : " slabs"));
      const auto divided =
        Divide(mesh, parts, randomly ? DealRandomly(mesh, parts, 3) : DealSlabs(mesh, parts, 8));
      for (const bool withIds : { byIds, true })
      {
        const auto statistics = WriteParts(path, divided, options, 1, withIds);
        ExpectMesh(path, mesh, 0);
        EXPECT_EQ(statistics.Points, mesh.GetPoints());
        EXPECT_EQ(statistics.Cells, mesh.GetCells());
        EXPECT_EQ(statistics.DifferentPoints, 0u);
        EXPECT_EQ(statistics.AmbiguousPoints, 0u);
        EXPECT_TRUE(VerifyFile(*std::make_shared<FileReader>(path)));
      }
    }
  }
}
}

TEST(PartWriter, JoinsTetrahedra)
{
  auto cubes = MakeCubes(8, 0.2);
  cubes.Coordinates.insert(cubes.Coordinates.end(), { 50, 0, 0, 51, 0, 0 }); // unused
  ExpectJoined(MakePartMesh(cubes), false);
}

TEST(PartWriter, JoinsNonmanifoldTetrahedraByIds)
{
  auto soup = MakeSoup(100, 400);
  soup.Coordinates.resize(3 * 100);
  ExpectJoined(MakePartMesh(soup), true);
}

TEST(PartWriter, JoinsHexahedra)
{
  ExpectJoined(MakePartMesh(MakeGrid(8, Hexahedron)), false);
}

TEST(PartWriter, JoinsSurfacesAndLines)
{
  ExpectJoined(MakePartMesh(MakeGrid(8, Quad)), false);
  ExpectJoined(MakePartMesh(MakeGrid(8, Line)), false);
}

TEST(PartWriter, JoinsNodesOfQuadraticCells)
{
  ExpectJoined(MakePartMesh(MakeQuadraticGrid(4)), false);
}

TEST(PartWriter, JoinsMixturesByIds)
{
  ExpectJoined(MakePartMesh(Mixture(6)), true);
}

TEST(PartWriter, ChunksOfAPartSuitTheWholeMesh)
{
  // 100,000 tetrahedra: two chunks by themselves, one in a mesh of over one million.
  const auto path = GetPath("part.gtn");
  const auto mesh = MakePartMesh(MakeGrid(27, Hexahedron));
  WriterOptions options;
  options.Coding = Profile::Small; // where cells count as their tetrahedra
  WriteWhole(path, mesh, options);
  EXPECT_EQ(FileReader(path).GetChunks().size(), 2u);
  options.Parts = 12;
  WriteWhole(path, mesh, options);
  EXPECT_EQ(FileReader(path).GetChunks().size(), 1u);
  ExpectMesh(path, mesh, 0);
}

TEST(PartWriter, NegativeIdsTellWhichPointsAreInNoOtherPart)
{
  const auto mesh = MakePartMesh(Mixture(6)); // where the boundaries of parts are not enough
  auto parts = Divide(mesh, 5, DealRandomly(mesh, 5, 3));
  std::map<std::int64_t, int> uses;
  for (const auto& part : parts)
  {
    for (const auto id : part.PointIds)
    {
      ++uses[id];
    }
  }
  for (auto& part : parts)
  {
    std::replace_if(
      part.PointIds.begin(), part.PointIds.end(), [&](auto id) { return uses[id] == 1; }, -1);
  }
  auto options = MakePartOptions();
  options.JoinByIdsOnly = true;
  auto statistics = WriteParts(GetPath("parts.gtn"), parts, options, 1, true);
  ExpectMesh(GetPath("parts.gtn"), mesh, 0);
  EXPECT_EQ(statistics.Points, mesh.GetPoints());
  EXPECT_EQ(statistics.DifferentPoints, 0u);

  std::size_t all = 0;
  for (auto& part : parts)
  {
    all += part.PointIds.size();
    std::fill(part.PointIds.begin(), part.PointIds.end(), -1);
  }
  statistics = WriteParts(GetPath("parts.gtn"), parts, options, 1, true);
  EXPECT_EQ(statistics.Points, all);
}

TEST(PartWriter, FilesOfPartsAreLittleLarger)
{
  const auto mesh = MakePartMesh(MakeCubes(24, 0.2));
  PartWriterOptions options;
  options.File.ChunkSize = 10000;
  WriteWhole(GetPath("whole.gtn"), mesh, options.File);
  WriteParts(GetPath("parts.gtn"), Divide(mesh, 8, DealSlabs(mesh, 8, 24)), options);
  EXPECT_LT(static_cast<double>(std::filesystem::file_size(GetPath("parts.gtn"))),
    1.08 * static_cast<double>(std::filesystem::file_size(GetPath("whole.gtn"))));
}

TEST(PartWriter, OnePartGivesTheFileOfFileWriter)
{
  auto tets = MakeCubes(6, 0.2);
  tets.Coordinates.insert(tets.Coordinates.end(), { 50, 0, 0, 51, 0, 0 }); // unused
  for (const auto& mesh : { MakePartMesh(tets), MakePartMesh(Mixture(5)) })
  {
    for (const std::uint8_t keep : { KeepNone, KeepAll })
    {
      for (const int steps : { 0, 1, 3 })
      {
        const auto options = MakePartOptions(keep);
        WriteWhole(GetPath("whole.gtn"), mesh, options.File, steps);
        WriteParts(GetPath("parts.gtn"), { mesh }, options, steps);
        EXPECT_TRUE(ReadBytes(GetPath("whole.gtn")) == ReadBytes(GetPath("parts.gtn")));
      }
    }
  }
}

TEST(PartWriter, BytesDependNeitherOnThreadsNorOnMemory)
{
  const auto mesh = MakePartMesh(Mixture(7));
  const auto parts = Divide(mesh, 5, DealRandomly(mesh, 5, 1));
  std::set<std::string> files;
  for (const int threads : { 1, 2 })
  {
    for (const std::size_t memory : { 0, 1 << 20 })
    {
      WithNumberOfThreads(threads,
        [&]
        {
          auto options = MakePartOptions(KeepAll);
          options.SpillMemory = memory;
          const auto statistics = WriteParts(GetPath("parts.gtn"), parts, options);
          EXPECT_EQ(statistics.SpilledBytes > 0, memory == 0);
          files.insert(ReadBytes(GetPath("parts.gtn")));
        });
    }
  }
  EXPECT_EQ(files.size(), 1u);
  EXPECT_EQ(ListFolder(GetPath("parts.gtn")), (std::vector<std::string>{ "parts.gtn" }));
}

TEST(PartWriter, WritesTimeSteps)
{
  auto cubes = MakeCubes(6, 0.2);
  cubes.Coordinates.insert(cubes.Coordinates.end(), { 50, 0, 0, 51, 0, 0 }); // unused
  const auto mesh = MakePartMesh(cubes);
  auto options = MakePartOptions();
  options.File.KeyStepInterval = 3;
  const int steps = 5;
  WriteParts(GetPath("parts.gtn"), Divide(mesh, 6, DealRandomly(mesh, 6, 2)), options, steps);
  for (int step = 0; step < steps; ++step)
  {
    ExpectMesh(GetPath("parts.gtn"), mesh, step);
    const PartContent back(GetPath("parts.gtn"), static_cast<std::size_t>(step));
    EXPECT_EQ(back.Values.Point.back(), PartValues(mesh, step).Point.back()); // of an unused one
  }
}

TEST(PartWriter, OriginalNumbersCountThroughTheParts)
{
  auto cubes = MakeCubes(5, 0.2);
  cubes.Coordinates.insert(cubes.Coordinates.end(), { 50, 0, 0, 51, 0, 0 }); // unused
  const auto mesh = MakePartMesh(cubes);
  const auto parts = Divide(mesh, 6, DealRandomly(mesh, 6, 2));
  WriteParts(GetPath("parts.gtn"), parts, MakePartOptions(KeepAll));
  const PartContent back(GetPath("parts.gtn"), 0);
  std::set<std::int64_t> seen;
  std::vector<double> coordinates;
  std::vector<std::int32_t> cells;
  std::vector<double> corners;
  for (const auto& part : parts)
  {
    for (std::size_t p = 0; p < part.GetPoints(); ++p)
    {
      if (seen.insert(part.PointIds[p]).second)
      {
        const auto* x = &part.Cells.Coordinates[3 * p];
        coordinates.insert(coordinates.end(), x, x + 3);
      }
    }
    cells.insert(cells.end(), part.CellIds.begin(), part.CellIds.end());
    for (const auto id : part.Cells.Ids)
    {
      corners.push_back(part.Cells.Coordinates[3 * static_cast<std::size_t>(id)]);
    }
  }
  EXPECT_EQ(back.Mesh.Cells.Coordinates, coordinates);
  EXPECT_EQ(back.Values.Cell, cells);
  std::vector<double> backCorners;
  for (const auto id : back.Mesh.Cells.Ids)
  {
    backCorners.push_back(back.Mesh.Cells.Coordinates[3 * static_cast<std::size_t>(id)]);
  }
  EXPECT_EQ(backCorners, corners);
}

TEST(PartWriter, PartsWithoutCellsOrPoints)
{
  const auto mesh = MakePartMesh(MakeCubes(4, 0.2));
  auto parts = Divide(mesh, 5, DealRandomly(mesh, 3, 2)); // two without cells
  ASSERT_EQ(parts[3].GetPoints(), 0u);
  std::rotate(parts.begin(), parts.begin() + 4, parts.end());
  WriteParts(GetPath("parts.gtn"), parts, MakePartOptions(), 2);
  ExpectMesh(GetPath("parts.gtn"), mesh, 0);
  ExpectMesh(GetPath("parts.gtn"), mesh, 1);
  WriteParts(GetPath("parts.gtn"), { parts[0], parts[4] }, MakePartOptions());
  EXPECT_EQ(PartContent(GetPath("parts.gtn"), 0).Mesh.GetPoints(), 0u);
}

namespace
{
/** Two tetrahedra with a common face, as two parts with points of their own. */
std::vector<PartMesh> MakePair()
{
  TestMesh pair;
  pair.Coordinates = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1 };
  pair.Ids = { 0, 1, 2, 3, 0, 2, 1, 4 };
  const auto mesh = MakePartMesh(pair);
  return Divide(mesh, 2, { 0, 1 });
}
}

TEST(PartWriter, PointsWithOtherValuesStayApart)
{
  const auto path = GetPath("parts.gtn");
  auto parts = MakePair();
  EXPECT_EQ(WriteParts(path, parts).Points, 5u);
  parts[1].Bias = [](const double* x) { return x[0] == 1 ? 1.0 : 0.0; };
  auto statistics = WriteParts(path, parts);
  EXPECT_EQ(statistics.Points, 6u);
  EXPECT_EQ(statistics.JoinedPoints, 2u);
  EXPECT_EQ(statistics.DifferentPoints, 2u);
  // They differ in a later step only.
  {
    PartWriter writer(path, PartMesh::Describe(), {});
    const auto getValues = [&](int p, int step)
    {
      PartValues values(parts[0], step);
      values = PartValues(parts[static_cast<std::size_t>(p)], step);
      if (p == 1 && step == 0)
      {
        auto same = parts[1];
        same.Bias = {};
        values = PartValues(same, step);
      }
      return values;
    };
    for (const int p : { 0, 1 })
    {
      writer.Survey(parts[static_cast<std::size_t>(p)].GetInput());
      writer.SurveyStep(getValues(p, 0).Get());
      writer.SurveyStep(getValues(p, 1).Get());
    }
    for (const int p : { 0, 1 })
    {
      writer.Write(parts[static_cast<std::size_t>(p)].GetInput());
      writer.WriteStep(getValues(p, 0).Get(), {}, true, 0);
      writer.WriteStep(getValues(p, 1).Get(), {}, true, 1);
    }
    EXPECT_EQ(writer.Finish().Points, 6u);
  }
}

TEST(PartWriter, SignsOfZeroAreKept)
{
  auto parts = MakePair();
  for (auto& x : parts[1].Cells.Coordinates)
  {
    x = x == 0 ? -0.0 : x;
  }
  const auto statistics = WriteParts(GetPath("parts.gtn"), parts);
  EXPECT_EQ(statistics.Points, 8u);
  EXPECT_EQ(statistics.DifferentPoints, 6u);
  const PartContent back(GetPath("parts.gtn"), 0);
  EXPECT_EQ(std::count_if(back.Mesh.Cells.Coordinates.begin(), back.Mesh.Cells.Coordinates.end(),
              [](double x) { return x == 0 && std::signbit(x); }),
    9); // three at the origin, two at each other corner
}

TEST(PartWriter, WhatIsNotANumberIsNotAPlace)
{
  auto parts = MakePair();
  for (auto& part : parts)
  {
    part.Cells.Coordinates[0] = std::numeric_limits<double>::quiet_NaN();
  }
  EXPECT_EQ(WriteParts(GetPath("parts.gtn"), parts).Points, 6u);
  EXPECT_EQ(WriteParts(GetPath("parts.gtn"), parts, {}, 1, true).Points, 5u);
}

TEST(PartWriter, GlobalIdsDecide)
{
  const auto path = GetPath("parts.gtn");
  auto parts = MakePair();
  parts[1].PointIds[0] = 77; // the same place
  EXPECT_EQ(WriteParts(path, parts, {}, 1, true).Points, 6u);
  parts = MakePair();
  parts[1].Cells.Coordinates[1] = 0.25; // the same id elsewhere
  const auto statistics = WriteParts(path, parts, {}, 1, true);
  EXPECT_EQ(statistics.Points, 6u);
  EXPECT_EQ(statistics.DifferentPoints, 2u);
}

TEST(PartWriter, CracksStay)
{
  // Two cubes of tetrahedra beside each other with points of their own, in one part; the other
  // part is behind both.
  auto cubes = MakeCubes(4, 0);
  const auto points = cubes.GetPoints();
  auto mesh = MakePartMesh(cubes);
  auto& cells = mesh.Cells;
  std::vector<std::int64_t> twin(points, -1);
  for (std::size_t c = 0; c < mesh.GetCells(); ++c)
  {
    double x = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      x += cells.Coordinates[3 * static_cast<std::size_t>(cells.Ids[4 * c + i])];
    }
    for (std::size_t i = 0; i < 4 && x > 8; ++i)
    {
      auto& id = cells.Ids[4 * c + i];
      const auto p = static_cast<std::size_t>(id);
      if (p < points && cells.Coordinates[3 * p] == 2)
      {
        if (twin[p] < 0)
        {
          twin[p] = static_cast<std::int64_t>(mesh.GetPoints());
          mesh.PointIds.push_back(twin[p]);
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            cells.Coordinates.push_back(double{ cells.Coordinates[3 * p + axis] });
          }
        }
        id = twin[p];
      }
    }
  }
  ASSERT_EQ(mesh.GetPoints(), 150u);
  const auto path = GetPath("parts.gtn");
  const auto slabs = Divide(mesh, 4, DealSlabs(mesh, 4, 4));
  // By coordinates, the points of the crack that two slabs have stay apart.
  const auto byPlace = WriteParts(path, slabs, MakePartOptions());
  EXPECT_EQ(byPlace.Points, 150u + 3u * 10u);
  EXPECT_EQ(byPlace.AmbiguousPoints, 3u * 20u);
  const PartContent back(path, 0);
  EXPECT_EQ(ListCells(back.Mesh, back.Values) == ListCells(mesh, PartValues(mesh, 0)), true);
  // Global ids tell them apart.
  const auto byId = WriteParts(path, slabs, MakePartOptions(), 1, true);
  EXPECT_EQ(byId.Points, 150u);
  EXPECT_EQ(byId.AmbiguousPoints, 0u);
}

TEST(PartWriter, UnusedPointsAreThoseOfOtherParts)
{
  const auto mesh = MakePartMesh(MakeCubes(4, 0.2));
  auto parts = Divide(mesh, 4, DealSlabs(mesh, 4, 4));
  for (auto& part : parts)
  {
    // All parts have all points.
    std::vector<std::int64_t> place(part.PointIds.begin(), part.PointIds.end());
    for (auto& id : part.Cells.Ids)
    {
      id = place[static_cast<std::size_t>(id)];
    }
    part.Cells.Coordinates = mesh.Cells.Coordinates;
    part.PointIds = mesh.PointIds;
  }
  auto options = MakePartOptions(KeepAll);
  options.JoinByIdsOnly = true;
  WriteParts(GetPath("parts.gtn"), parts, options, 2, true);
  ExpectMesh(GetPath("parts.gtn"), mesh, 0);
  ExpectMesh(GetPath("parts.gtn"), mesh, 1);
}

TEST(PartWriter, PartsOfTetrahedraAndOfOtherCells)
{
  const auto mesh = MakePartMesh(MakeCubes(4, 0.2));
  auto parts = Divide(mesh, 4, DealSlabs(mesh, 4, 4));
  parts[1].IsTetrahedral = false; // with types
  WriteParts(GetPath("parts.gtn"), parts, MakePartOptions());
  ExpectMesh(GetPath("parts.gtn"), mesh, 0);
}
