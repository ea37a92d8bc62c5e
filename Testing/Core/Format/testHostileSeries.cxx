// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of several meshes: what is written, and files with valid checksums and invalid series.

#include "gatunCellMask.h"
#include "gatunExtents.h"
#include "gatunHostile.h"
#include "gatunPieceDecoder.h"
#include "gatunSeriesTable.h"
#include "gatunSharedFile.h"
#include "gatunTableParts.h"
#include "gatunVerifyFile.h"

#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
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
      this->Table.push_back({ 0, 0, this->File.Steps[i].Time });
      this->Table.push_back({ 1, 0, this->Other.Steps[i].Time });
    }
  }

  Bytes Build() const
  {
    auto file = this->File;
    auto other = this->Other;
    AddMasks(file, this->Masks);
    AddMasks(other, this->OtherMasks);
    for (std::size_t i = 0; i < this->Others; ++i)
    {
      file.MoreSections.push_back(
        { SectionGrid, this->Shared ? *this->Shared : MakeGrid(other.Build()) });
    }
    if (this->HasTable)
    {
      file.MoreSections.push_back(
        { SectionTime, this->Stored ? Store(*this->Stored) : WriteSeries(this->Table) });
    }
    return file.Build();
  }

  /** The payload of a section GRID that has all bytes of the file. */
  static Bytes MakeGrid(const Bytes& file)
  {
    Bytes payload = WriteExtents({});
    payload.insert(payload.end(), file.begin(), file.end());
    return payload;
  }

  static void AddMasks(FileImage& file, const std::vector<Bytes>& masks)
  {
    for (const auto& mask : masks)
    {
      file.MoreSections.push_back({ SectionLive, Store(mask) });
    }
  }

  FileImage File;
  FileImage Other;
  std::size_t Others = 1;
  bool HasTable = true;
  std::vector<StoredStep> Table;
  std::optional<Bytes> Stored;   // written in place of the table
  std::optional<Bytes> Shared;   // the payload of GRID, made of runs
  std::vector<Bytes> Masks;      // of the first mesh, unpacked
  std::vector<Bytes> OtherMasks; // of the other one
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
  for (std::size_t i = 0; i < image.Table.size(); ++i)
  {
    EXPECT_EQ(file.GetSeries().at(i), (SeriesStep{ image.Table[i].Mesh, image.Table[i].Time }));
  }
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
      f.Other.MoreSections.push_back({ SectionGrid, SeriesImage::MakeGrid(f.File.Build()) });
      f.Other.MoreSections.push_back({ SectionTime,
        WriteSeries(
          std::vector<StoredStep>{ { 0, 0, 1 }, { 0, 0, 3 }, { 0, 0, 5 }, { 1, 0, 6 } }) });
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
        out.PutVarint(step.Mask);
        out.Put(step.Time);
      }
      out.Put(std::uint8_t{ 0 });
      f.Stored = out.Data;
    });
}

/** Lets the other mesh have its bytes in common with the first one, which begins in the same way.
 */
Bytes ShareBeginning(const SeriesImage& image,
  const std::function<void(std::vector<Extent>&)>& change, std::size_t more = 0)
{
  const Bytes other = image.Other.Build();
  const Bytes file = image.File.Build();
  const auto end = static_cast<std::size_t>(
    std::mismatch(other.begin() + HeaderSize, other.end(), file.begin() + HeaderSize).first -
    other.begin());
  EXPECT_GT(end, 1000u);
  std::vector<Extent> extents{ { HeaderSize, 0 }, { end - HeaderSize, HeaderSize },
    { other.size() - end, 0 } };
  change(extents);
  Bytes payload = WriteExtents(extents);
  payload.insert(payload.end(), other.begin(), other.begin() + HeaderSize);
  payload.insert(payload.end(), other.begin() + static_cast<std::ptrdiff_t>(end), other.end());
  payload.resize(payload.size() + more);
  return payload;
}

TEST(HostileSeries, BytesInCommonAreRead)
{
  SeriesImage image;
  image.Shared = ShareBeginning(image, [](std::vector<Extent>&) {});
  const auto path = PutFile("shared.gtn", image.Build());
  const FileReader file(path);
  EXPECT_TRUE(VerifyFile(file));
  EXPECT_EQ(file.OpenMesh(1)->GetTimes(), (std::vector<double>{ 1, 3, 5 }));
}

TEST(HostileSeries, BytesInCommonAreBeforeTheMesh)
{
  const auto refuse = [](const std::string& what,
                        const std::function<void(std::vector<Extent>&)>& change,
                        std::size_t more = 0)
  {
    ExpectRefused(
      what, [&](SeriesImage& f) { f.Shared = ShareBeginning(f, change, more); }, 1);
  };
  const std::string notBefore = "one of its parts is not before it";
  refuse(notBefore, [](std::vector<Extent>& e) { e[1].Source = std::uint64_t{ 1 } << 40; });
  refuse(notBefore, [](std::vector<Extent>& e) { e[1].Source = ~std::uint64_t{ 0 }; });
  refuse(notBefore,
    [](std::vector<Extent>& e)
    {
      // The last bytes before the section, and one more. It is where the directory was.
      const auto file = SeriesImage().File.Build();
      const auto before =
        ByteReader(std::span(file).last(TrailerSize)).Get<std::uint64_t>() - SectionHeaderSize;
      e[1].Source = before - e[1].Length + 1;
    });
  const std::string longer = "its parts are longer than what is there";
  refuse(longer, [](std::vector<Extent>& e) { e[1].Length = std::uint64_t{ 1 } << 40; });
  refuse(longer, [](std::vector<Extent>& e) { ++e[2].Length; });
  refuse(longer,
    [](std::vector<Extent>& e)
    {
      // The same bytes many times.
      e.insert(e.begin() + 1, 1000, e[1]);
    });
  refuse("there are bytes behind its last part", [](std::vector<Extent>& e) { --e[2].Length; });
  refuse(
    "there are bytes behind its last part", [](std::vector<Extent>&) {}, 1);
  refuse("one of its parts is empty", [](std::vector<Extent>& e) { e.push_back({ 0, 0 }); });
  ExpectRefused(
    "the list of its parts is not all there",
    [](SeriesImage& f)
    {
      ByteWriter out;
      out.PutVarint(1000000);
      out.Put(std::uint64_t{ 0 });
      f.Shared = out.Data;
    },
    1);
  ExpectRefused(
    "its checksum is wrong",
    [](SeriesImage& f)
    {
      f.Shared = ShareBeginning(f, [](std::vector<Extent>&) {});
      (*f.Shared)[2] ^= 1;
    },
    1);
  ExpectRefused(
    "the data ends too early", [](SeriesImage& f) { f.Shared = Bytes(3, 1); }, 1);
  ExpectRefused(
    "the data ends too early", [](SeriesImage& f) { f.Shared = Bytes(); }, 1);
  ExpectRefused(
    "the file is empty", [](SeriesImage& f) { f.Shared = Bytes(1, 0); }, 1);
}

/** The bytes of a mask. points: as many as are left out. */
Bytes MakeMask(std::uint8_t flags, std::uint64_t cells, std::uint64_t points,
  const std::vector<std::uint64_t>& runs, std::uint64_t count)
{
  ByteWriter out;
  out.Put(flags);
  out.PutVarint(cells);
  out.PutVarint(points);
  out.PutVarint(count);
  for (const auto run : runs)
  {
    out.PutVarint(run);
  }
  return out.Data;
}

/** Some cells of the first mesh are dead at its last step. */
void AddMask(SeriesImage& f, std::uint8_t flags, std::int64_t moreCells, std::int64_t morePoints,
  const std::vector<std::uint64_t>& runs, std::uint64_t moreRuns = 0)
{
  f.Masks.push_back(MakeMask(flags, f.File.Meta.Tets - 7 + static_cast<std::uint64_t>(moreCells),
    f.File.Meta.Points + static_cast<std::uint64_t>(morePoints), runs, runs.size() + moreRuns));
  f.Table[4].Mask = 1;
}

TEST(HostileSeries, MasksAreRead)
{
  SeriesImage image;
  AddMask(image, 0, 0, 0, { 3, 7 });
  const FileReader file(PutFile("masked.gtn", image.Build()));
  EXPECT_TRUE(VerifyFile(file));
  EXPECT_EQ(file.GetNumberOfMeshes(), 3u);
  EXPECT_EQ(file.GetSeries().at(4), (SeriesStep{ 2, 4 }));
  EXPECT_EQ(file.GetParentMesh(2), 0u);
  EXPECT_EQ(file.GetParentMesh(1), 1u);
  const auto mesh = file.OpenMesh(2);
  EXPECT_FALSE(mesh->HasAllCells());
  EXPECT_EQ(mesh->GetNumberOfCells(), image.File.Meta.Tets - 7);
  EXPECT_EQ(mesh->GetChunks().at(0).Cells, file.GetChunks().at(0).Cells - 7);
  EXPECT_EQ(mesh->GetNumberOfMeshes(), 1u);
}

TEST(HostileSeries, MasksFitTheMesh)
{
  const auto tets = SeriesImage().File.Meta.Tets;
  const auto expect = [&](const std::string& what, std::uint8_t flags, std::int64_t moreCells,
                        std::int64_t morePoints, const std::vector<std::uint64_t>& runs,
                        std::uint64_t moreRuns = 0)
  {
    SeriesImage image;
    AddMask(image, flags, moreCells, morePoints, runs, moreRuns);
    const auto path = PutFile("changed.gtn", image.Build());
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, what, [&] { FileReader(path).OpenMesh(2); });
  };
  expect("the number of cells is wrong", 0, 1, 0, { 3, 7 });
  expect("the number of points is wrong", 0, 0, -1, { 3, 7 });
  expect("the number of points is wrong", 2, 0, 1, { 3, 7 });
  expect("a flag has no meaning", 4, 0, 0, { 3, 7 });
  expect("there is no mask before it", 1, 0, 0, { 3, 7 });
  expect("a run is empty", 0, 0, 0, { 3, 7, 0 });
  expect("there are more cells than in the mesh", 0, 0, 0, { 3, tets });
  expect("there are more cells than in the mesh", 0, 0, 0, { ~std::uint64_t{ 0 }, 7 });
  expect("a count is larger than the data", 0, 0, 0, { 3, 7 }, 100);
}

TEST(HostileSeries, PointsOfMasksAreCounted)
{
  SeriesImage image;
  AddMask(image, 2, 0, -30, { 3, 7 });
  const auto path = PutFile("changed.gtn", image.Build());
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, "points instead of",
    [&]
    {
      const FileReader file(path);
      VerifyFile(file);
    });
}

TEST(HostileSeries, MasksAreThoseOfTheSteps)
{
  const auto add = [](SeriesImage& f) { AddMask(f, 0, 0, 0, { 3, 7 }); };
  ExpectRefused("the first step of a mesh has not all of its cells",
    [&](SeriesImage& f)
    {
      add(f);
      f.Table[0].Mask = 1;
    });
  ExpectRefused("a mask has a number that is not the next one",
    [&](SeriesImage& f)
    {
      add(f);
      f.Table[4].Mask = 2;
    });
  ExpectRefused("the number of masks is wrong",
    [&](SeriesImage& f)
    {
      add(f);
      f.Masks.push_back(f.Masks[0]);
    });
  ExpectRefused("the number of masks is wrong",
    [&](SeriesImage& f)
    {
      add(f);
      f.Masks.clear();
    });
  ExpectRefused("the number of masks is wrong",
    [&](SeriesImage& f)
    {
      add(f);
      f.Table[4].Mask = 0;
    });
  ExpectRefused(
    "it cannot be a mesh of the series", [](SeriesImage& f) { f.Table[3].Mask = 1; }, 1);
  ExpectRefused("it does not say which time steps have some cells only",
    [&](SeriesImage& f)
    {
      add(f);
      f.Others = 0;
      f.HasTable = false;
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

TEST(HostileSeries, OneDescriptorServesAllMeshes)
{
  const auto count = []
  {
    const std::filesystem::directory_iterator open("/proc/self/fd");
    return std::distance(begin(open), end(open));
  };
  SeriesImage image;
  AddMask(image, 0, 0, 0, { 3, 7 });
  SharedFile file(PutFile("masked.gtn", image.Build()), 1u << 20);
  const auto before = count();
  EXPECT_EQ(file.GetMesh(1)->GetFile()->GetNumberOfSteps(), 3u);
  EXPECT_FALSE(file.GetMesh(2)->GetFile()->HasAllCells());
  EXPECT_EQ(count(), before);
}

TEST(HostileSeries, AllCellsMayBeDead)
{
  SeriesImage image;
  ByteWriter mask;
  mask.Put(std::uint8_t{ 2 });
  for (const std::uint64_t value : { std::uint64_t{ 0 }, std::uint64_t{ 0 }, std::uint64_t{ 2 },
         std::uint64_t{ 0 }, image.File.Meta.Tets })
  {
    mask.PutVarint(value); // cells, points, and two runs
  }
  image.Masks.push_back(mask.Data);
  image.Table[4].Mask = 1;
  const auto path = PutFile("dead.gtn", image.Build());
  EXPECT_TRUE(VerifyFile(FileReader(path)));
  SharedFile file(path, 1u << 20);
  const auto mesh = file.GetMesh(2);
  PieceDecoder decoder(mesh->MakeView(mesh->GetFile(), true));
  PieceRequest request;
  for (std::uint32_t chunk = 0; chunk < mesh->GetFile()->GetChunks().size(); ++chunk)
  {
    request.Chunks.push_back(chunk);
  }
  request.Universe = request.Chunks;
  for (const unsigned ghosts : { 0u, 1u })
  {
    request.GhostLevels = ghosts;
    decoder.SetRequest(request);
    EXPECT_EQ(decoder.GetNumberOfCells(), 0u);
    EXPECT_EQ(decoder.GetNumberOfPoints(), 0u);
    decoder.Fill({});
  }
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
