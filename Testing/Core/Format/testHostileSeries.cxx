// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of several meshes: what is written, and files with valid checksums and invalid series.

#include "gatunHostile.h"
#include "gatunSeriesTable.h"
#include "gatunSharedFile.h"
#include "gatunTableParts.h"
#include "gatunVerifyFile.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** The sample with three steps, and another mesh with three steps between and behind them. */
struct SeriesImage
{
  SeriesImage()
    : File(MakeImage())
    , Other(this->File)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->File.Steps[i].Time = static_cast<double>(2 * i);
      this->Other.Steps[i].Time = static_cast<double>(2 * i + 1);
      this->Table.push_back({ 0, this->File.Steps[i].Time });
      this->Table.push_back({ 1, this->Other.Steps[i].Time });
    }
  }

  Bytes Build() const
  {
    auto file = this->File;
    for (std::size_t i = 0; i < this->Others; ++i)
    {
      file.MoreSections.push_back({ SectionGrid, this->Other.Build(), SectionVersion, 0 });
    }
    if (this->HasTable)
    {
      file.MoreSections.push_back(
        { SectionTime, this->Stored ? Store(*this->Stored) : WriteSeries(this->Table) });
    }
    return file.Build();
  }

  FileImage File;
  FileImage Other;
  std::size_t Others = 1;
  bool HasTable = true;
  std::vector<SeriesStep> Table;
  std::optional<Bytes> Stored; // written in place of the table
};

/** Opening the file, or a mesh of it, fails. */
void ExpectRefused(
  const std::string& what, const std::function<void(SeriesImage&)>& change, std::size_t mesh = 0)
{
  SeriesImage image;
  change(image);
  const auto path = PutFile("changed.gtn", image.Build());
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt,
    mesh > 0 ? path + ", mesh " + std::to_string(mesh + 1) : path, what,
    [&]
    {
      const FileReader file(path);
      if (mesh > 0)
      {
        file.OpenMesh(mesh);
      }
    });
}

TEST(HostileSeries, TheUnchangedFileIsRead)
{
  const SeriesImage image;
  const auto path = PutFile("same.gtn", image.Build());
  const FileReader file(path);
  EXPECT_TRUE(VerifyFile(file));
  EXPECT_EQ(file.GetNumberOfMeshes(), 2u);
  EXPECT_EQ(file.GetSeries(), image.Table);
  EXPECT_EQ(file.GetTimes(), (std::vector<double>{ 0, 2, 4 }));
  EXPECT_EQ(file.OpenMesh(1)->GetTimes(), (std::vector<double>{ 1, 3, 5 }));
  EXPECT_EQ(file.GetSeriesTimes(), (std::vector<double>{ 0, 1, 2, 3, 4, 5 }));
  EXPECT_THROW(file.OpenMesh(0), Error);
  EXPECT_THROW(file.OpenMesh(2), Error);
}

TEST(HostileSeries, TableAndMeshesBelongTogether)
{
  ExpectRefused("the table of meshes", [](SeriesImage& f) { f.HasTable = false; });
  ExpectRefused("the number of meshes is wrong", [](SeriesImage& f) { f.Others = 0; });
  ExpectRefused("the number of meshes is wrong", [](SeriesImage& f) { f.Others = 2; });
}

TEST(HostileSeries, MeshesAreNumberedInTheOrderOfTheirSteps)
{
  const std::string what = "a mesh has a number that is not the next one";
  ExpectRefused(what, [](SeriesImage& f) { f.Table[0].Mesh = 1; });
  ExpectRefused(what, [](SeriesImage& f) { f.Table[1].Mesh = 2; });
  ExpectRefused(what, [](SeriesImage& f) { f.Table[3].Mesh = 0xffffffffu; });
}

TEST(HostileSeries, TimesAscend)
{
  const std::string what = "the times of the steps do not ascend";
  ExpectRefused(what, [](SeriesImage& f) { f.Table[1].Time = 0; });
  ExpectRefused(what, [](SeriesImage& f) { std::swap(f.Table[2], f.Table[3]); });
  ExpectRefused(what, [](SeriesImage& f) { f.Table[3].Time = std::nan(""); });
}

TEST(HostileSeries, StepsAreThoseOfTheMeshes)
{
  const std::string first = "the time steps of the first mesh are not those listed";
  ExpectRefused(first, [](SeriesImage& f) { f.Table[2].Time = 2.5; });
  ExpectRefused(first, [](SeriesImage& f) { f.Table[2].Mesh = 1; });
  ExpectRefused(first, [](SeriesImage& f) { f.Table.erase(f.Table.begin() + 2); });
  const std::string other = "it cannot be a mesh of the series";
  ExpectRefused(
    other, [](SeriesImage& f) { f.Table.back().Time = 9; }, 1);
  ExpectRefused(
    other, [](SeriesImage& f) { f.Table.pop_back(); }, 1);
}

TEST(HostileSeries, OtherMeshesAreAsTheFirst)
{
  ExpectRefused(
    "it cannot be a mesh of the series", [](SeriesImage& f) { f.Other.Meta.Arrays[0].Name += "x"; },
    1);
  ExpectRefused(
    "it is part of a file, and has several meshes",
    [](SeriesImage& f)
    {
      f.Other.MoreSections.push_back({ SectionGrid, f.File.Build(), SectionVersion, 0 });
      f.Other.MoreSections.push_back({ SectionTime,
        WriteSeries(std::vector<SeriesStep>{ { 0, 1 }, { 0, 3 }, { 0, 5 }, { 1, 6 } }) });
    },
    1);
}

TEST(HostileSeries, TablesMustBeWhole)
{
  const auto stored = [](const std::function<void(ByteWriter&)>& write)
  {
    return [write](SeriesImage& f)
    {
      ByteWriter out;
      write(out);
      f.Stored = out.Data;
    };
  };
  ExpectRefused("the time steps are not all there",
    stored([](ByteWriter& out) { out.PutVarint(0xffffffffu); }));
  ExpectRefused("bytes behind the end",
    [](SeriesImage& f)
    {
      ByteWriter out;
      out.PutVarint(f.Table.size());
      for (const auto& step : f.Table)
      {
        out.PutVarint(step.Mesh);
        out.Put(step.Time);
      }
      out.Put(std::uint8_t{ 0 });
      f.Stored = out.Data;
    });
}

TEST(HostileSeries, OneBudgetServesAllMeshes)
{
  const auto path = PutFile("same.gtn", SeriesImage().Build());
  SharedFile file(path, 1u << 20);
  const auto other = file.GetMesh(1);
  EXPECT_EQ(other, file.GetMesh(1));
  EXPECT_EQ(other->GetBudget(), file.GetBudget());
  EXPECT_THROW(file.GetMesh(2), Error);
  EXPECT_GE(file.GetBytesRead(), other->GetBytesRead());
}

TEST(Series, WriterRefusesWhatNoFileHas)
{
  const auto mesh = MakeCubes(2, 0.2);
  const auto write = [&](const std::function<void(FileWriter&)>& use)
  {
    FileWriter writer(GetPath("refused.gtn"), mesh.GetInput(), {}, {});
    use(writer);
  };
  const auto add = [&](FileWriter& writer) { writer.AddMesh(mesh.GetInput(), {}); };
  EXPECT_THROW(write(
                 [&](FileWriter& w)
                 {
                   add(w);
                   w.WriteStep({}, {}, true, 1);
                 }),
    Error);
  EXPECT_THROW(write(
                 [&](FileWriter& w)
                 {
                   w.WriteStep({}, {}, true, 1);
                   add(w);
                   w.Finish();
                 }),
    Error);
  EXPECT_THROW(write(
                 [&](FileWriter& w)
                 {
                   w.WriteStep({}, {}, true, 1);
                   add(w);
                   add(w);
                 }),
    Error);
  EXPECT_THROW(write(
                 [&](FileWriter& w)
                 {
                   w.WriteStep({}, {}, true, 1);
                   add(w);
                   w.WriteStep({}, {}, true, 1);
                 }),
    Error);
  EXPECT_THROW(write([&](FileWriter& w) { w.UseMesh(1); }), Error);
  EXPECT_THROW(write(
                 [&](FileWriter& w)
                 {
                   w.WriteStep({}, {}, true, 1);
                   add(w);
                   w.WriteStep({}, {}, true, 2);
                   add(w);
                   w.UseMesh(1);
                 }),
    Error);
  EXPECT_EQ(ListFolder(GetPath("refused.gtn")).size(), 0u);
}
}
