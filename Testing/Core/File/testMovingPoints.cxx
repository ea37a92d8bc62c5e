// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Points that move with time.

#include "gatunChunkCache.h"
#include "gatunFileSurface.h"
#include "gatunHostile.h"
#include "gatunPartWriter.h"
#include "gatunTestFile.h"
#include "gatunVerifyFile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr std::size_t Steps = 21;

/** Whether the points are where they were at the step before: twice in a row, at a key step, and at
 * all steps from 13 on, which includes more key steps. */
bool StandsStill(std::size_t step)
{
  return step == 3 || step == 4 || step == 8 || step >= 13;
}

/** The mesh at a step: turned and bent, with some values that are no numbers. */
TestMesh Move(const TestMesh& mesh, std::size_t step)
{
  while (StandsStill(step))
  {
    --step;
  }
  TestMesh moved = mesh;
  const double t = 0.05 * static_cast<double>(step);
  for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
  {
    double* x = &moved.Coordinates[3 * p];
    const double y = x[1];
    x[0] += t * std::sin(y);
    x[1] = y * std::cos(t) - x[2] * std::sin(t);
    x[2] = y * std::sin(t) + x[2] * std::cos(t);
  }
  if (step > 0)
  {
    moved.Coordinates[3 * step] = std::nan("");
    moved.Coordinates[3 * step + 1] = -0.0;
    moved.Coordinates[3 * step + 2] = std::numeric_limits<double>::infinity();
  }
  return moved;
}

TestMesh MakeMesh()
{
  auto mesh = MakeCubes(7, 0.2);
  mesh.Coordinates.insert(mesh.Coordinates.end(), { 9.5, -3.25, 1.125, 4, 5, 6 }); // unused
  return mesh;
}

std::string WriteMoving(const TestMesh& mesh, WriterOptions options = {})
{
  auto path = GetPath("moving.gtn");
  options.ChunkSize = 200;
  options.Keep = KeepAll;
  options.KeyStepInterval = 5;
  options.PointsMove = true;
  FileWriter writer(path, mesh.GetInput(), Values::Describe(), options);
  for (std::size_t step = 0; step < Steps; ++step)
  {
    const auto moved = Move(mesh, step);
    const Values values(mesh, 0.25 * static_cast<double>(step));
    writer.WriteStep(
      values.Get(), {}, true, static_cast<double>(step), {}, moved.Coordinates.data());
  }
  writer.Finish();
  return path;
}

bool HaveSameBits(double one, double other)
{
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

/** Bit by bit. */
bool AreSame(const std::vector<double>& one, const std::vector<double>& other)
{
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), HaveSameBits);
}

/** Throws unless the file has the points, the cells and the values of a step. */
void ExpectStep(PieceDecoder& decoder, const TestMesh& mesh, std::size_t step)
{
  auto request = AskForAll(*decoder.GetFile());
  request.Step = step;
  request.RestoreOrder = true;
  const Piece piece(decoder, request);
  EXPECT_TRUE(AreSame(piece.Mesh.Coordinates, Move(mesh, step).Coordinates)) << step;
  EXPECT_EQ(piece.Mesh.Ids, mesh.Ids) << step;
  EXPECT_EQ(piece.Vector, Values(mesh, 0.25 * static_cast<double>(step)).Vector) << step;
}

TEST(MovingPoints, AreReadAtAllStepsInAnyOrder)
{
  const auto mesh = MakeMesh();
  const auto file = std::make_shared<const FileReader>(WriteMoving(mesh));
  ASSERT_GT(file->GetChunks().size(), 5u);
  EXPECT_TRUE(file->HasMovingPoints());
  EXPECT_EQ(file->GetArrays(), Values::Describe());
  EXPECT_EQ(file->GetStatistics().ArrayBytes.size(), 3u);
  EXPECT_TRUE(VerifyFile(*file));
  PieceDecoder decoder(file);
  for (const std::size_t step : { 0, 1, 2, 3, 4, 5, 6, 20, 7, 8, 9, 19, 12, 2, 13, 0, 11, 20, 4 })
  {
    ExpectStep(decoder, mesh, step);
    // Alone, without a cache.
    PieceDecoder other(std::make_shared<ChunkCache>(file, 0));
    ExpectStep(other, mesh, step);
  }
}

TEST(MovingPoints, HaveBoundsAtEachStep)
{
  const auto mesh = MakeMesh();
  const FileReader file(WriteMoving(mesh));
  for (std::size_t step = 0; step < Steps; ++step)
  {
    const auto moved = Move(mesh, step);
    Bounds all;
    for (std::size_t i = 0; i < moved.Coordinates.size(); ++i)
    {
      if (std::isfinite(moved.Coordinates[i]))
      {
        all[i % 3].Include(moved.Coordinates[i]);
      }
    }
    EXPECT_EQ(file.GetBounds(step), all) << step;
    Bounds chunks;
    for (std::size_t chunk = 0; chunk < file.GetChunks().size(); ++chunk)
    {
      chunks.Include(file.GetChunkBounds(chunk, 0, step));
    }
    for (const std::size_t i : { mesh.GetPoints() - 2, mesh.GetPoints() - 1 }) // unused
    {
      chunks.Include(std::array{
        moved.Coordinates[3 * i], moved.Coordinates[3 * i + 1], moved.Coordinates[3 * i + 2] });
    }
    EXPECT_EQ(chunks, all) << step;
  }
}

TEST(MovingPoints, CostNothingWhileTheyStandStill)
{
  const auto mesh = MakeMesh();
  const auto size = [&](std::size_t steps, bool moves)
  {
    const auto path = GetPath("still.gtn");
    WriterOptions options;
    options.PointsMove = moves;
    FileWriter writer(path, mesh.GetInput(), {}, options);
    for (std::size_t step = 0; step < steps; ++step)
    {
      const auto moved = Move(mesh, step > 0 && moves ? 1 : 0);
      writer.WriteStep({}, {}, true, static_cast<double>(step), {}, moved.Coordinates.data());
    }
    return writer.Finish();
  };
  EXPECT_EQ(size(20, true).MotionBytes, size(2, true).MotionBytes);
  EXPECT_GT(size(2, true).MotionBytes, 0u);
  EXPECT_LT(size(20, true).FileBytes, size(2, true).FileBytes + 18 * 128);
  // Points that could move cost little if they do not.
  EXPECT_LT(size(2, false).FileBytes, size(2, true).FileBytes);
}

TEST(MovingPoints, AreInPiecesWithGhosts)
{
  const auto mesh = MakeMesh();
  const auto file = std::make_shared<const FileReader>(WriteMoving(mesh));
  const auto cache = std::make_shared<ChunkCache>(file);
  for (const std::size_t step : { 12, 0, 6, 14 })
  {
    const auto moved = Move(mesh, step);
    for (std::uint32_t chunk = 0; chunk < file->GetChunks().size(); chunk += 3)
    {
      PieceDecoder decoder(cache);
      PieceRequest request;
      request.Chunks = { chunk };
      request.Arrays = { 0, 1, 2 };
      request.Step = step;
      request.GhostLevels = 1;
      const Piece piece(decoder, request);
      ASSERT_GT(piece.Mesh.GetTets(), file->GetChunks()[chunk].Cells);
      for (std::size_t p = 0; p < piece.PointIds.size(); ++p)
      {
        const double* const found = &piece.Mesh.Coordinates[3 * p];
        const double* const right =
          &moved.Coordinates[3 * static_cast<std::size_t>(piece.PointIds[p])];
        ASSERT_TRUE(std::equal(found, found + 3, right, HaveSameBits))
          << step << " " << chunk << " " << p;
      }
    }
  }
}

TEST(MovingPoints, AreContoured)
{
  const auto mesh = MakeMesh();
  const auto file = std::make_shared<const FileReader>(WriteMoving(mesh));
  // The same at one time only, as a mesh of its own.
  for (const std::size_t step : { 0, 12, 3, 20 })
  {
    const auto moved = Move(mesh, step);
    const auto path = GetPath("alone.gtn");
    {
      WriterOptions options;
      options.ChunkSize = 200;
      FileWriter writer(path, moved.GetInput(), Values::Describe(), options);
      writer.WriteStep(Values(mesh, 0.25 * static_cast<double>(step)).Get());
      writer.Finish();
    }
    FileSurfaceRequest request;
    request.Array = 0;
    request.Component = 0;
    request.Options.Values = { 1.5 };
    request.Options.CoordinateType = ScalarType::Float64;
    FileSurface alone(std::make_shared<const FileReader>(path));
    const auto expected = alone.Extract(request);
    FileSurface surface(file);
    request.Step = step;
    const auto found = surface.Extract(request);
    // In another order.
    const auto sum = [](const Surface& s)
    {
      std::vector<double> x(3 * s.GetNumberOfPoints());
      s.FillPoints(x.data());
      double all = 0;
      for (const double value : x)
      {
        all += std::isfinite(value) ? std::abs(value) : 0;
      }
      return all;
    };
    ASSERT_GT(found.GetNumberOfPoints(), 0u);
    EXPECT_EQ(found.GetNumberOfPoints(), expected.GetNumberOfPoints()) << step;
    EXPECT_NEAR(sum(found), sum(expected), 1e-9 * sum(expected)) << step;
  }
}

TEST(MovingPoints, AreRefusedWhereTheyCannotBe)
{
  const auto mesh = MakeMesh();
  const auto path = GetPath("refused.gtn");
  WriterOptions options;
  options.PointsMove = true;
  const Values values(mesh);
  const auto moved = Move(mesh, 1);
  const auto expect = [](const char* what, auto&& run)
  {
    try
    {
      run();
      ADD_FAILURE() << what;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  expect("not those of the mesh",
    [&]
    {
      FileWriter writer(path, mesh.GetInput(), Values::Describe(), options);
      writer.WriteStep(values.Get(), {}, true, 0, {}, moved.Coordinates.data());
    });
  expect("in a file with time",
    [&]
    {
      FileWriter writer(path, mesh.GetInput(), Values::Describe(), options);
      writer.WriteStep(values.Get());
    });
  expect("cannot be written in parts",
    [&]
    {
      PartWriterOptions parts;
      parts.File = options;
      PartWriter writer(path, Values::Describe(), parts);
      writer.Survey(mesh.GetInput(), nullptr);
    });
}

//------------------------------------------------------------------------------
/** Bytes of a step's table: time, key, field data (none), and then whether it has coordinates. */
constexpr std::size_t MoveFlag = 10;

TEST(MovingPoints, AreRefusedIfDamaged)
{
  const FileImage image(WriteMoving(MakeMesh()));
  ReadAll(PutFile("same.gtn", image.Build()));
  const auto expect = [&](const char* what, auto&& change)
  {
    auto damaged = image;
    change(damaged);
    const auto path = PutFile("damaged.gtn", damaged.Build());
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, what,
      [&]
      {
        ReadAll(path);
        VerifyFile(FileReader(path));
      });
  };
  const auto setFlag = [](std::size_t step, std::uint8_t flag)
  {
    return [=](FileImage& damaged)
    {
      damaged.ChangeTable = [=](FourCC name, std::size_t number, Bytes& table)
      {
        if (name == SectionStep && number == step)
        {
          table[MoveFlag] = flag;
        }
      };
    };
  };
  expect("no coordinates", setFlag(0, 0));
  expect("no coordinates", setFlag(1, 2));
  expect("table of a time step", setFlag(1, 0)); // with bytes behind the end
  expect("table of a time step", setFlag(3, 1)); // too short
  expect("has no time", [](FileImage& damaged) { damaged.Meta.HasTime = false; });
  expect("coordinates have a palette",
    [](FileImage& damaged)
    {
      auto& palette = damaged.Steps[1].Arrays.back().Palettes[0];
      palette.Count = 2;
      damaged.Set(palette.Stream, Bytes(9, 1));
    });
  expect("copied from one that is not there",
    [](FileImage& damaged)
    {
      for (std::uint32_t c = 0; c < 3; ++c)
      {
        auto& palette = damaged.Steps[1].Arrays[1].Palettes[c];
        palette = {};
        palette.SourceArray = 3;
        palette.SourceComponent = c;
      }
    });
  expect("not on its scale",
    [](FileImage& damaged)
    {
      // The mesh does not have so few bits.
      damaged.Steps[1].Arrays.back().Palettes[1].Steps = { ScaleKind::Shift, 50, 0 };
    });
  expect("array 'coordinates' of chunk",
    [](FileImage& damaged)
    {
      auto& stream = damaged.Steps.back().Arrays.back().Chunks[0];
      damaged.Of(damaged.Steps[12].Arrays.back().Chunks[0]) = { 9, 9, 9, 9 };
      stream = damaged.Steps[12].Arrays.back().Chunks[0];
    });
}
}
