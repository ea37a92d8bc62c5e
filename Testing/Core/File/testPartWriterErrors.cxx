// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Parts that do not fit together, disks without room, and little memory: an error with a clear
// message, and no file that remains.

#include "../gatunSanitizer.h"
#include "gatunFileSizeLimit.h"
#include "gatunHostile.h"
#include "gatunMeshParts.h"
#include "gatunParallel.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <new>

#include <sys/resource.h>
#include <unistd.h>

namespace
{
using namespace gatun;
using namespace gatun::test;

class PartWriterErrors : public ::testing::Test
{
protected:
  const PartMesh Mesh = MakePartMesh(MakeCubes(4, 0.2));
  const std::vector<PartMesh> Parts = Divide(Mesh, 3, DealSlabs(Mesh, 3, 4));
  const std::string Path = GetPath("parts.gtn");

  void Refuse(const std::string& what, const std::function<void(PartWriter&)>& use,
    const PartWriterOptions& options = {})
  {
    PutFile("parts.gtn", { 1, 2, 3 });
    try
    {
      PartWriter writer(this->Path, PartMesh::Describe(), options);
      use(writer);
      ADD_FAILURE() << "no error, but expected: " << what;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
    EXPECT_EQ(ReadBytes(this->Path), "\1\2\3");
    EXPECT_EQ(ListFolder(this->Path), (std::vector<std::string>{ "parts.gtn" }));
  }

  static void SurveyStep(PartWriter& writer, const PartMesh& part)
  {
    writer.SurveyStep(PartValues(part, 0).Get());
  }

  void SurveyAll(PartWriter& writer) const
  {
    for (const auto& part : this->Parts)
    {
      writer.Survey(part.GetInput());
      SurveyStep(writer, part);
    }
  }
};

TEST_F(PartWriterErrors, CallsOutOfOrder)
{
  this->Refuse("not all parts", [](PartWriter& writer) { writer.Finish(); });
  this->Refuse("not all parts",
    [&](PartWriter& writer)
    {
      this->SurveyAll(writer);
      writer.Finish();
    });
  this->Refuse(
    "no part to survey", [&](PartWriter& writer) { SurveyStep(writer, this->Parts[0]); });
  this->Refuse("no part is being written",
    [&](PartWriter& writer) { writer.WriteStep(PartValues(this->Parts[0], 0).Get()); });
  this->Refuse("before the first one is written",
    [&](PartWriter& writer)
    {
      this->SurveyAll(writer);
      writer.Write(this->Parts[0].GetInput());
      writer.Survey(this->Parts[0].GetInput());
    });
  this->Refuse("fewer time steps",
    [&](PartWriter& writer)
    {
      this->SurveyAll(writer);
      writer.Write(this->Parts[0].GetInput());
      writer.Write(this->Parts[1].GetInput());
    });
  this->Refuse("all of its surveyed time steps have been written",
    [&](PartWriter& writer)
    {
      this->SurveyAll(writer);
      writer.Write(this->Parts[0].GetInput());
      writer.WriteStep(PartValues(this->Parts[0], 0).Get());
      writer.WriteStep(PartValues(this->Parts[0], 0).Get());
    });
  this->Refuse("more parts are to be written",
    [&](PartWriter& writer)
    {
      writer.Survey(this->Parts[0].GetInput());
      writer.Write(this->Parts[0].GetInput());
      writer.Write(this->Parts[1].GetInput());
    });
}

TEST_F(PartWriterErrors, PartsThatChange)
{
  const auto write = [&](PartWriter& writer, PartMesh second)
  {
    this->SurveyAll(writer);
    writer.Write(this->Parts[0].GetInput());
    writer.WriteStep(PartValues(this->Parts[0], 0).Get());
    writer.Write(second.GetInput());
    second.Bias = [](const double* x) { return x[0] > 3.9 ? 1e-9 : 0; };
    writer.WriteStep(PartValues(second, 0).Get());
  };
  auto changed = this->Parts[1];
  this->Refuse(
    "the values of part 1 have changed", [&](PartWriter& writer) { write(writer, changed); });
  this->Refuse("part 1 has changed", [&](PartWriter& writer) { write(writer, this->Parts[2]); });
  changed.Cells.Coordinates[5] += 1e-9;
  this->Refuse("part 1 has changed", [&](PartWriter& writer) { write(writer, changed); });
  changed = this->Parts[1];
  std::swap(changed.Cells.Ids[0], changed.Cells.Ids[1]);
  this->Refuse("part 1 has changed", [&](PartWriter& writer) { write(writer, changed); });
}

TEST_F(PartWriterErrors, PartsThatDisagree)
{
  this->Refuse("some parts have global ids",
    [&](PartWriter& writer)
    {
      writer.Survey(this->Parts[0].GetInput(), this->Parts[0].PointIds.data());
      writer.Survey(this->Parts[1].GetInput());
    });
  this->Refuse("different types",
    [&](PartWriter& writer)
    {
      writer.Survey(this->Parts[0].GetInput());
      auto input = this->Parts[1].GetInput();
      const std::vector<float> coordinates(3 * this->Parts[1].GetPoints(), 1);
      input.Coordinates = coordinates.data();
      input.CoordinateType = ScalarType::Float32;
      writer.Survey(input);
    });
  this->Refuse("different numbers of time steps",
    [&](PartWriter& writer)
    {
      this->SurveyAll(writer);
      writer.Survey(this->Parts[0].GetInput());
      writer.Write(this->Parts[0].GetInput());
    });
  this->Refuse("different times",
    [&](PartWriter& writer)
    {
      this->SurveyAll(writer);
      writer.Write(this->Parts[0].GetInput());
      writer.WriteStep(PartValues(this->Parts[0], 0).Get(), {}, true, 1);
      writer.Write(this->Parts[1].GetInput());
      writer.WriteStep(PartValues(this->Parts[1], 0).Get(), {}, true, 2);
    });
  this->Refuse("the values of every array",
    [&](PartWriter& writer)
    {
      writer.Survey(this->Parts[0].GetInput());
      const PartValues values(this->Parts[0], 0);
      const auto all = values.Get();
      writer.SurveyStep(std::span(all).first(2));
    });
  this->Refuse("uses point",
    [&](PartWriter& writer)
    {
      auto part = this->Parts[0];
      part.Cells.Ids[7] = 100000;
      writer.Survey(part.GetInput());
    });
}

TEST_F(PartWriterErrors, WhatNeedsTheWholeMesh)
{
  PartWriterOptions options;
  options.File.Layers.emplace();
  this->Refuse(
    "layers need the whole mesh", [](PartWriter&) {}, options);
  options = {};
  const MergeTree tree;
  options.File.Tree = &tree;
  this->Refuse(
    "cannot be given", [](PartWriter&) {}, options);
  options = {};
  options.File.Levels = 1;
  this->Refuse(
    "base meshes need a hierarchy", [](PartWriter&) {}, options);
}

TEST_F(PartWriterErrors, AnAbortLeavesNothing)
{
  for (const bool first : { true, false })
  {
    try
    {
      PartWriter writer(this->Path, PartMesh::Describe(), {});
      const auto refuse = [](double) { return false; };
      writer.Survey(
        this->Parts[0].GetInput(), nullptr, first ? PartWriter::Progress(refuse) : nullptr);
      writer.Write(this->Parts[0].GetInput(), nullptr, refuse);
      ADD_FAILURE() << "not aborted";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Aborted);
    }
    EXPECT_TRUE(ListFolder(this->Path).empty());
  }
}

TEST_F(PartWriterErrors, TemporaryFiles)
{
  PartWriterOptions options;
  options.SpillMemory = 0;
  const auto folder = std::filesystem::path(this->Path).parent_path().string();
  {
    const FileSizeLimit full(6000);
    EXPECT_GATUN_SYSTEM_ERROR(
      ErrorCode::CannotWrite, folder, EFBIG, [&] { WriteParts(this->Path, this->Parts, options); });
  }
  EXPECT_TRUE(ListFolder(this->Path).empty());
  EXPECT_GT(WriteParts(this->Path, this->Parts, options).SpilledBytes, 6000u);
  EXPECT_EQ(ListFolder(this->Path).size(), 1u);
}

TEST_F(PartWriterErrors, AFullDiskLeavesNoFile)
{
  const FileSizeLimit full(2000);
  EXPECT_GATUN_SYSTEM_ERROR(
    ErrorCode::CannotWrite, this->Path, EFBIG, [&] { WriteParts(this->Path, this->Parts); });
  EXPECT_TRUE(ListFolder(this->Path).empty());
}

//------------------------------------------------------------------------------
// Memory

std::size_t GetAddressSpace()
{
  std::ifstream in("/proc/self/statm");
  std::size_t pages = 0;
  in >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/** One of many cubes in a row. */
PartMesh MakeSlice(std::int64_t n, std::size_t slice)
{
  auto mesh = MakePartMesh(MakeCubes(n, 0));
  for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
  {
    mesh.Cells.Coordinates[3 * p] += static_cast<double>(slice) * static_cast<double>(n);
  }
  return mesh;
}

/** Writes slices with little memory. The exit code is 0 unless memory ran out. */
void WriteSlices(const std::string& path, std::size_t slices, std::size_t bytes)
{
  constexpr std::int64_t n = 14;
  SetNumberOfThreads(1);
  const auto limit = GetAddressSpace() + bytes;
  const ::rlimit memory{ limit, limit };
  ::setrlimit(RLIMIT_AS, &memory);
  try
  {
    PartWriterOptions options;
    options.SpillMemory = 1 << 20;
    PartWriter writer(path, PartMesh::Describe(), options);
    for (const bool survey : { true, false })
    {
      for (std::size_t slice = 0; slice < slices; ++slice)
      {
        const auto mesh = MakeSlice(n, slice);
        const PartValues values(mesh, 0);
        if (survey)
        {
          writer.Survey(mesh.GetInput());
          writer.SurveyStep(values.Get());
        }
        else
        {
          writer.Write(mesh.GetInput());
          writer.WriteStep(values.Get());
        }
      }
    }
    std::cerr << writer.Finish().Points << " points" << std::endl;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    std::_Exit(1);
  }
  std::_Exit(0);
}

TEST_F(PartWriterErrors, MemoryDoesNotGrowWithTheParts)
{
#ifdef GATUN_HAS_SANITIZER
  GTEST_SKIP() << "sanitizers need address space of their own";
#endif
  ::testing::FLAGS_gtest_death_test_style = "fast";
  constexpr std::size_t bytes = std::size_t{ 48 } << 20;
  EXPECT_EXIT(WriteSlices(this->Path, 1, bytes), ::testing::ExitedWithCode(0), "3375 points");
  // 200 parts of 16,464 tetrahedra would take more than 100 MB as a whole.
  EXPECT_EXIT(WriteSlices(this->Path, 200, bytes), ::testing::ExitedWithCode(0), "630225 points");
}
}
