// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of cells that are not all tetrahedra: what comes back, and what is refused.

#include "gatunCellMixture.h"
#include "gatunHostile.h"
#include "gatunParallel.h"
#include "gatunPieceCells.h"
#include "gatunVerifyFile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

std::string Write(const Mixture& mesh, std::uint8_t keep, std::uint32_t chunkTets = 200)
{
  auto path = GetPath("cells.gtn");
  WriterOptions options;
  options.ChunkSize = chunkTets;
  options.Keep = keep;
  const std::vector<ArrayDescription> arrays{ { "cell", Association::Cell, ScalarType::Int32, 1, 0,
                                                0, {} },
    { "point", Association::Point, ScalarType::Float64, 1, 0, 0, {} } };
  std::vector<std::int32_t> cell(mesh.Types.size());
  std::iota(cell.begin(), cell.end(), 7);
  std::vector<double> point(mesh.Coordinates.begin(),
    mesh.Coordinates.begin() + static_cast<std::ptrdiff_t>(mesh.Coordinates.size() / 3));
  FileWriter writer(path, mesh.GetInput(), arrays, options);
  writer.WriteStep(std::array<const void*, 2>{ cell.data(), point.data() }, {}, false, 0);
  writer.Finish();
  return path;
}

PieceRequest AskForForm(const FileReader& file, PieceForm form)
{
  PieceRequest request;
  request.Chunks.resize(file.GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.WithUnusedPoints = true;
  request.Arrays = { 0, 1 };
  request.Form = form;
  return request;
}

/** Reads all of a file in a form. */
void ReadForm(const std::string& path, PieceForm form)
{
  const auto file = std::make_shared<FileReader>(path);
  PieceDecoder decoder(file);
  decoder.SetRequest(AskForForm(*file, form));
  const auto cells = static_cast<std::size_t>(decoder.GetNumberOfCells());
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  PieceCells memory(decoder.IsTetrahedral(), cells,
    static_cast<std::size_t>(decoder.GetConnectivitySize()),
    static_cast<std::size_t>(decoder.GetFacesSize()));
  std::vector<double> coordinates(3 * points);
  std::vector<std::int32_t> cell(cells);
  std::vector<double> point(points);
  auto target = memory.GetTarget();
  target.Points = coordinates.data();
  target.Arrays = { cell.data(), point.data() };
  decoder.Fill(target);
}

void ReadBothForms(const std::string& path)
{
  ReadForm(path, PieceForm::Original);
  ReadForm(path, PieceForm::Tetrahedra);
}

TEST(CellFile, CellsComeBackInTheirOrder)
{
  const Mixture mesh(5);
  for (const std::uint32_t chunkTets : { 100u, 400u, 100000u })
  {
    const auto path = Write(mesh, KeepAll, chunkTets);
    const auto file = std::make_shared<FileReader>(path);
    EXPECT_FALSE(file->IsTetrahedral());
    EXPECT_EQ(file->GetNumberOfCells(), mesh.Types.size());
    std::uint64_t sum = 0;
    for (const auto& type : file->GetCellTypes())
    {
      EXPECT_EQ(type.Cells,
        static_cast<std::uint64_t>(std::count(mesh.Types.begin(), mesh.Types.end(), type.Type)));
      sum += type.Cells;
    }
    EXPECT_EQ(sum, mesh.Types.size());

    PieceDecoder decoder(file);
    decoder.SetRequest(AskForForm(*file, PieceForm::Original));
    ASSERT_FALSE(decoder.IsTetrahedral());
    ASSERT_EQ(decoder.GetNumberOfCells(), mesh.Types.size());
    ASSERT_EQ(decoder.GetConnectivitySize(), mesh.Ids.size());
    ASSERT_EQ(decoder.GetFacesSize(), mesh.Faces.size());
    Mixture back(0);
    back.Coordinates.resize(mesh.Coordinates.size());
    back.Types.resize(mesh.Types.size());
    back.Offsets.resize(mesh.Offsets.size());
    back.Ids.resize(mesh.Ids.size());
    back.FaceLocations.resize(mesh.FaceLocations.size());
    back.Faces.resize(mesh.Faces.size());
    std::vector<std::int32_t> cell(mesh.Types.size());
    std::vector<double> point(mesh.Coordinates.size() / 3);
    PieceTarget target;
    target.Points = back.Coordinates.data();
    target.Connectivity = back.Ids.data();
    target.Offsets = back.Offsets.data();
    target.Types = back.Types.data();
    target.FaceLocations = back.FaceLocations.data();
    target.Faces = back.Faces.data();
    target.Arrays = { cell.data(), point.data() };
    decoder.Fill(target);
    EXPECT_EQ(back.Coordinates, mesh.Coordinates);
    EXPECT_EQ(back.Types, mesh.Types);
    EXPECT_EQ(back.Offsets, mesh.Offsets);
    EXPECT_EQ(back.Ids, mesh.Ids);
    EXPECT_EQ(back.FaceLocations, mesh.FaceLocations);
    EXPECT_EQ(back.Faces, mesh.Faces);
    EXPECT_EQ(cell.front(), 7);
    EXPECT_EQ(cell.back(), static_cast<std::int32_t>(mesh.Types.size()) + 6);
    EXPECT_TRUE(VerifyFile(*file));
  }
}

TEST(CellFile, TetrahedraHaveTheValuesOfTheirCells)
{
  const Mixture mesh(4);
  const auto file = std::make_shared<FileReader>(Write(mesh, KeepNone));
  PieceDecoder decoder(file);
  decoder.SetRequest(AskForForm(*file, PieceForm::Tetrahedra));
  ASSERT_TRUE(decoder.IsTetrahedral());
  const auto tets = static_cast<std::size_t>(decoder.GetNumberOfCells());
  EXPECT_EQ(tets, file->GetNumberOfTets());
  std::vector<std::int32_t> cell(tets);
  PieceTarget target;
  target.Arrays = { cell.data(), nullptr };
  decoder.Fill(target);
  for (std::size_t i = 0; i < mesh.Types.size(); ++i)
  {
    const auto type = mesh.Types[i];
    const auto expected = type == Wedge ? 3 : type == Hexahedron || type == Polyhedron ? 6 : 0;
    EXPECT_EQ(std::count(cell.begin(), cell.end(), static_cast<std::int32_t>(i) + 7), expected)
      << i;
  }
}

TEST(CellFile, BytesDoNotDependOnThreads)
{
  const Mixture mesh(7);
  std::vector<std::string> files;
  for (const int threads : { 1, 2 })
  {
    WithNumberOfThreads(threads,
      [&]
      {
        std::ifstream in(Write(mesh, KeepAll), std::ios::binary);
        files.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
      });
  }
  EXPECT_GT(files[0].size(), 1000u);
  EXPECT_EQ(files[0], files[1]);
}

TEST(CellFile, BadCellsAreRefusedAndLeaveNoFile)
{
  const auto refuse = [](const std::string& what, const std::function<void(Mixture&)>& change)
  {
    Mixture mesh(2);
    change(mesh);
    try
    {
      Write(mesh, KeepNone);
      ADD_FAILURE() << "no error, but expected: " << what;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
    EXPECT_FALSE(FileReader::CanRead(GetPath("cells.gtn")));
  };
  refuse("cell 0 uses point -1", [](Mixture& m) { m.Ids[3] = -1; });
  refuse("cell 1 uses point 27", [](Mixture& m) { m.Ids[6] = 27; });
  refuse("cell 1 ends before it begins", [](Mixture& m) { m.Offsets[2] = 3; });
  refuse("cell 2 is a polyhedron without faces", [](Mixture& m) { m.FaceLocations[2] = -1; });
  refuse("cell 2 has faces beyond the end", [](Mixture& m) { m.FaceLocations[2] = 1000; });
  refuse("cell 2 has -6 faces", [](Mixture& m) { m.Faces[0] = -6; });
  refuse("cell 2 has a face of -4 points", [](Mixture& m) { m.Faces[1] = -4; });
  refuse("cell 2 uses point 99", [](Mixture& m) { m.Faces[2] = 99; });
}

TEST(CellFile, TablesOfCellsMustBeRight)
{
  const FileImage good(Write(Mixture(4), KeepAll));
  const auto refuse = [&](const std::string& what, const std::function<void(FileImage&)>& change)
  {
    auto image = good;
    change(image);
    const auto path = PutFile("changed.gtn", image.Build());
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, what, [&] { ReadBothForms(path); });
  };
  ReadBothForms(PutFile("same.gtn", good.Build()));
  const auto first = [](FileImage& f) -> CellSizes& { return f.Cells->Chunks[0]; };
  refuse("types of cells do not add up", [](FileImage& f) { ++f.Cells->Types[0].Cells; });
  refuse("do not ascend", [](FileImage& f) { std::swap(f.Cells->Types[0], f.Cells->Types[1]); });
  refuse("a type of cells has no cells", [](FileImage& f) { f.Cells->Types[0].Cells = 0; });
  refuse("not that of the chunks", [](FileImage& f) { f.Cells->Chunks.pop_back(); });
  refuse("impossible number of cells", [&](FileImage& f) { first(f).Cells = 0; });
  refuse("impossible number of cells", [&](FileImage& f) { first(f).Cells = 1u << 21; });
  refuse("too many points", [&](FileImage& f) { first(f).Corners = 1u << 25; });
  refuse("claims more cells than its stream", [&](FileImage& f) { first(f).Cells += 900000; });
  refuse("claims more cells than its stream",
    [&](FileImage& f) { first(f).Corners = (1u << 24) - first(f).FaceValues; });
  refuse("more polyhedra than cells", [&](FileImage& f) { first(f).Polyhedra = 1u << 20; });
  refuse("faces without polyhedra", [&](FileImage& f) { first(f).Polyhedra = 0; });
  refuse("polyhedra that it should have", [&](FileImage& f) { --first(f).Polyhedra; });
  refuse("the mesh of chunk 0", [&](FileImage& f) { ++first(f).Corners; });
  refuse("the mesh of chunk 0", [&](FileImage& f) { --first(f).FaceValues; });
  refuse("more tetrahedra than its cells",
    [](FileImage& f)
    {
      f.Meta.Tets += 100000;
      f.Mesh.Chunks[0].Info.Tets += 100000;
    });
  refuse("tetrahedra that it should have",
    [](FileImage& f)
    {
      ++f.Meta.Tets;
      ++f.Mesh.Chunks[0].Info.Tets;
    });
  refuse("behind the last shape", [](FileImage& f) { f.Cells->StoredShapes.push_back(0); });
  refuse("", [&](FileImage& f) { first(f).IsTetrahedral = true; });
  refuse("", [](FileImage& f) { f.Cells.reset(); });
}

TEST(CellFile, VerifyingCountsTheCellsOfEachType)
{
  // Many chunks, some of which are of tetrahedra.
  const FileImage good(Write(Mixture(10), KeepAll, 100));
  ASSERT_GT(good.Cells->Chunks.size(), 18u);
  const auto refuse = [&](const std::string& what, const std::function<void(CellTable&)>& change)
  {
    auto image = good;
    change(*image.Cells);
    const auto path = PutFile("changed.gtn", image.Build());
    ReadBothForms(path);
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, what, [&] { VerifyFile(FileReader(path)); });
  };
  EXPECT_TRUE(VerifyFile(FileReader(PutFile("same.gtn", good.Build()))));
  const auto typeAt = [](CellTable& c, std::uint8_t type) -> CellTypeCount&
  {
    return *std::find_if(
      c.Types.begin(), c.Types.end(), [&](const CellTypeCount& t) { return t.Type == type; });
  };
  refuse("cells of type 9 instead of",
    [&](CellTable& c)
    {
      --typeAt(c, Quad).Cells;
      ++typeAt(c, Wedge).Cells;
    });
  refuse("there are 0 cells of type 0 instead of 1",
    [&](CellTable& c)
    {
      --typeAt(c, Wedge).Cells;
      c.Types.insert(c.Types.begin(), { 0, 1 });
    });
  refuse("cells of type 5 instead of",
    [&](CellTable& c)
    {
      typeAt(c, Triangle).Cells += typeAt(c, Polyhedron).Cells;
      c.Types.pop_back();
    });
}

TEST(CellFile, ChangedStreamsAreErrorsOrOtherCells)
{
  const FileImage good(Write(Mixture(3), KeepAll, 100));
  std::mt19937 random(3);
  for (int round = 0; round < 400; ++round)
  {
    auto image = good;
    auto& stream = image.Streams[random() % image.Streams.size()];
    for (int i = 0; i < 3 && !stream.empty(); ++i)
    {
      stream[random() % stream.size()] = static_cast<std::uint8_t>(random());
    }
    if (round % 3 == 0)
    {
      stream.resize(1 + random() % stream.size());
    }
    const auto path = PutFile("changed.gtn", image.Build());
    for (const auto form : { PieceForm::Original, PieceForm::Tetrahedra })
    {
      try
      {
        ReadForm(path, form);
      }
      catch (const Error&)
      {
        // Most changes are noticed.
      }
    }
  }
}
}
