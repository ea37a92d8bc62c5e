// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files with more than 2^32 points and cells. All but a few chunks are only claimed by the tables.

#include "gatunCellTable.h"
#include "gatunFileReader.h"
#include "gatunHostile.h"
#include "gatunMeshSection.h"
#include "gatunPieceDecoder.h"
#include "gatunTestMeshes.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr std::uint64_t Claimed = 4200; // chunks
constexpr std::uint64_t ClaimedCells = Claimed << 20;
constexpr std::uint64_t ClaimedPoints = Claimed << 22;

/** Adds chunks that have as many tetrahedra as they can, and all their points for themselves. */
void ClaimChunks(WriterState& state)
{
  ChunkEntry chunk;
  chunk.Info.Tets = 1u << 20;
  chunk.Info.OwnPoints = 1u << 22;
  chunk.Sizes = { true, 1u << 20, 1u << 22, 0, 0 };
  chunk.Info.Cells = chunk.Sizes.Cells;
  const Bytes empty(static_cast<std::size_t>(Claimed) * 4100, 0);
  const auto offset = state.File.AddSection(SectionMesh, empty);
  chunk.Connectivity = { offset, 4097, 0 };
  chunk.Geometry = chunk.PointOrder = chunk.CellOrder = chunk.Corners = { offset, 1, 0 };
  std::fill_n(state.Table.Chunks.begin(), Claimed, chunk);
}

/** Writes a mesh as the last chunks of such a file. */
void WriteWide(const std::string& path, const TestMesh& mesh, std::uint8_t keep)
{
  WriterOptions options;
  options.Keep = keep;
  options.ChunkSize = 200;
  WriterState state(path, {}, options);
  MeshSection section(state);
  WriterPart part(mesh.GetInput());
  part.Place.FirstChunk = Claimed;
  part.Place.FirstPoint = ClaimedPoints;
  part.Place.FirstCell = ClaimedCells;
  state.Table.Chunks.resize(Claimed);
  state.Describe(part.Mesh);
  section.MakeLayout(part, {});
  section.AddChunks(part);
  section.AddGroups(part);
  state.Meta.Points += ClaimedPoints;
  state.Meta.Tets = ClaimedCells;
  state.NumberOfCells += ClaimedCells;
  state.LinkGroups();
  ClaimChunks(state);
  std::map<ChunkGroup, std::vector<std::uint32_t>> groups;
  for (const auto& [users, points] : part.Layout.SharedPoints)
  {
    ChunkGroup chunks = users;
    std::for_each(chunks.begin(), chunks.end(), [](auto& chunk) { chunk += Claimed; });
    groups[chunks] = points;
  }
  part.Place.Blocks = state.Table.Blocks.size();
  part.PlaceShared(state.Table, groups);
  PointDomain domains;
  domains.fill(Domain(state.Meta.CoordinateType));
  section.SetDomains(domains);
  section.Write(part, {});
  state.WriteTables(state.File);
  state.File.AddSection(SectionMeta, state.Meta.Write());
  state.Commit(state.File);
}

struct WidePiece
{
  explicit WidePiece(const std::shared_ptr<const FileReader>& file)
  {
    PieceDecoder decoder(file);
    PieceRequest request;
    for (auto c = static_cast<std::uint32_t>(Claimed); c < file->GetChunks().size(); ++c)
    {
      request.Chunks.push_back(c);
    }
    request.Universe = request.Chunks;
    decoder.SetRequest(request);
    this->Mesh.Coordinates.resize(3 * static_cast<std::size_t>(decoder.GetNumberOfPoints()));
    this->Mesh.Ids.resize(4 * static_cast<std::size_t>(decoder.GetNumberOfCells()));
    this->PointIds.resize(this->Mesh.GetPoints());
    this->CellIds.resize(this->Mesh.GetTets());
    PieceTarget target;
    target.Points = this->Mesh.Coordinates.data();
    target.Connectivity = this->Mesh.Ids.data();
    target.GlobalPointIds = this->PointIds.data();
    target.GlobalCellIds = this->CellIds.data();
    decoder.Fill(target);
  }

  TestMesh Mesh;
  std::vector<std::int64_t> PointIds, CellIds;
};
}

TEST(WideNumbers, OriginalNumbersComeBack)
{
  const auto mesh = MakeCubes(6, 0.2);
  const auto path = GetPath("wide.gtn");
  WriteWide(path, mesh, KeepAll);
  const auto file = std::make_shared<const FileReader>(path);
  EXPECT_EQ(file->GetNumberOfPoints(), ClaimedPoints + mesh.GetPoints());
  EXPECT_EQ(file->GetNumberOfCells(), ClaimedCells + mesh.GetTets());
  EXPECT_EQ(file->GetNumberOfTets(), ClaimedCells + mesh.GetTets());
  const WidePiece piece(file);
  ASSERT_EQ(piece.Mesh.GetPoints(), mesh.GetPoints());
  ASSERT_EQ(piece.Mesh.GetTets(), mesh.GetTets());
  std::set<std::int64_t> seen;
  for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
  {
    const auto number = piece.PointIds[p] - static_cast<std::int64_t>(ClaimedPoints);
    ASSERT_TRUE(number >= 0 && number < static_cast<std::int64_t>(mesh.GetPoints()));
    EXPECT_TRUE(seen.insert(number).second);
    EXPECT_TRUE(std::equal(&piece.Mesh.Coordinates[3 * p], &piece.Mesh.Coordinates[3 * p] + 3,
      &mesh.Coordinates[3 * static_cast<std::size_t>(number)]));
  }
  seen.clear();
  for (std::size_t t = 0; t < mesh.GetTets(); ++t)
  {
    const auto number = piece.CellIds[t] - static_cast<std::int64_t>(ClaimedCells);
    ASSERT_TRUE(number >= 0 && number < static_cast<std::int64_t>(mesh.GetTets()));
    EXPECT_TRUE(seen.insert(number).second);
    std::set<std::int64_t> corners, expected;
    for (std::size_t i = 0; i < 4; ++i)
    {
      corners.insert(piece.PointIds[static_cast<std::size_t>(piece.Mesh.Ids[4 * t + i])]);
      expected.insert(mesh.Ids[4 * static_cast<std::size_t>(number) + i] +
        static_cast<std::int64_t>(ClaimedPoints));
    }
    EXPECT_EQ(corners, expected);
  }
}

TEST(WideNumbers, NumbersOfTheFileAreWide)
{
  const auto mesh = MakeCubes(6, 0.2);
  const auto path = GetPath("wide.gtn");
  WriteWide(path, mesh, KeepNone);
  const auto file = std::make_shared<const FileReader>(path);
  const WidePiece piece(file);
  const auto shared = static_cast<std::int64_t>(file->GetNumberOfPoints() - ClaimedPoints -
    [&]
    {
      std::uint64_t own = 0;
      for (std::size_t c = Claimed; c < file->GetChunks().size(); ++c)
      {
        own += file->GetChunks()[c].OwnPoints;
      }
      return own;
    }());
  // Shared points are the first ones of the file, and these chunks are its last ones.
  const std::set<std::int64_t> ids(piece.PointIds.begin(), piece.PointIds.end());
  ASSERT_EQ(ids.size(), mesh.GetPoints());
  EXPECT_EQ(*ids.begin(), 0);
  EXPECT_EQ(*std::next(ids.begin(), shared), shared + static_cast<std::int64_t>(ClaimedPoints));
  EXPECT_EQ(*ids.rbegin(), static_cast<std::int64_t>(file->GetNumberOfPoints()) - 1);
  EXPECT_EQ(*std::min_element(piece.CellIds.begin(), piece.CellIds.end()),
    static_cast<std::int64_t>(ClaimedCells));
}

TEST(WideNumbers, ATypeMayHaveMoreThan32BitsOfCells)
{
  CellTable table;
  table.Types = { { 12, std::uint64_t{ 5'000'000'000 } } };
  table.SetShapes(ShapeTable().Write());
  EXPECT_EQ(CellTable::Read(table.Write()).Types, table.Types);
}
