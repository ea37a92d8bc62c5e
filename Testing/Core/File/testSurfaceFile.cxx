// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of surfaces: what marks them, and marks that are wrong under valid checksums.

#include "gatunFileWriter.h"
#include "gatunHostile.h"
#include "gatunPartWriter.h"
#include "gatunSurfaceCells.h"
#include "gatunSurfaceTable.h"
#include "gatunVerifyFile.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** A strip, a polygon with five corners, a line and a vertex over six points. */
struct Surface
{
  MeshInput GetInput() const
  {
    MeshInput mesh;
    mesh.Points = this->Coordinates.size() / 3;
    mesh.Coordinates = this->Coordinates.data();
    mesh.Cells = this->Types.size();
    mesh.Connectivity = this->Ids.data();
    mesh.Types = this->Types.data();
    mesh.Offsets = this->Offsets.data();
    return mesh;
  }

  std::vector<float> Coordinates{ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 1, 2, 1, 1 };
  std::vector<std::uint8_t> Types{ 1, 3, 7, 6 };
  std::vector<std::int64_t> Ids{ 5, 0, 4, 0, 1, 4, 5, 2, 0, 1, 3, 2 };
  std::vector<std::int64_t> Offsets{ 0, 1, 3, 8, 12 };
};

std::string Write(const Surface& surface, const WriterOptions& options)
{
  auto path = GetPath("surface.gtn");
  FileWriter writer(path, surface.GetInput(), {}, options);
  writer.WriteStep({}, {}, false, 0);
  writer.Finish();
  return path;
}

WriterOptions MarkSurface()
{
  WriterOptions options;
  options.IsSurface = true;
  options.Keep = KeepAll;
  return options;
}

TEST(SurfaceFile, IsMarkedAndSkippedByOlderReaders)
{
  const auto path = Write({}, MarkSurface());
  EXPECT_TRUE(FileReader::IsSurfaceFile(path));
  const FileReader file(path);
  EXPECT_TRUE(file.IsSurface());
  EXPECT_EQ(file.GetNumberOfTets(), 0u);
  EXPECT_TRUE(VerifyFile(file));
  EXPECT_NO_THROW(ReadAll(path));

  // The same without the mark.
  const auto plain = Write({}, {});
  EXPECT_FALSE(FileReader::IsSurfaceFile(plain));
  EXPECT_FALSE(FileReader(plain).IsSurface());
  const InputFile container(path);
  for (const auto& section : container.GetSections())
  {
    EXPECT_EQ(section.Name == SectionSurface, (section.Flags & FlagMandatory) == 0);
  }
}

TEST(SurfaceFile, ListsAndTypesDetermineEachOther)
{
  for (std::size_t i = 0; i < SurfaceLists; ++i)
  {
    for (std::int64_t points = 0; points < 10; ++points)
    {
      const auto list = static_cast<SurfaceList>(i);
      const auto type = GetSurfaceCell(list, points);
      EXPECT_TRUE(IsSurfaceCell(type));
      EXPECT_EQ(GetSurfaceList(type), list);
    }
  }
  for (const int type : { 0, 8, 10, 12, 22, 42, 255 })
  {
    EXPECT_FALSE(IsSurfaceCell(type));
  }
}

TEST(SurfaceFile, OfNothingIsOne)
{
  const auto path = GetPath("empty.gtn");
  FileWriter(path, {}, {}, MarkSurface()).Finish();
  EXPECT_TRUE(FileReader(path).IsSurface());
  PartWriterOptions options;
  options.File = MarkSurface();
  PartWriter parts(path, {}, options);
  parts.Survey({});
  parts.Write({});
  parts.Finish();
  EXPECT_TRUE(FileReader(path).IsSurface());
}

TEST(SurfaceFile, RefusesOtherCellsAndTreesThatDoNotFit)
{
  const auto refuse = [](const Surface& surface, const WriterOptions& options, const char* what)
  {
    try
    {
      Write(surface, options);
      ADD_FAILURE() << what;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  Surface solid;
  solid.Types.back() = 10;
  refuse(solid, MarkSurface(), "no part of a surface");
  const MergeTree tree;
  WriterOptions options = MarkSurface();
  options.Tree = &tree;
  refuse({}, options, "the tree of merges is not that of the mesh");
  Surface nothing;
  nothing.Coordinates.clear();
  nothing.Types.clear();
  EXPECT_EQ(FileReader(Write(nothing, options)).GetNumberOfMerges(), 0u);
  Surface more;
  more.Coordinates.insert(more.Coordinates.end(), { 7, 7, 7 }); // of no cell
  const MergeTree into(7, { { 1, 6, 0 } });
  options.Tree = &into;
  refuse(more, options, "the tree merges points that no cell has");
  const MergeTree from(7, { { 6, 1, 0 } });
  options.Tree = &from;
  EXPECT_EQ(FileReader(Write(more, options)).GetMergeTree().GetMerges()[0].Point, 6u);
}

/** The file of a surface with other sections SURF. */
std::string PutMarks(const std::vector<FileImage::Section>& marks)
{
  FileImage file(Write({}, MarkSurface()));
  file.MoreSections = marks;
  return PutFile("changed.gtn", file.Build());
}

FileImage::Section Mark(Bytes payload)
{
  return { SectionSurface, std::move(payload), SectionVersion, 0 };
}

TEST(HostileSurfaces, MarksAreChecked)
{
  EXPECT_TRUE(FileReader(PutMarks({ Mark({ 1 }) })).IsSurface());
  EXPECT_FALSE(FileReader(PutMarks({})).IsSurface());
  for (const Bytes& payload : { Bytes{}, Bytes{ 0 }, Bytes{ 2 }, Bytes{ 1, 0 } })
  {
    const auto path = PutMarks({ Mark(payload) });
    EXPECT_GATUN_ERROR(
      ErrorCode::Corrupt, path, "the kind of surface is unknown", [&] { FileReader file(path); });
    EXPECT_TRUE(FileReader::IsSurfaceFile(path)); // opening it reports what is wrong
  }
  const auto path = PutMarks({ Mark({ 1 }), Mark({ 1 }) });
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, "several sections", [&] { FileReader file(path); });
}

TEST(HostileSurfaces, TetrahedraAreNoSurface)
{
  FileImage file = MakeImage();
  file.MoreSections.push_back(Mark({ 1 }));
  const auto path = PutFile("changed.gtn", file.Build());
  EXPECT_GATUN_ERROR(
    ErrorCode::Corrupt, path, "no part of a surface", [&] { FileReader reader(path); });
}
}
