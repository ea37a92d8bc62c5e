// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files with a merge tree. A mesh that is read after a number of merges must equal the result of
// merging in memory.

#include "gatunCoarseLayout.h"
#include "gatunFileImage.h"
#include "gatunFileReaderInternals.h"
#include "gatunPieceDecoder.h"
#include "gatunTestTrees.h"
#include "gatunTreeFile.h"
#include "gatunTreeLayout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

namespace gatun::test
{
namespace
{
std::vector<std::size_t> SomeMerges(const MergeTree& tree)
{
  const auto all = tree.GetMerges().size();
  return { 1, all / 10, all / 3, all / 2, all * 9 / 10, all - 1, all };
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
    options.ChunkSize = GetParam().first;
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

TEST_P(TreeFileRead, ChunksChangeWhoseAncestorsChange)
{
  const auto all = this->FileTree->GetMerges().size();
  const auto lay = [&](std::size_t merges)
  { return CoarseLayout(this->File, *this->FileTree, MergeCut(*this->FileTree, merges)); };
  const CoarseLayout layout = lay(0);
  for (const auto& [from, to] : std::vector<std::pair<std::size_t, std::size_t>>{
         { 0, 0 }, { 0, 1 }, { all / 3, all / 3 + 2 }, { all, all / 2 } })
  {
    const auto before = this->FileTree->FindAncestors(from);
    const auto after = this->FileTree->FindAncestors(to);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t chunk = 0; chunk < this->File->GetChunks().size(); ++chunk)
    {
      const auto points = layout.GetPoints(chunk);
      if (std::any_of(points.begin(), points.end(),
            [&](std::uint32_t point) { return before[point] != after[point]; }))
      {
        expected.push_back(chunk);
      }
    }
    ASSERT_EQ(lay(to).FindChanges(lay(from)), expected);
  }
}

TEST_P(TreeFileRead, LayoutSaysWhichChunksGetPointsFromWhich)
{
  const auto chunks = static_cast<std::uint32_t>(this->File->GetChunks().size());
  for (const auto merges : SomeMerges(this->Tree))
  {
    const CoarseLayout layout(this->File, *this->FileTree, MergeCut(*this->FileTree, merges));
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
  const auto mesh = test::FileImage(this->File->GetPath()).Mesh;
  const auto points = static_cast<std::uint32_t>(this->File->GetNumberOfPoints());
  const TreeLayout layout(*this->FileTree, mesh);
  const auto used = points - static_cast<std::uint32_t>(this->File->GetNumberOfUnusedPoints());
  const auto all = static_cast<std::uint32_t>(this->FileTree->GetMerges().size());
  EXPECT_EQ(layout.GetMergeCounts(), (std::vector<std::uint32_t>{ used - used / 2, all }));

  // So that each merge counts, the last one too: values are larger the later a point is gone.
  std::vector<double> values(points, 0);
  for (std::uint32_t i = 0; i < all; ++i)
  {
    values[this->FileTree->GetMerges()[i].Point] = i % 5 == 1 ? std::nan("") : i + 1.0;
    values[this->FileTree->GetMerges()[i].Into] = all + i + 1.0;
  }
  const auto ranges = layout.FindRanges([&](std::uint32_t point) { return values[point]; });
  ASSERT_EQ(ranges.size(), mesh.Chunks.size());
  const CoarseLayout chunks(this->File, *this->FileTree, MergeCut(*this->FileTree, 0));
  std::vector<std::uint32_t> into(points), when(points, all);
  for (std::uint32_t i = 0; i < all; ++i)
  {
    into[this->FileTree->GetMerges()[i].Point] = this->FileTree->GetMerges()[i].Into;
    when[this->FileTree->GetMerges()[i].Point] = i;
  }
  for (std::uint32_t chunk = 0; chunk < ranges.size(); ++chunk)
  {
    for (std::size_t mergeCount = 0; mergeCount < layout.GetMergeCounts().size(); ++mergeCount)
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
          more = when[point] < layout.GetMergeCounts()[mergeCount];
        }
      }
      EXPECT_EQ(ranges[chunk][mergeCount].Min, expected.Min);
      EXPECT_EQ(ranges[chunk][mergeCount].Max, expected.Max);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, TreeFileRead,
  testing::Values(std::pair{ 64u, KeepNone }, std::pair{ 64u, KeepAll },
    std::pair{ 700u, KeepNone }, std::pair{ 100000u, KeepAll }, std::pair{ 300u, KeepPoints },
    std::pair{ 300u, KeepCells }));
}
}
