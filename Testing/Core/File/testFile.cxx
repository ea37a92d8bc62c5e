// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileReader.h"
#include "gatunFileWriter.h"
#include "gatunPieceDecoder.h"
#include "gatunVerifyFile.h"

#include "gatunError.h"
#include "gatunTestFile.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace
{
using namespace gatun;
using namespace gatun::test;

TEST(File, KeepsEveryCellAndPointWithoutOrder)
{
  const auto mesh = MakeCubes(9, 0.2);
  const auto path = TempPath("plain.gtn");
  WriterOptions options;
  options.ChunkSize = 300;
  Write(path, mesh, options);
  const auto file = std::make_shared<FileReader>(path);
  EXPECT_GT(file->GetChunks().size(), 10u);
  PieceDecoder decoder(file);
  const Piece all(decoder, AskForAll(*file));
  EXPECT_EQ(all.Mesh.GetPoints(), mesh.GetPoints());
  EXPECT_EQ(GetCells(all.Mesh, all), GetCells(mesh, Values(mesh)));
  EXPECT_TRUE(VerifyFile(*file));
}

TEST(File, RestoresTheOriginalOrder)
{
  for (const auto& mesh : { MakeCubes(8, 0.3), MakeSoup(200, 3000), MakeSoup(4000, 900) })
  {
    const auto path = TempPath("ordered.gtn");
    WriterOptions options;
    options.ChunkSize = 256;
    options.Keep = KeepAll;
    Write(path, mesh, options);
    const auto file = std::make_shared<FileReader>(path);
    PieceDecoder decoder(file);
    const Piece all(decoder, AskForAll(*file));
    const Values values(mesh);
    EXPECT_EQ(all.Mesh.Coordinates, mesh.Coordinates);
    EXPECT_EQ(all.Mesh.Ids, mesh.Ids);
    EXPECT_EQ(all.Field, values.Field);
    EXPECT_EQ(all.Vector, values.Vector);
    EXPECT_EQ(all.Material, values.Material);
  }
}

TEST(File, PiecesTogetherAreTheWhole)
{
  const auto mesh = MakeCubes(10, 0.2);
  const auto path = TempPath("pieces.gtn");
  WriterOptions options;
  options.ChunkSize = 400;
  Write(path, mesh, options);
  const auto file = std::make_shared<FileReader>(path);
  const auto chunks = file->GetChunks().size();
  for (const std::size_t pieces : { std::size_t{ 1 }, std::size_t{ 3 }, chunks, chunks + 4 })
  {
    std::multiset<CellContent> cells;
    std::set<std::int64_t> ownedPoints, cellIds;
    for (std::size_t p = 0; p < pieces; ++p)
    {
      auto request = AskForAll(*file);
      request.Chunks.clear();
      for (auto c = p * chunks / pieces; c < (p + 1) * chunks / pieces; ++c)
      {
        request.Chunks.push_back(static_cast<std::uint32_t>(c));
      }
      PieceDecoder decoder(file);
      const Piece piece(decoder, request);
      cells.merge(GetCells(piece.Mesh, piece));
      for (std::size_t i = 0; i < piece.PointIds.size(); ++i)
      {
        if (piece.PointGhosts[i] == 0)
        {
          EXPECT_TRUE(ownedPoints.insert(piece.PointIds[i]).second) << "owned by two pieces";
        }
      }
      cellIds.insert(piece.CellIds.begin(), piece.CellIds.end());
    }
    EXPECT_EQ(cells, GetCells(mesh, Values(mesh)));
    EXPECT_EQ(ownedPoints.size(), mesh.GetPoints());
    EXPECT_EQ(cellIds.size(), mesh.GetTets());
  }
}

TEST(File, GhostsAreTheCellsAroundAPiece)
{
  const auto mesh = MakeCubes(9, 0.2);
  const auto path = TempPath("ghosts.gtn");
  WriterOptions options;
  options.ChunkSize = 350;
  options.Keep = KeepAll; // so that global ids are those of the input
  Write(path, mesh, options);
  const auto file = std::make_shared<FileReader>(path);
  for (unsigned levels = 1; levels <= 2; ++levels)
  {
    auto request = AskForAll(*file);
    request.Chunks = { 1, 2 };
    request.GhostLevels = levels;
    PieceDecoder decoder(file);
    const Piece piece(decoder, request);

    // Independent: grow the set of the piece's own cells over the input's connectivity.
    std::set<std::int64_t> own, expected;
    for (std::size_t t = 0; t < piece.CellIds.size(); ++t)
    {
      ASSERT_LE(piece.CellGhosts[t], 1);
      (piece.CellGhosts[t] == 0 ? own : expected).insert(piece.CellIds[t]);
    }
    EXPECT_EQ(own.size(), file->GetChunks()[1].Tets + file->GetChunks()[2].Tets);
    auto grown = own;
    for (unsigned level = 0; level < levels; ++level)
    {
      std::set<std::int64_t> points;
      for (const auto t : grown)
      {
        points.insert(&mesh.Ids[4 * static_cast<std::size_t>(t)],
          &mesh.Ids[4 * static_cast<std::size_t>(t)] + 4);
      }
      for (std::size_t t = 0; t < mesh.GetTets(); ++t)
      {
        if (std::any_of(&mesh.Ids[4 * t], &mesh.Ids[4 * t] + 4,
              [&](std::int64_t p) { return points.count(p) > 0; }))
        {
          grown.insert(static_cast<std::int64_t>(t));
        }
      }
    }
    std::set<std::int64_t> ghosts;
    std::set_difference(
      grown.begin(), grown.end(), own.begin(), own.end(), std::inserter(ghosts, ghosts.end()));
    EXPECT_EQ(ghosts, expected);
    // Ghosts carry their points and values like any other cell.
    for (std::size_t t = 0; t < piece.CellIds.size(); ++t)
    {
      std::set<std::int64_t> corners, wanted;
      for (std::size_t i = 0; i < 4; ++i)
      {
        const auto p = static_cast<std::size_t>(piece.Mesh.Ids[4 * t + i]);
        corners.insert(piece.PointIds[p]);
        wanted.insert(mesh.Ids[4 * static_cast<std::size_t>(piece.CellIds[t]) + i]);
        EXPECT_EQ(piece.Mesh.Coordinates[3 * p],
          mesh.Coordinates[3 * static_cast<std::size_t>(piece.PointIds[p])]);
      }
      EXPECT_EQ(corners, wanted);
    }
  }
}

TEST(File, PiecesOfAUniverseAreItsMesh)
{
  for (const auto& mesh : { MakeCubes(9, 0.2), MakeSoup(150, 2000) })
  {
    const auto path = TempPath("universe.gtn");
    WriterOptions options;
    options.ChunkSize = 150;
    Write(path, mesh, options);
    const auto file = std::make_shared<FileReader>(path);
    const auto chunks = static_cast<std::uint32_t>(file->GetChunks().size());
    ASSERT_GT(chunks, 10u);
    std::mt19937 random(3);
    PieceDecoder decoder(file);
    for (int round = 0; round < 12; ++round)
    {
      auto whole = AskForAll(*file);
      whole.WithUnusedPoints = false;
      whole.Chunks.clear();
      for (std::uint32_t c = 0; c < chunks; ++c)
      {
        if (random() % 3 == 0)
        {
          whole.Chunks.push_back(c);
        }
      }
      whole.Universe = whole.Chunks;
      const Piece all(decoder, whole);
      const std::set<std::int64_t> cellsOfAll(all.CellIds.begin(), all.CellIds.end());
      EXPECT_EQ(std::count(all.PointGhosts.begin(), all.PointGhosts.end(), 0),
        static_cast<std::ptrdiff_t>(all.PointGhosts.size()))
        << "a point without owner";

      const auto pieces = 1 + random() % 5;
      const unsigned levels = round % 3;
      std::multiset<std::int64_t> points, cells;
      for (std::size_t p = 0; p < pieces; ++p)
      {
        auto request = whole;
        request.GhostLevels = levels;
        const auto place = [&](std::size_t part) {
          return whole.Chunks.begin() +
            static_cast<std::ptrdiff_t>(part * whole.Chunks.size() / pieces);
        };
        request.Chunks.assign(place(p), place(p + 1));
        const Piece piece(decoder, request);
        for (std::size_t i = 0; i < piece.PointIds.size(); ++i)
        {
          ASSERT_LE(piece.PointGhosts[i], 1);
          if (piece.PointGhosts[i] == 0)
          {
            points.insert(piece.PointIds[i]);
          }
        }
        for (std::size_t t = 0; t < piece.CellIds.size(); ++t)
        {
          EXPECT_TRUE(cellsOfAll.count(piece.CellIds[t])) << "a ghost from outside";
          if (piece.CellGhosts[t] == 0)
          {
            cells.insert(piece.CellIds[t]);
          }
        }
      }
      EXPECT_EQ(points, std::multiset<std::int64_t>(all.PointIds.begin(), all.PointIds.end()));
      EXPECT_EQ(cells, std::multiset<std::int64_t>(all.CellIds.begin(), all.CellIds.end()));
    }
    PieceRequest outside;
    outside.Universe = { 0, 1, 2 };
    outside.Chunks = { 2, 3 };
    EXPECT_THROW(decoder.SetRequest(outside), Error);
    outside.Universe = { 2, 1, 3 };
    EXPECT_THROW(decoder.SetRequest(outside), Error);
  }
}

TEST(File, EveryTimeStepIsReachedInAnyOrder)
{
  const auto mesh = MakeCubes(7, 0.2);
  const auto path = TempPath("steps.gtn");
  WriterOptions options;
  options.ChunkSize = 500;
  options.Keep = KeepAll;
  options.KeyStepInterval = 4;
  Write(path, mesh, options, 11);
  const auto file = std::make_shared<FileReader>(path);
  ASSERT_EQ(file->GetNumberOfSteps(), 11u);
  PieceDecoder decoder(file);
  for (const std::size_t step : { 0, 1, 2, 10, 9, 3, 3, 7, 8, 4, 0 })
  {
    auto request = AskForAll(*file);
    request.Step = step;
    const Piece all(decoder, request);
    const Values values(mesh, 0.25 * static_cast<double>(step));
    EXPECT_EQ(all.Field, values.Field) << "step " << step;
    EXPECT_EQ(all.Vector, values.Vector) << "step " << step;
    EXPECT_EQ(all.Mesh.Ids, mesh.Ids);
  }
  EXPECT_TRUE(VerifyFile(*file));
}

TEST(File, HoldsEmptyMeshesAndUnusedPoints)
{
  TestMesh mesh = MakeCubes(2, 0.1);
  const auto points = mesh.GetPoints();
  mesh.Coordinates.insert(mesh.Coordinates.end(), { 9, 8, 7, std::nan(""), -0.0, INFINITY });
  for (const bool withCells : { true, false })
  {
    if (!withCells)
    {
      mesh.Ids.clear();
    }
    const auto path = TempPath("unused.gtn");
    Write(path, mesh, {});
    const auto file = std::make_shared<FileReader>(path);
    EXPECT_EQ(file->GetNumberOfUnusedPoints(), withCells ? 2u : points + 2u);
    PieceDecoder decoder(file);
    const Piece all(decoder, AskForAll(*file));
    ASSERT_EQ(all.Mesh.GetPoints(), mesh.GetPoints());
    EXPECT_EQ(std::memcmp(&all.Mesh.Coordinates[3 * points], &mesh.Coordinates[3 * points],
                6 * sizeof(double)),
      0);
  }
  const TestMesh empty;
  Write(TempPath("empty.gtn"), empty, {});
  const FileReader file(TempPath("empty.gtn"));
  EXPECT_EQ(file.GetNumberOfTets(), 0u);
  EXPECT_EQ(file.GetNumberOfPoints(), 0u);
  EXPECT_TRUE(VerifyFile(file));
}

TEST(File, RefusesATetrahedronWithAnUnknownPoint)
{
  for (const std::int64_t wrong : { std::int64_t{ 27 }, std::int64_t{ -1 } })
  {
    auto mesh = MakeCubes(2, 0);
    mesh.Ids[17] = wrong;
    try
    {
      Write(TempPath("wrong.gtn"), mesh, {});
      FAIL() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
      EXPECT_NE(std::string(error.what()).find("cell 4 uses point " + std::to_string(wrong)),
        std::string::npos)
        << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(TempPath("wrong.gtn")));
  }
}

TEST(File, AbortLeavesTheOldFile)
{
  const auto path = TempPath("old.gtn");
  Write(path, MakeCubes(2, 0), {});
  const auto size = std::filesystem::file_size(path);
  const auto mesh = MakeCubes(8, 0.1);
  WriterOptions options;
  options.ChunkSize = 64;
  EXPECT_THROW(FileWriter(path, mesh.GetInput(), {}, options, [](double) { return false; }), Error);
  EXPECT_EQ(std::filesystem::file_size(path), size);
  for (const auto& entry : std::filesystem::directory_iterator(GATUN_TEST_TEMP))
  {
    EXPECT_EQ(entry.path().string().find("old.gtn.part"), std::string::npos);
  }
}

/** Decodes a whole file. Defects must be reported as an Error that names the file. */
bool ReadsOrExplains(const std::string& path, const Piece& right)
{
  try
  {
    const auto file = std::make_shared<FileReader>(path);
    PieceDecoder decoder(file);
    if (file->GetArrays().size() != 3 || file->GetNumberOfSteps() < 1)
    {
      ADD_FAILURE() << "other arrays without an error";
      return false;
    }
    const Piece all(decoder, AskForAll(*file));
    EXPECT_EQ(all.Mesh.Ids, right.Mesh.Ids);
    EXPECT_EQ(all.Field, right.Field);
    EXPECT_EQ(all.Mesh.Coordinates, right.Mesh.Coordinates);
    return true;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(std::string(error.what()).find(path), 0u) << error.what();
    return false;
  }
}

TEST(File, DetectsEveryTruncationAndEveryFlippedByte)
{
  const auto mesh = MakeCubes(3, 0.2);
  const auto path = TempPath("damage.gtn");
  WriterOptions options;
  options.ChunkSize = 64;
  options.Keep = KeepAll;
  Write(path, mesh, options);
  std::ifstream in(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const auto file = std::make_shared<FileReader>(path);
  PieceDecoder decoder(file);
  const Piece right(decoder, AskForAll(*file));

  const auto damaged = TempPath("damaged.gtn");
  const auto put = [&](const std::string& content)
  { std::ofstream(damaged, std::ios::binary | std::ios::trunc) << content; };
  for (std::size_t length = 0; length < bytes.size(); ++length)
  {
    put(bytes.substr(0, length));
    EXPECT_FALSE(ReadsOrExplains(damaged, right)) << "truncated to " << length;
  }
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    auto flipped = bytes;
    flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 8)));
    put(flipped);
    accepted += ReadsOrExplains(damaged, right);
    EXPECT_THROW(VerifyFile(FileReader(damaged)), Error) << "flipped byte " << i;
  }
  // Reading never looks at the 24-byte headers of sections, which the directory repeats, so flips
  // there are harmless: the data came out right.
  EXPECT_LT(accepted, 24 * 12u);
}
}
