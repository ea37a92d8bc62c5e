// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files with a merge tree. A mesh that is read after a number of merges must equal the result of
// merging in memory.

#include "gatunChunkCache.h"
#include "gatunCoarseLayout.h"
#include "gatunError.h"
#include "gatunFileReaderInternals.h"
#include "gatunMergeBuilder.h"
#include "gatunMergeCodec.h"
#include "gatunPieceDecoder.h"
#include "gatunTestFile.h"
#include "gatunTestMeshes.h"
#include "gatunTreeLayout.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace gatun::test
{
namespace
{
MergeTree BuildTree(const TestMesh& mesh)
{
  std::vector<std::array<double, 3>> points(mesh.GetPoints());
  std::vector<MergeTree::Tet> tets(mesh.GetTets());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::copy_n(&mesh.Coordinates[3 * i], 3, points[i].begin());
  }
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    std::copy_n(&mesh.Ids[4 * i], 4, tets[i].begin());
  }
  const Values values(mesh);
  const std::vector<double> field(values.Field.begin(), values.Field.end());
  return BuildMergeTree({ points, tets, { { field, 1 } } });
}

/** What is left of a mesh and its values: the points in their order, then the tetrahedra. */
struct Left
{
  Left(const TestMesh& mesh, const Values& values, const MergeTree& tree, std::size_t merges)
  {
    const auto ancestors = tree.FindAncestors(merges);
    std::vector<std::int64_t> places(ancestors.size());
    for (std::size_t i = 0; i < ancestors.size(); ++i)
    {
      if (ancestors[i] == i)
      {
        places[i] = static_cast<std::int64_t>(this->PointIds.size());
        this->PointIds.push_back(static_cast<std::int64_t>(i));
        this->Mesh.Coordinates.insert(
          this->Mesh.Coordinates.end(), &mesh.Coordinates[3 * i], &mesh.Coordinates[3 * i] + 3);
        this->Field.push_back(values.Field[i]);
        this->Vector.insert(this->Vector.end(), &values.Vector[3 * i], &values.Vector[3 * i] + 3);
      }
    }
    for (std::size_t t = 0; t < mesh.GetTets(); ++t)
    {
      std::array<std::int64_t, 4> corners{};
      for (std::size_t c = 0; c < 4; ++c)
      {
        corners[c] = places[ancestors[static_cast<std::size_t>(mesh.Ids[4 * t + c])]];
      }
      if (std::set<std::int64_t>(corners.begin(), corners.end()).size() == 4)
      {
        this->CellIds.push_back(static_cast<std::int64_t>(t));
        this->Mesh.Ids.insert(this->Mesh.Ids.end(), corners.begin(), corners.end());
        this->Material.push_back(values.Material[t]);
      }
    }
  }

  TestMesh Mesh;
  std::vector<float> Field;
  std::vector<double> Vector;
  std::vector<std::int32_t> Material;
  std::vector<std::int64_t> PointIds, CellIds;
};

/** Cubes, and two points that no tetrahedron has. */
TestMesh MakeMesh(std::int64_t n)
{
  auto mesh = MakeCubes(n, 0.2);
  mesh.Coordinates.insert(mesh.Coordinates.begin(), { 50, 51, 52 });
  mesh.Coordinates.insert(mesh.Coordinates.end(), { 60, 61, 62 });
  for (auto& id : mesh.Ids)
  {
    ++id;
  }
  return mesh;
}

std::vector<std::size_t> SomeMerges(const MergeTree& tree)
{
  const auto all = tree.GetMerges().size();
  return { 1, all / 10, all / 3, all / 2, all * 9 / 10, all - 1, all };
}

void ExpectSame(const MergeTree& a, const MergeTree& b)
{
  ASSERT_EQ(a.GetNumberOfPoints(), b.GetNumberOfPoints());
  ASSERT_EQ(a.GetMerges().size(), b.GetMerges().size());
  for (std::size_t i = 0; i < a.GetMerges().size(); ++i)
  {
    const Merge& x = a.GetMerges()[i];
    const Merge& y = b.GetMerges()[i];
    ASSERT_TRUE(x.Point == y.Point && x.Into == y.Into && x.Error == y.Error) << i;
  }
}

/** Merges of any points into any others, with errors of all magnitudes. */
MergeTree MakeWildTree(std::uint32_t points, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::uint32_t> left(points);
  std::iota(left.begin(), left.end(), 0u);
  std::shuffle(left.begin(), left.end(), random);
  std::vector<Merge> merges;
  const float errors[] = { 0, std::numeric_limits<float>::denorm_min(), 1e-20f, 1, 1e30f,
    std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity() };
  while (left.size() > 1)
  {
    const auto point = left.back();
    left.pop_back();
    const auto done = merges.size() * std::size(errors) / points;
    merges.push_back({ point, left[random() % left.size()], errors[done] });
  }
  return { points, std::move(merges) };
}

TEST(TreeFile, StreamOfMergesGivesThemBack)
{
  for (const std::uint32_t points : { 0u, 1u, 2u, 3u, 4u, 5u, 7u, 8u, 9u, 1000u, 65537u })
  {
    const auto tree = MakeWildTree(points, points);
    const auto stream = EncodeMerges(tree, points);
    ExpectSame(
      tree, DecodeMerges(stream, points, static_cast<std::uint32_t>(tree.GetMerges().size())));
  }
}

TEST(TreeFile, DamagedStreamsOfMergesAreRefusedOrGiveATree)
{
  const auto tree = MakeWildTree(500, 5);
  const auto good = EncodeMerges(tree, 500);
  std::mt19937 random(3);
  std::size_t refused = 0;
  for (int i = 0; i < 3000; ++i)
  {
    auto bad = good;
    if (i % 3 == 0)
    {
      bad.resize(random() % bad.size());
    }
    else
    {
      bad[random() % bad.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
    }
    try
    {
      const auto other = DecodeMerges(bad, 500, 499);
      EXPECT_EQ(other.GetMerges().size(), 499u); // checked by its constructor
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Corrupt);
      ++refused;
    }
  }
  EXPECT_GT(refused, 2000u);
  EXPECT_THROW(DecodeMerges(good, 498, 499), Error);
}

class TreeFileRead : public testing::TestWithParam<std::pair<std::uint32_t, std::uint8_t>>
{
protected:
  TreeFileRead()
    : Mesh(MakeMesh(8))
    , Tree(BuildTree(Mesh))
    , Path(TempPath("tree" + std::to_string(GetParam().first) + "_" +
        std::to_string(GetParam().second) + ".gtn"))
  {
    WriterOptions options;
    options.ChunkTets = GetParam().first;
    options.Keep = GetParam().second;
    options.Tree = &this->Tree;
    Write(this->Path, this->Mesh, options, 2);
    this->File = std::make_shared<const FileReader>(this->Path);
    this->FileTree = std::make_shared<const MergeTree>(this->File->GetMergeTree());
  }

  PieceRequest Ask(std::size_t merges) const
  {
    auto request = AskForAll(*this->File);
    request.Merges = merges;
    request.Tree = this->FileTree;
    return request;
  }

  TestMesh Mesh;
  MergeTree Tree;
  std::string Path;
  std::shared_ptr<const FileReader> File;
  std::shared_ptr<const MergeTree> FileTree;
};

TEST_P(TreeFileRead, SimplifiedMeshIsThatOfTheTree)
{
  ASSERT_EQ(this->FileTree->GetMerges().size(), this->Tree.GetMerges().size());
  for (std::size_t i = 0; i < this->Tree.GetMerges().size(); ++i)
  {
    ASSERT_EQ(this->FileTree->GetMerges()[i].Error, this->Tree.GetMerges()[i].Error);
  }
  PieceDecoder decoder(this->File);
  for (const auto merges : SomeMerges(this->Tree))
  {
    for (const std::size_t step : { 0, 1 })
    {
      auto request = this->Ask(merges);
      request.Step = step;
      const Piece piece(decoder, request);
      const Left left(
        this->Mesh, Values(this->Mesh, 0.25 * static_cast<double>(step)), this->Tree, merges);
      ASSERT_EQ(piece.Mesh.GetPoints(), this->Mesh.GetPoints() - merges);
      ASSERT_EQ(piece.Mesh.GetTets(), left.Mesh.GetTets()) << merges;
      EXPECT_EQ(GetCells(piece.Mesh, piece), GetCells(left.Mesh, left)) << merges;
      EXPECT_EQ(std::count(piece.PointGhosts.begin(), piece.PointGhosts.end(), 0),
        static_cast<std::ptrdiff_t>(piece.PointGhosts.size()));
      if (GetParam().second & KeepPoints)
      {
        EXPECT_EQ(piece.PointIds, left.PointIds);
        EXPECT_EQ(piece.Mesh.Coordinates, left.Mesh.Coordinates);
        EXPECT_EQ(piece.Field, left.Field);
        EXPECT_EQ(piece.Vector, left.Vector);
      }
      if (GetParam().second & KeepCells)
      {
        EXPECT_EQ(piece.CellIds, left.CellIds);
        EXPECT_EQ(piece.Material, left.Material);
      }
    }
  }
}

TEST_P(TreeFileRead, PiecesMakeUpTheWhole)
{
  const auto chunks = this->File->GetChunks().size();
  for (const auto merges : SomeMerges(this->Tree))
  {
    PieceDecoder all(this->File);
    const Piece whole(all, this->Ask(merges));
    std::multiset<CellContent> cells;
    std::multiset<std::int64_t> owned;
    for (std::size_t i = 0; i < 3; ++i)
    {
      auto request = this->Ask(merges);
      request.Chunks.clear();
      for (auto c = chunks * i / 3; c < chunks * (i + 1) / 3; ++c)
      {
        request.Chunks.push_back(static_cast<std::uint32_t>(c));
      }
      request.WithUnusedPoints = i == 0;
      PieceDecoder decoder(this->File);
      const Piece piece(decoder, request);
      cells.merge(GetCells(piece.Mesh, piece));
      for (std::size_t p = 0; p < piece.PointIds.size(); ++p)
      {
        if (piece.PointGhosts[p] == 0)
        {
          owned.insert(piece.PointIds[p]);
        }
      }
    }
    EXPECT_EQ(cells, GetCells(whole.Mesh, whole)) << merges;
    EXPECT_EQ(owned, std::multiset<std::int64_t>(whole.PointIds.begin(), whole.PointIds.end()));
  }
}

TEST_P(TreeFileRead, GhostsAreThoseAroundThePieceThatIsLeft)
{
  const auto merges = this->Tree.GetMerges().size() / 2;
  PieceDecoder all(this->File);
  const Piece whole(all, this->Ask(merges));
  for (const unsigned levels : { 1u, 2u })
  {
    auto request = this->Ask(merges);
    request.Chunks = { static_cast<std::uint32_t>(this->File->GetChunks().size() / 2) };
    request.WithUnusedPoints = false;
    PieceDecoder alone(this->File);
    const Piece inner(alone, request);
    request.GhostLevels = levels;
    PieceDecoder decoder(this->File);
    const Piece piece(decoder, request);

    std::set<std::int64_t> cells(inner.CellIds.begin(), inner.CellIds.end());
    const auto own = cells;
    std::set<std::int64_t> points;
    for (unsigned level = 0; level <= levels; ++level)
    {
      for (std::size_t t = 0; t < whole.CellIds.size(); ++t)
      {
        const auto* corners = &whole.Mesh.Ids[4 * t];
        if (level > 0 &&
          std::any_of(corners, corners + 4, [&](std::int64_t p) { return points.count(p); }))
        {
          cells.insert(whole.CellIds[t]);
        }
      }
      for (std::size_t t = 0; t < whole.CellIds.size(); ++t)
      {
        if (cells.count(whole.CellIds[t]))
        {
          points.insert(&whole.Mesh.Ids[4 * t], &whole.Mesh.Ids[4 * t] + 4);
        }
      }
    }
    EXPECT_EQ(piece.CellIds.size(), cells.size());
    EXPECT_EQ(std::set<std::int64_t>(piece.CellIds.begin(), piece.CellIds.end()), cells);
    for (std::size_t t = 0; t < piece.CellIds.size(); ++t)
    {
      EXPECT_EQ(piece.CellGhosts[t] == 0, own.count(piece.CellIds[t]) == 1);
    }
    std::map<std::int64_t, std::size_t> placeInWhole;
    for (std::size_t i = 0; i < whole.PointIds.size(); ++i)
    {
      placeInWhole[whole.PointIds[i]] = i;
    }
    for (std::size_t i = 0; i < piece.PointIds.size(); ++i)
    {
      const auto at = placeInWhole.at(piece.PointIds[i]);
      EXPECT_EQ(piece.Field[i], whole.Field[at]);
      EXPECT_EQ(piece.Mesh.Coordinates[3 * i + 1], whole.Mesh.Coordinates[3 * at + 1]);
    }
  }
}

TEST_P(TreeFileRead, PiecesOfAPartOfTheFileOwnItsPoints)
{
  // Which chunks have a point, as they are without merges.
  const auto chunks = static_cast<std::uint32_t>(this->File->GetChunks().size());
  std::map<std::int64_t, std::vector<std::uint32_t>> users;
  for (std::uint32_t chunk = 0; chunk < chunks; ++chunk)
  {
    auto request = AskForAll(*this->File);
    request.Chunks = { chunk };
    request.WithUnusedPoints = false;
    PieceDecoder decoder(this->File);
    const Piece piece(decoder, request);
    for (const auto id : piece.PointIds)
    {
      users[id].push_back(chunk);
    }
  }
  std::vector<std::uint32_t> universe;
  for (std::uint32_t chunk = 0; chunk < chunks; ++chunk)
  {
    if (chunk % 3 != 0 || chunks == 1)
    {
      universe.push_back(chunk);
    }
  }
  for (const auto merges : SomeMerges(this->Tree))
  {
    PieceDecoder all(this->File);
    const Piece whole(all, this->Ask(merges));
    std::map<std::int64_t, std::size_t> placeInWhole;
    for (std::size_t i = 0; i < whole.PointIds.size(); ++i)
    {
      placeInWhole[whole.PointIds[i]] = i;
    }
    std::multiset<std::int64_t> owned;
    for (const bool first : { true, false })
    {
      auto request = this->Ask(merges);
      request.Universe = universe;
      const auto half = universe.begin() + static_cast<std::ptrdiff_t>(universe.size() / 2);
      request.Chunks.assign(first ? universe.begin() : half, first ? half : universe.end());
      request.WithUnusedPoints = first;
      PieceDecoder decoder(this->File);
      const Piece piece(decoder, request);
      if ((GetParam().second & KeepPoints) == 0)
      {
        // Then these are the file's numbers, the order of which it has.
        EXPECT_TRUE(std::is_sorted(piece.PointIds.begin(), piece.PointIds.end()));
      }
      for (std::size_t i = 0; i < piece.PointIds.size(); ++i)
      {
        const auto at = placeInWhole.at(piece.PointIds[i]);
        ASSERT_EQ(piece.Field[i], whole.Field[at]);
        ASSERT_EQ(piece.Vector[3 * i + 2], whole.Vector[3 * at + 2]);
        if (piece.PointGhosts[i] == 0)
        {
          owned.insert(piece.PointIds[i]);
        }
      }
    }
    std::multiset<std::int64_t> expected;
    for (const auto id : whole.PointIds)
    {
      const auto found = users.find(id);
      if (found == users.end() ||
        std::any_of(found->second.begin(), found->second.end(),
          [&](std::uint32_t chunk)
          { return std::binary_search(universe.begin(), universe.end(), chunk); }))
      {
        expected.insert(id);
      }
    }
    EXPECT_EQ(owned, expected) << merges;
  }
}

TEST_P(TreeFileRead, GhostsComeFromTheUniverseOnly)
{
  const auto chunks = static_cast<std::uint32_t>(this->File->GetChunks().size());
  const auto merges = this->Tree.GetMerges().size() / 3;
  auto request = this->Ask(merges);
  request.WithUnusedPoints = false;
  std::erase_if(request.Chunks, [](std::uint32_t chunk) { return chunk % 4 == 1; });
  PieceDecoder all(this->File);
  const Piece whole(all, request);
  request.Universe = request.Chunks;
  request.Chunks = { chunks > 2 ? 2u : 0u };
  PieceDecoder alone(this->File);
  const Piece inner(alone, request);
  request.GhostLevels = 1;
  PieceDecoder decoder(this->File);
  const Piece piece(decoder, request);

  const std::set<std::int64_t> own(inner.CellIds.begin(), inner.CellIds.end());
  std::set<std::int64_t> points;
  for (std::size_t t = 0; t < inner.CellIds.size(); ++t)
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      points.insert(inner.PointIds[static_cast<std::size_t>(inner.Mesh.Ids[4 * t + corner])]);
    }
  }
  auto cells = own;
  for (std::size_t t = 0; t < whole.CellIds.size(); ++t)
  {
    const auto* const corners = &whole.Mesh.Ids[4 * t];
    if (std::any_of(corners, corners + 4,
          [&](std::int64_t corner)
          { return points.count(whole.PointIds[static_cast<std::size_t>(corner)]) == 1; }))
    {
      cells.insert(whole.CellIds[t]);
    }
  }
  EXPECT_EQ(piece.CellIds.size(), cells.size());
  EXPECT_EQ(std::set<std::int64_t>(piece.CellIds.begin(), piece.CellIds.end()), cells);
  // Points that only ghosts have come last, and are not the piece's.
  ASSERT_GE(piece.PointIds.size(), inner.PointIds.size());
  EXPECT_TRUE(std::equal(inner.PointIds.begin(), inner.PointIds.end(), piece.PointIds.begin()));
  std::multiset<std::int64_t> ownPoints, ownOfInner;
  for (std::size_t i = 0; i < piece.PointIds.size(); ++i)
  {
    if (piece.PointGhosts[i] == 0)
    {
      ownPoints.insert(piece.PointIds[i]);
    }
  }
  for (std::size_t i = 0; i < inner.PointIds.size(); ++i)
  {
    if (inner.PointGhosts[i] == 0)
    {
      ownOfInner.insert(inner.PointIds[i]);
    }
  }
  EXPECT_EQ(ownPoints, ownOfInner);
}

TEST_P(TreeFileRead, OrderOfTheFileIsThatOfItsNumbers)
{
  const auto merges = this->Tree.GetMerges().size() / 2;
  auto request = AskForAll(*this->File);
  request.RestoreOrder = false;
  PieceDecoder decoder(this->File);
  const Piece full(decoder, request);
  request.Tree = this->FileTree;
  request.Merges = merges;
  const Piece piece(decoder, request);
  const auto ancestors = this->FileTree->FindAncestors(merges);
  std::vector<std::int64_t> points, cells;
  for (std::size_t i = 0; i < ancestors.size(); ++i)
  {
    if (ancestors[i] == i)
    {
      points.push_back(full.PointIds[i]);
    }
  }
  for (std::size_t t = 0; t < full.CellIds.size(); ++t)
  {
    std::set<std::uint32_t> corners;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      corners.insert(ancestors[static_cast<std::size_t>(full.Mesh.Ids[4 * t + corner])]);
    }
    if (corners.size() == 4)
    {
      cells.push_back(full.CellIds[t]);
    }
  }
  EXPECT_EQ(piece.PointIds, points);
  EXPECT_EQ(piece.CellIds, cells);
  // All chunks, but not the unused points: no order can be restored.
  request.RestoreOrder = true;
  request.WithUnusedPoints = false;
  const Piece used(decoder, request);
  EXPECT_EQ(used.CellIds, cells);
  EXPECT_EQ(used.PointIds.size() + this->File->GetNumberOfUnusedPoints(), points.size());
}

TEST_P(TreeFileRead, BoundsAndRangesOfChunksHold)
{
  for (const auto merges : SomeMerges(this->Tree))
  {
    for (std::uint32_t chunk = 0; chunk < this->File->GetChunks().size(); ++chunk)
    {
      auto request = this->Ask(merges);
      request.Chunks = { chunk };
      request.WithUnusedPoints = false;
      request.Step = 1;
      PieceDecoder decoder(this->File);
      const Piece piece(decoder, request);
      const auto& box = this->File->GetChunkBounds(chunk, merges);
      const auto& field = this->File->GetChunkRanges(0, 1, chunk, merges);
      const auto& vector = this->File->GetChunkRanges(1, 1, chunk, merges);
      for (std::size_t p = 0; p < piece.Mesh.GetPoints(); ++p)
      {
        const double* const x = &piece.Mesh.Coordinates[3 * p];
        const double* const v = &piece.Vector[3 * p];
        for (unsigned axis = 0; axis < 3; ++axis)
        {
          ASSERT_TRUE(box[axis].Min <= x[axis] && x[axis] <= box[axis].Max);
          ASSERT_TRUE(vector[axis].Min <= v[axis] && v[axis] <= vector[axis].Max);
        }
        ASSERT_TRUE(field[0].Min <= piece.Field[p] && piece.Field[p] <= field[0].Max);
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        ASSERT_TRUE(vector[3].Min <= length && length <= vector[3].Max);
      }
    }
  }
}

TEST_P(TreeFileRead, LayoutSaysWhichChunksGetPointsFromWhich)
{
  const auto chunks = static_cast<std::uint32_t>(this->File->GetChunks().size());
  for (const auto merges : SomeMerges(this->Tree))
  {
    const CoarseLayout layout(this->File, *this->FileTree, merges);
    ASSERT_EQ(layout.GetAncestors(), this->FileTree->FindAncestors(merges));
    std::vector<std::set<std::uint32_t>> points, given(chunks);
    std::map<std::uint32_t, std::uint32_t> giverOf; // the first chunk that has a point
    for (std::uint32_t chunk = 0; chunk < chunks; ++chunk)
    {
      const auto list = layout.GetPoints(chunk);
      points.emplace_back(list.begin(), list.end());
      ASSERT_EQ(points.back().size(), list.size());
      for (const auto point : list)
      {
        giverOf.emplace(point, chunk);
      }
    }
    for (const auto& [point, giver] : giverOf)
    {
      ASSERT_EQ(layout.GetGiver(point), giver);
    }
    for (std::uint32_t chunk = 0; chunk < chunks; ++chunk)
    {
      std::set<std::uint32_t> sources;
      for (std::uint32_t point = 0; point < this->File->GetNumberOfPoints(); ++point)
      {
        ASSERT_EQ(layout.Has(chunk, point), points[chunk].count(point) == 1)
          << chunk << " " << point;
      }
      for (const auto point : points[chunk])
      {
        const auto ancestor = layout.GetAncestors()[point];
        if (points[chunk].count(ancestor) == 0)
        {
          sources.insert(giverOf.at(ancestor));
          given[giverOf.at(ancestor)].insert(ancestor);
        }
      }
      const auto found = layout.GetSources(chunk);
      EXPECT_TRUE(std::equal(found.begin(), found.end(), sources.begin(), sources.end()));
    }
    for (std::uint32_t chunk = 0; chunk < chunks; ++chunk)
    {
      const auto found = layout.GetGiven(chunk);
      EXPECT_TRUE(std::equal(found.begin(), found.end(), given[chunk].begin(), given[chunk].end()));
    }
  }
}

TEST_P(TreeFileRead, RangesAreThoseOfAllThatPointsAreMergedInto)
{
  const MeshTable& mesh = InternalsOf(*this->File).Mesh;
  const auto points = static_cast<std::uint32_t>(this->File->GetNumberOfPoints());
  // The tree in other numbers, which the layout has to undo.
  std::vector<std::uint32_t> ids(points);
  std::iota(ids.begin(), ids.end(), 0u);
  std::shuffle(ids.begin(), ids.end(), std::mt19937(7));
  auto merges = this->FileTree->GetMerges();
  for (Merge& merge : merges)
  {
    merge.Point = ids[merge.Point];
    merge.Into = ids[merge.Into];
  }
  const TreeLayout layout(MergeTree(points, merges), ids, mesh);
  ExpectSame(layout.GetTree(), *this->FileTree);

  const auto used = points - static_cast<std::uint32_t>(this->File->GetNumberOfUnusedPoints());
  const auto all = static_cast<std::uint32_t>(merges.size());
  EXPECT_EQ(layout.GetRungs(), (std::vector<std::uint32_t>{ used - used / 2, all }));

  // So that each merge counts, the last one too: values are larger the later a point is gone.
  std::vector<double> values(points, 0);
  for (std::uint32_t i = 0; i < all; ++i)
  {
    values[this->FileTree->GetMerges()[i].Point] = i % 5 == 1 ? std::nan("") : i + 1.0;
    values[this->FileTree->GetMerges()[i].Into] = all + i + 1.0;
  }
  std::vector<double> valueOf(points);
  for (std::uint32_t i = 0; i < points; ++i)
  {
    valueOf[ids[i]] = values[i];
  }
  const auto ranges = layout.FindRanges([&](std::uint32_t point) { return valueOf[point]; });
  ASSERT_EQ(ranges.size(), mesh.Chunks.size());
  const CoarseLayout chunks(this->File, *this->FileTree, 0);
  std::vector<std::uint32_t> into(points), when(points, all);
  for (std::uint32_t i = 0; i < all; ++i)
  {
    into[this->FileTree->GetMerges()[i].Point] = this->FileTree->GetMerges()[i].Into;
    when[this->FileTree->GetMerges()[i].Point] = i;
  }
  for (std::uint32_t chunk = 0; chunk < ranges.size(); ++chunk)
  {
    for (std::size_t rung = 0; rung < layout.GetRungs().size(); ++rung)
    {
      Range expected;
      for (auto point : chunks.GetPoints(chunk))
      {
        for (bool more = true; more; point = into[point])
        {
          if (!std::isnan(values[point]))
          {
            expected.Min = std::min(expected.Min, values[point]);
            expected.Max = std::max(expected.Max, values[point]);
          }
          more = when[point] < layout.GetRungs()[rung];
        }
      }
      EXPECT_EQ(ranges[chunk][rung].Min, expected.Min);
      EXPECT_EQ(ranges[chunk][rung].Max, expected.Max);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, TreeFileRead,
  testing::Values(std::pair{ 64u, KeepNone }, std::pair{ 64u, KeepAll },
    std::pair{ 700u, KeepNone }, std::pair{ 100000u, KeepAll }, std::pair{ 300u, KeepPoints },
    std::pair{ 300u, KeepCells }));

TEST(TreeFile, BaseMeshesAreWhatIsLeft)
{
  const auto mesh = MakeMesh(22); // 63,888 tetrahedra
  const auto tree = BuildTree(mesh);
  const auto path = TempPath("levels.gtn");
  WriterOptions options;
  options.ChunkTets = 5000;
  options.Tree = &tree;
  options.Levels = 8;
  Write(path, mesh, options, 2);
  const auto file = std::make_shared<const FileReader>(path);
  ASSERT_GE(file->GetLevels().size(), 2u);
  EXPECT_TRUE(VerifyFile(*file));
  for (std::size_t i = 0; i < file->GetLevels().size(); ++i)
  {
    const auto level = file->OpenLevel(i);
    const auto merges = file->GetLevels()[i];
    const auto half = (mesh.GetPoints() + (std::size_t{ 2 } << i) - 1) >> (i + 1);
    EXPECT_EQ(level->GetNumberOfPoints(), half);
    const auto rest = std::make_shared<const MergeTree>(level->GetMergeTree());
    EXPECT_EQ(rest->GetMerges().size(), tree.GetMerges().size() - merges);
    for (const std::size_t more : { std::size_t{ 0 }, rest->GetMerges().size() / 3 })
    {
      auto request = AskForAll(*level);
      request.Step = 1;
      request.Merges = more;
      request.Tree = rest;
      PieceDecoder decoder(level);
      const Piece piece(decoder, request);
      const Left left(mesh, Values(mesh, 0.25), tree, merges + more);
      EXPECT_EQ(piece.Mesh.GetPoints(), left.Mesh.GetPoints());
      EXPECT_EQ(GetCells(piece.Mesh, piece), GetCells(left.Mesh, left)) << i << " " << more;
    }
  }
}

TEST(TreeFile, MoreMergesThanThereAreAreRefused)
{
  const auto mesh = MakeMesh(4);
  const auto tree = BuildTree(mesh);
  const auto path = TempPath("few.gtn");
  WriterOptions options;
  options.Tree = &tree;
  Write(path, mesh, options);
  const FileReader file(path);
  const auto all = file.GetNumberOfMerges();
  EXPECT_NO_THROW(file.GetChunkBounds(0, all));
  EXPECT_NO_THROW(file.GetChunkRanges(0, 0, 0, all));
  EXPECT_THROW(file.GetChunkBounds(0, all + 1), Error);
  EXPECT_THROW(file.GetChunkRanges(0, 0, 0, all + 1), Error);
  EXPECT_NO_THROW(file.GetChunkRanges(2, 0, 0, all + 1)); // values of cells stay as they are
  EXPECT_THROW(file.OpenLevel(0), Error);
}

TEST(TreeFile, MeshesThatCannotBeSimplifiedHaveATreeWithoutMerges)
{
  const auto mesh = MakeSoup(40, 200);
  const MergeTree tree(40, {});
  const auto path = TempPath("stiff.gtn");
  WriterOptions options;
  options.Tree = &tree;
  options.Levels = 3;
  Write(path, mesh, options);
  const FileReader file(path);
  EXPECT_TRUE(file.HasMergeTree());
  EXPECT_EQ(file.GetNumberOfMerges(), 0u);
  EXPECT_TRUE(file.GetLevels().empty());
  EXPECT_EQ(file.GetMergeTree().GetNumberOfPoints(), 40u);
  EXPECT_TRUE(VerifyFile(file));
}

TEST(TreeFile, FilesWithoutATreeSayThatThereIsNone)
{
  const auto mesh = MakeMesh(3);
  const auto path = TempPath("notree.gtn");
  Write(path, mesh, {});
  const auto file = std::make_shared<const FileReader>(path);
  EXPECT_FALSE(file->HasMergeTree());
  EXPECT_EQ(file->GetNumberOfMerges(), 0u);
  EXPECT_TRUE(file->GetLevels().empty());
  EXPECT_EQ(file->GetFormatVersion(), (std::pair{ 1, 0 }));
  auto request = AskForAll(*file);
  request.Merges = 1;
  PieceDecoder decoder(file);
  EXPECT_THROW(decoder.SetRequest(request), Error);
  request.Tree = std::make_shared<const MergeTree>(file->GetMergeTree());
  EXPECT_THROW(decoder.SetRequest(request), Error);
}

TEST(TreeFile, TreesOfOtherMeshesAreRefused)
{
  const auto mesh = MakeMesh(3);
  const auto tree = MakeWildTree(static_cast<std::uint32_t>(mesh.GetPoints() + 1), 1);
  WriterOptions options;
  options.Tree = &tree;
  EXPECT_THROW(Write(TempPath("other.gtn"), mesh, options), Error);
  options.Tree = nullptr;
  options.Levels = 1;
  EXPECT_THROW(Write(TempPath("other.gtn"), mesh, options), Error);
}
}
}
