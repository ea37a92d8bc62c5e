// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Time steps that are added to a file.

#include "gatunError.h"
#include "gatunHostile.h"
#include "gatunTestFile.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

namespace
{
using namespace gatun;
using namespace gatun::test;

std::string ReadBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

std::string WriteThree(const TestMesh& mesh)
{
  auto path = GetPath("append.gtn");
  WriterOptions options;
  options.Keep = KeepAll;
  options.ChunkSize = 200;
  Write(path, mesh, options, 3);
  return path;
}

void AddStep(const std::string& path, const TestMesh& mesh, int step)
{
  FileWriter writer(FileWriter::Append(), path);
  writer.AddMesh(mesh.GetInput(), {});
  const Values values(mesh, 0.25 * step);
  writer.WriteStep(values.Get(), {}, true, step);
  writer.Finish();
}

/** The cells of a file at a step. */
std::multiset<CellContent> CellsOf(const std::string& path, std::size_t step)
{
  const auto file = std::make_shared<const FileReader>(path);
  const auto& series = file->GetSeries();
  const std::size_t mesh = series.empty() ? 0 : series[step].Mesh;
  const auto other = mesh > 0 ? file->OpenMesh(mesh) : file;
  const auto& times = other->GetTimes();
  PieceRequest request = AskForAll(*other);
  request.Step = static_cast<std::size_t>(
    std::find(times.begin(), times.end(), static_cast<double>(step)) - times.begin());
  PieceDecoder decoder(other);
  const Piece piece(decoder, request);
  return GetCells(piece.Mesh, piece);
}

TEST(Append, StepsComeBackAndTheMeshIsStoredOnce)
{
  const auto mesh = MakeCubes(7, 0.2);
  const auto path = WriteThree(mesh);
  const auto before = ReadBytes(path);
  AddStep(path, mesh, 3);
  const auto once = std::filesystem::file_size(path);
  AddStep(path, mesh, 4);
  AddStep(path, mesh, 5);
  const FileReader file(path);
  EXPECT_EQ(file.GetSeriesTimes(), (std::vector<double>{ 0, 1, 2, 3, 4, 5 }));
  EXPECT_TRUE(VerifyFile(file, {}));
  for (int step = 0; step < 6; ++step)
  {
    EXPECT_EQ(
      CellsOf(path, static_cast<std::size_t>(step)), GetCells(mesh, Values(mesh, 0.25 * step)));
  }
  const auto after = ReadBytes(path);
  const std::size_t same = before.size() / 2; // the end has the directory
  EXPECT_EQ(after.substr(0, same), before.substr(0, same));
  const auto statistics = file.GetStatistics();
  const auto meshBytes = statistics.ConnectivityBytes + statistics.GeometryBytes +
    statistics.SharedGeometryBytes + statistics.OrderBytes;
  const auto one = GetPath("one.gtn");
  WriterOptions options;
  options.Keep = KeepAll;
  options.ChunkSize = 200;
  Write(one, mesh, options);
  EXPECT_LT(once - before.size() + 2 * meshBytes / 3, std::filesystem::file_size(one));
}

TEST(Append, OtherMeshesAreStoredOnceToo)
{
  const auto path = WriteThree(MakeCubes(6, 0.2));
  const auto other = MakeCubes(7, 0.1);
  AddStep(path, other, 3);
  const auto once = std::filesystem::file_size(path);
  AddStep(path, other, 4);
  const auto twice = std::filesystem::file_size(path);
  EXPECT_LT(2 * (twice - once), once);
  EXPECT_EQ(CellsOf(path, 4), GetCells(other, Values(other, 1)));
  EXPECT_TRUE(VerifyFile(FileReader(path), {}));
}

TEST(Append, AFileThatChangesMeanwhileIsKept)
{
  const auto mesh = MakeCubes(5, 0.2);
  const auto path = WriteThree(mesh);
  FileWriter late(FileWriter::Append(), path);
  late.AddMesh(mesh.GetInput(), {});
  late.WriteStep(Values(mesh, 9).Get(), {}, true, 9);
  AddStep(path, mesh, 3);
  const auto kept = ReadBytes(path);
  EXPECT_THROW(late.Finish(), Error);
  EXPECT_EQ(ReadBytes(path), kept);
}

TEST(Append, WhatDoesNotFitIsRefused)
{
  const auto mesh = MakeCubes(5, 0.2);
  const auto path = WriteThree(mesh);
  const auto kept = ReadBytes(path);
  const Values values(mesh);
  EXPECT_THROW(AddStep(path, mesh, 2), Error);
  {
    FileWriter writer(FileWriter::Append(), path);
    EXPECT_THROW(writer.WriteStep(values.Get(), {}, true, 3), Error); // no mesh
  }
  {
    FileWriter writer(FileWriter::Append(), path);
    writer.AddMesh(mesh.GetInput(), {});
    EXPECT_THROW(writer.UseMesh(0), Error);
  }
  {
    FileWriter writer(FileWriter::Append(), path);
    WriterOptions surface;
    surface.IsSurface = true;
    EXPECT_THROW(writer.AddMesh(mesh.GetInput(), surface), Error);
  }
  EXPECT_EQ(ReadBytes(path), kept);

  const auto timeless = GetPath("timeless.gtn");
  Write(timeless, mesh, {});
  EXPECT_THROW(FileWriter(FileWriter::Append(), timeless), Error);
  EXPECT_THROW(FileWriter(FileWriter::Append(), GetPath("missing.gtn")), Error);
}

// Any wrong byte is found, whether it is in a section that is copied or not.
TEST(Append, DamagedFilesAreNotCopied)
{
  const auto mesh = MakeCubes(2, 0.2);
  const auto path = WriteThree(mesh);
  const auto good = ReadBytes(path);
  for (std::size_t i = 0; i < good.size(); i += 7)
  {
    auto bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 1);
    std::ofstream(path, std::ios::binary) << bad;
    try
    {
      AddStep(path, mesh, 3);
      EXPECT_TRUE(VerifyFile(FileReader(path), {})) << i; // the header of a section is written anew
    }
    catch (const Error&)
    {
      EXPECT_EQ(ReadBytes(path), bad);
    }
  }
}
}
