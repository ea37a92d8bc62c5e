// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A file that is simplified while it is drawn: the same image as that of the simplified mesh.

#include "gatunChunkCache.h"
#include "gatunCoarseLayout.h"
#include "gatunCoarseRaySource.h"
#include "gatunError.h"
#include "gatunFileLevelsOfDetail.h"
#include "gatunFileRaySource.h"
#include "gatunMergeBuilder.h"
#include "gatunMergeCut.h"
#include "gatunMergeDependencies.h"
#include "gatunPieceDecoder.h"
#include "gatunRayImages.h"
#include "gatunTestFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace gatun::test
{
namespace
{
/** A mesh, and the values of its cells if these count. */
struct Solid : ReferenceMesh
{
  std::vector<double> CellValues;
};

/** A mesh whose values, by points or by cells, are in a file with a tree. */
class CoarseRays : public testing::TestWithParam<Association>
{
protected:
  void Write(std::int64_t n, std::uint32_t chunkTets, unsigned levels)
  {
    const auto mesh = MakeCubes(n, 0.2);
    this->Mesh = { ToReference(mesh), {} };
    this->Tree =
      BuildMergeTree({ this->Mesh.Points, this->Mesh.Tets, { { this->Mesh.Values, 1 } } });
    std::vector<double> cellValues;
    for (const auto& tet : this->Mesh.Tets)
    {
      cellValues.push_back(this->Mesh.Values[tet[0]]);
    }
    std::vector<ArrayDescription> arrays(1);
    arrays[0].Where = GetParam();
    arrays[0].Type = ScalarType::Float64;
    const bool ofCells = GetParam() == Association::Cell;
    if (ofCells)
    {
      this->Mesh.CellValues = cellValues;
    }
    WriterOptions options;
    options.ChunkSize = chunkTets;
    options.Tree = &this->Tree;
    options.Levels = levels;
    const auto path = TempPath(
      "rays" + std::to_string(n) + "_" + std::to_string(levels) + (ofCells ? "c.gtn" : "p.gtn"));
    FileWriter writer(path, mesh.GetInput(), arrays, options);
    const void* const values = ofCells ? cellValues.data() : this->Mesh.Values.data();
    writer.WriteStep({ &values, 1 });
    writer.Finish();
    this->File = std::make_shared<const FileReader>(path);
  }

  Solid Simplify(std::size_t merges) const
  {
    auto left = this->Mesh;
    left.Tets.clear();
    left.CellValues.clear();
    const auto ancestors = this->Tree.FindAncestors(merges);
    for (std::size_t i = 0; i < this->Mesh.Tets.size(); ++i)
    {
      auto tet = this->Mesh.Tets[i];
      if (gatun::Simplify(tet, ancestors))
      {
        left.Tets.push_back(tet);
        if (!this->Mesh.CellValues.empty())
        {
          left.CellValues.push_back(this->Mesh.CellValues[i]);
        }
      }
    }
    return left;
  }

  /** Draws what is left from everywhere, and also only a part of it. */
  void ExpectSameImages(RaySource& source, std::size_t merges, double size) const
  {
    const auto left = this->Simplify(merges);
    auto viewers = MakeViewers(size, false);
    const auto more = MakeViewers(size, true);
    viewers.resize(2);
    viewers.push_back(more[0]);
    viewers.push_back(viewers[0]);
    viewers.back().Frustum.Near = 0.9 * size;
    viewers.back().Frustum.Far = 1.7 * size;
    for (const auto& viewer : viewers)
    {
      EXPECT_LE(
        GetLargestDifference(Render(left, viewer, {}), RenderSource(source, viewer, Ramp, 0)),
        2.0f / 255)
        << merges;
    }
  }

  CoarseRaySource MakeSource(const MergeTree& tree, MergeCut cut, std::uint64_t budget) const
  {
    return { std::make_shared<ChunkCache>(this->File, budget), tree, std::move(cut), {} };
  }

  Solid Mesh;
  MergeTree Tree;
  std::shared_ptr<const FileReader> File;
};

using Corner = std::array<double, 4>;

/** The corners of all tetrahedra of a source, each with its value; and what its cell has. */
std::multiset<std::pair<std::set<Corner>, double>> GetContent(
  RaySource& source, std::span<const std::size_t> order)
{
  std::multiset<std::pair<std::set<Corner>, double>> content;
  for (const auto index : order)
  {
    const auto block = source.GetBlocks({ &index, 1 }, {}).front();
    for (std::size_t i = 0; i < block->Tets.size(); ++i)
    {
      std::set<Corner> corners;
      for (const auto corner : block->Tets[i])
      {
        const RayPoint& p = block->Points[corner];
        corners.insert(Corner{ p.X, p.Y, p.Z, block->CellValues.empty() ? p.Value : 0 });
      }
      content.insert({ corners, block->CellValues.empty() ? 0 : block->CellValues[i] });
    }
  }
  return content;
}

std::multiset<std::pair<std::set<Corner>, double>> GetContent(const Solid& mesh)
{
  std::multiset<std::pair<std::set<Corner>, double>> content;
  for (std::size_t i = 0; i < mesh.Tets.size(); ++i)
  {
    std::set<Corner> corners;
    for (const auto point : mesh.Tets[i])
    {
      const auto& p = mesh.Points[point];
      corners.insert(Corner{ p[0], p[1], p[2], mesh.CellValues.empty() ? mesh.Values[point] : 0 });
    }
    content.insert({ corners, mesh.CellValues.empty() ? 0 : mesh.CellValues[i] });
  }
  return content;
}

TEST_P(CoarseRays, BlocksHoldWhatIsLeftInWhateverOrderTheyAreMade)
{
  this->Write(8, 100, 0);
  const auto tree = this->File->GetMergeTree();
  const auto all = tree.GetMerges().size();
  for (const std::size_t merges : { std::size_t{ 0 }, all / 5, all / 2, all * 19 / 20, all })
  {
    const auto left = GetContent(this->Simplify(merges));
    for (const std::uint64_t budget : { 0, 100 << 20 })
    {
      auto source = this->MakeSource(tree, MergeCut(tree, merges), budget);
      std::vector<std::size_t> order(source.GetNumberOfBlocks());
      std::iota(order.begin(), order.end(), std::size_t{ 0 });
      std::mt19937 random(7);
      for (int i = 0; i < 2; ++i)
      {
        std::shuffle(order.begin(), order.end(), random);
        EXPECT_EQ(GetContent(source, order), left) << merges;
      }
      // All at once.
      auto again = this->MakeSource(tree, MergeCut(tree, merges), budget);
      std::size_t tets = 0;
      for (const auto& block : again.GetBlocks(order, {}))
      {
        tets += block->Tets.size();
      }
      EXPECT_EQ(tets, left.size());
    }
  }
}

TEST_P(CoarseRays, CutsHoldWhatIsLeftOfTheMesh)
{
  this->Write(8, 100, 0);
  // In the numbers of the file.
  PieceRequest request;
  request.Chunks.resize(this->File->GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.Arrays = { 0 };
  request.WithUnusedPoints = true;
  PieceDecoder decoder(this->File);
  const bool ofCells = GetParam() == Association::Cell;
  const auto decode = [&]
  {
    Solid mesh;
    decoder.SetRequest(request);
    mesh.Points.resize(decoder.GetNumberOfPoints());
    mesh.Tets.resize(decoder.GetNumberOfCells());
    mesh.Values.resize(mesh.Points.size());
    mesh.CellValues.resize(ofCells ? mesh.Tets.size() : 0);
    PieceTarget target;
    target.Points = mesh.Points.data();
    target.Connectivity = mesh.Tets.data();
    target.WideIds = false;
    target.Arrays = { ofCells ? mesh.CellValues.data() : mesh.Values.data() };
    decoder.Fill(target);
    return mesh;
  };
  const Solid whole = decode();

  const auto tree = this->File->GetMergeTree();
  const MergeDependencies dependencies(tree, whole.Tets);
  request.Tree = std::make_shared<const MergeTree>(tree);
  for (const double part : { 0.2, 0.5, 0.8 })
  {
    // Coarse to one side.
    std::vector<bool> wanted(tree.GetMerges().size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      wanted[i] = whole.Points[tree.GetMerges()[i].Point][0] < 8 * part;
    }
    const MergeCut cut(tree, dependencies, wanted);
    ASSERT_FALSE(cut.IsUniform());
    Solid left = whole;
    left.Tets.clear();
    left.CellValues.clear();
    for (std::size_t i = 0; i < whole.Tets.size(); ++i)
    {
      auto tet = whole.Tets[i];
      if (gatun::Simplify(tet, cut.GetAncestors()))
      {
        left.Tets.push_back(tet);
        if (ofCells)
        {
          left.CellValues.push_back(whole.CellValues[i]);
        }
      }
    }
    auto source = this->MakeSource(tree, cut, 100 << 20);
    std::vector<std::size_t> order(source.GetNumberOfBlocks());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    EXPECT_EQ(GetContent(source, order), GetContent(left)) << part;
    const auto blocks = source.GetBlocks(order, {});
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      const auto& box = source.GetBounds(b);
      for (const RayPoint& point : blocks[b]->Points)
      {
        EXPECT_TRUE(box[0].Min <= point.X && point.X <= box[0].Max);
        EXPECT_TRUE(box[1].Min <= point.Y && point.Y <= box[1].Max);
        EXPECT_TRUE(box[2].Min <= point.Z && point.Z <= box[2].Max);
        const Range range = source.GetRange(b);
        EXPECT_TRUE(ofCells || (range.Min <= point.Value && point.Value <= range.Max));
      }
    }
    // As a piece, too.
    request.Merges = cut.GetLast();
    request.Cut = std::make_shared<const CoarseLayout>(decoder.GetFile(), tree, cut);
    EXPECT_EQ(GetContent(decode()), GetContent(left)) << part;
    request.Cut = std::make_shared<const CoarseLayout>(
      std::make_shared<const FileReader>(this->File->GetPath()), tree, cut);
    EXPECT_THROW(decode(), Error);
  }
}

/** The reference for images has values at points only. */
class CoarseImages : public CoarseRays
{
};

TEST_P(CoarseImages, AreThoseOfTheSimplifiedMesh)
{
  this->Write(7, 150, 0);
  const auto tree = this->File->GetMergeTree();
  const auto all = tree.GetMerges().size();
  for (const std::size_t merges : { all / 3, all * 3 / 4, all * 19 / 20 })
  {
    auto source = this->MakeSource(tree, MergeCut(tree, merges), 1 << 20);
    this->ExpectSameImages(source, merges, 7);
  }
}

TEST_P(CoarseRays, DetailComesFromWhatIsNearest)
{
  this->Write(18, 4000, 8); // 34,992 tetrahedra
  FileLevelsOfDetail detail(std::make_shared<SharedFile>(this->File, 100 << 20), {});
  ASSERT_GE(this->File->GetLevels().size(), 1u);
  const auto points = this->Mesh.Points.size();
  const auto merges = this->Tree.GetMerges().size();
  EXPECT_EQ(detail.GetNumberOfPoints(), points);
  EXPECT_EQ(detail.GetFewestPoints(), points - merges);
  for (const std::size_t wanted : { points, points * 4 / 5, points / 2, (points + 1) / 2,
         points / 3, points / 10, points - merges })
  {
    const auto source = detail.MakeLevel({ wanted, {} }, {}).Source;
    std::vector<std::size_t> order(source->GetNumberOfBlocks());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    const auto left = this->Simplify(this->Tree.CountMergesOfRounds(points - wanted));
    EXPECT_EQ(GetContent(*source, order), GetContent(left)) << wanted;
    const auto estimate = static_cast<double>(detail.EstimateTets(wanted));
    EXPECT_NEAR(estimate, static_cast<double>(left.Tets.size()), 0.5 * estimate + 50);
  }
  // From a base mesh fewer chunks are read.
  EXPECT_LT(detail.MakeLevel({ points / 9, {} }, {}).Source->GetNumberOfBlocks(),
    detail.MakeLevel({ points, {} }, {}).Source->GetNumberOfBlocks());
}

INSTANTIATE_TEST_SUITE_P(Values, CoarseImages, testing::Values(Association::Point));
INSTANTIATE_TEST_SUITE_P(
  Values, CoarseRays, testing::Values(Association::Point, Association::Cell));

TEST(CoarseRaysErrors, FilesWithoutATreeAndWrongSelections)
{
  const auto mesh = MakeCubes(3, 0.2);
  const auto path = TempPath("norays.gtn");
  Write(path, mesh, {});
  const auto file = std::make_shared<const FileReader>(path);
  try
  {
    const FileLevelsOfDetail detail(std::make_shared<SharedFile>(file), {});
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
    EXPECT_EQ(std::string(error.what()),
      path + ": there is no hierarchy in the file; make one with gtn pack --hierarchy");
  }
  const auto points = static_cast<std::uint32_t>(mesh.GetPoints());
  const MergeTree tree(points, { { 1, 2, 0.5f } });
  const MergeCut one(tree, 1);
  const auto cache = std::make_shared<ChunkCache>(file, 0);
  EXPECT_NO_THROW(CoarseRaySource(cache, tree, one, {}));
  const MergeTree two(points, { { 1, 2, 0.5f }, { 2, 3, 0.5f } });
  EXPECT_THROW(CoarseRaySource(cache, tree, MergeCut(two, 2), {}), Error);
  const MergeTree more(points + 1, {});
  EXPECT_THROW(CoarseRaySource(cache, more, MergeCut(more, 0), {}), Error);
  EXPECT_THROW(CoarseRaySource(cache, tree, one, { 7, 0, 0 }), Error);
  EXPECT_THROW(CoarseRaySource(cache, tree, one, { 0, 1, 0 }), Error);
  EXPECT_THROW(CoarseRaySource(cache, tree, one, { 0, 0, 1 }), Error);
}
}
}
