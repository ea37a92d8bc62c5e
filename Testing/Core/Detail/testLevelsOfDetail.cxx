// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A mesh in memory that is drawn with fewer points: what its sources hold is what merging leaves.

#include "gatunError.h"
#include "gatunMemoryLevelsOfDetail.h"
#include "gatunMemoryRaySource.h"
#include "gatunRayImages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace gatun::test
{
namespace
{
constexpr std::uint64_t PlentyForLevels = std::uint64_t{ 1 } << 30;

/** A mesh with values of its points or of its tetrahedra. */
struct LevelSample
{
  TestMesh Mesh;
  std::vector<double> Values;
  std::vector<unsigned char> Hidden;
  Association Where;

  explicit LevelSample(Association where, std::int64_t n = 8, bool hides = false)
    : LevelSample(where, MakeCubes(n, 0.2), hides)
  {
  }

  LevelSample(Association where, TestMesh mesh, bool hides)
    : Mesh(std::move(mesh))
    , Where(where)
  {
    const bool ofCells = where == Association::Cell;
    for (std::size_t i = 0; i < (ofCells ? this->Mesh.GetTets() : this->Mesh.GetPoints()); ++i)
    {
      const auto p = ofCells ? static_cast<std::size_t>(this->Mesh.Ids[4 * i]) : i;
      this->Values.push_back(
        Wave({ this->Mesh.Coordinates[3 * p], this->Mesh.Coordinates[3 * p + 1],
          this->Mesh.Coordinates[3 * p + 2] }) +
        (ofCells ? 1e-3 * static_cast<double>(i % 7) : 0));
    }
    for (std::size_t i = 0; hides && i < this->Mesh.GetTets(); ++i)
    {
      this->Hidden.push_back(i / 6 % 5 == 0 ? 1 : 0);
    }
  }

  RayValuesInput GetValues() const
  {
    return { this->Where, ScalarType::Float64, 1, 0, this->Values.data() };
  }
  const unsigned char* GetHidden() const
  {
    return this->Hidden.empty() ? nullptr : this->Hidden.data();
  }
  std::shared_ptr<const MemoryRayMesh> MakeMesh() const
  {
    return std::make_shared<const MemoryRayMesh>(
      this->Mesh.GetInput(), this->GetValues(), this->GetHidden());
  }
  MergeTree MakeTree() const { return this->MakeMesh()->BuildTree(); }
  MemoryLevelsOfDetail MakeLevels(MergeTree tree) const
  {
    return { this->MakeMesh(), std::move(tree), PlentyForLevels };
  }
};

/** A tetrahedron as it is drawn: corners with their values, sorted, and the value of its own. */
using Drawn = std::array<double, 17>;

Drawn Describe(std::array<std::array<double, 4>, 4> corners, double value)
{
  std::sort(corners.begin(), corners.end());
  Drawn drawn{};
  for (std::size_t c = 0; c < 4; ++c)
  {
    std::copy(corners[c].begin(), corners[c].end(), drawn.begin() + 4 * c);
  }
  drawn[16] = value;
  return drawn;
}

std::vector<Drawn> Collect(RaySource& source)
{
  std::vector<std::size_t> all(source.GetNumberOfBlocks());
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  std::vector<Drawn> result;
  const auto blocks = source.GetBlocks(all, {});
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const RayBlock& block = *blocks[b];
    Bounds box;
    Range range;
    for (std::size_t i = 0; i < block.Tets.size(); ++i)
    {
      std::array<std::array<double, 4>, 4> corners{};
      for (std::size_t c = 0; c < 4; ++c)
      {
        const RayPoint& p = block.Points[block.Tets[i][c]];
        corners[c] = { p.X, p.Y, p.Z, block.CellValues.empty() ? p.Value : 0 };
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          box[axis].Min = std::min(box[axis].Min, corners[c][axis]);
          box[axis].Max = std::max(box[axis].Max, corners[c][axis]);
        }
        const double value = block.CellValues.empty() ? p.Value : block.CellValues[i];
        range = { std::min(range.Min, value), std::max(range.Max, value) };
      }
      result.push_back(Describe(corners, block.CellValues.empty() ? 0 : block.CellValues[i]));
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(source.GetBounds(b)[axis].Min, box[axis].Min);
      EXPECT_EQ(source.GetBounds(b)[axis].Max, box[axis].Max);
    }
    EXPECT_EQ(source.GetRange(b).Min, range.Min);
    EXPECT_EQ(source.GetRange(b).Max, range.Max);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Drawn> Merge(const LevelSample& sample, const MergeTree& tree, std::uint64_t points)
{
  const auto ancestors = tree.FindAncestors(tree.CountMergesForPoints(points));
  const bool ofCells = sample.Where == Association::Cell;
  std::vector<Drawn> result;
  for (std::size_t i = 0; i < sample.Mesh.GetTets(); ++i)
  {
    MergeTree::Tet tet{};
    for (std::size_t c = 0; c < 4; ++c)
    {
      tet[c] = static_cast<std::uint32_t>(sample.Mesh.Ids[4 * i + c]);
    }
    if (!Simplify(tet, ancestors) || (sample.GetHidden() && sample.Hidden[i] != 0))
    {
      continue;
    }
    std::array<std::array<double, 4>, 4> corners{};
    for (std::size_t c = 0; c < 4; ++c)
    {
      const double* const p = sample.Mesh.Coordinates.data() + 3 * std::size_t{ tet[c] };
      corners[c] = { p[0], p[1], p[2], ofCells ? 0 : sample.Values[tet[c]] };
    }
    result.push_back(Describe(corners, ofCells ? sample.Values[i] : 0));
  }
  std::sort(result.begin(), result.end());
  return result;
}

//------------------------------------------------------------------------------
TEST(LevelsOfDetail, SourcesHoldWhatMergingLeaves)
{
  for (const auto where : { Association::Point, Association::Cell })
  {
    for (const bool hides : { false, true })
    {
      const LevelSample sample(where, 8, hides);
      const MergeTree tree = sample.MakeTree();
      auto detail = sample.MakeLevels(tree);
      ASSERT_EQ(detail.GetNumberOfPoints(), 729u);
      ASSERT_LT(detail.GetFewestPoints(), 300u);
      // Up and down, so that some begin with bases that are there and others do not.
      for (const std::uint64_t points :
        { 200u, 729u, 728u, 500u, 364u, 365u, 363u, 182u, 100u, 4u })
      {
        const auto source = detail.MakeLevel({ points, {} }, {}).Source;
        const auto drawn = Collect(*source);
        EXPECT_EQ(drawn, Merge(sample, tree, points)) << points;
        if (points >= detail.GetFewestPoints())
        {
          EXPECT_EQ(detail.EstimateTets(points), drawn.size()) << points;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(LevelsOfDetail, TetrahedraNeedNotHaveAnyPointInCommon)
{
  for (const std::size_t tets : { 1u, 2u, 3u, 7u, 64u })
  {
    TestMesh mesh = MakeSoup(1000, tets);
    std::iota(mesh.Ids.begin(), mesh.Ids.end(), std::int64_t{ 0 });
    const LevelSample sample(Association::Point, std::move(mesh), false);
    const MergeTree tree(1000, {});
    auto detail = sample.MakeLevels(tree);
    EXPECT_EQ(Collect(*detail.MakeLevel({ 1000, {} }, {}).Source), Merge(sample, tree, 1000));
  }
}

//------------------------------------------------------------------------------
TEST(LevelsOfDetail, TheWholeMeshLooksTheSameToTheLastBit)
{
  const LevelSample sample(Association::Point, 20);
  auto detail = sample.MakeLevels(MergeTree(9261, {}));
  MemoryRaySource plain(sample.Mesh.GetInput(), sample.GetValues(), nullptr, PlentyForLevels);
  const auto whole = detail.MakeLevel({ 9261, {} }, {}).Source;
  ASSERT_GT(plain.GetNumberOfBlocks(), 1u);
  for (const Viewer& viewer : MakeViewers(20, false))
  {
    const Image expected = RenderSource(plain, viewer, Ramp, 1e-3f);
    EXPECT_EQ(RenderSource(*whole, viewer, Ramp, 1e-3f).Colors, expected.Colors);
  }
}

//------------------------------------------------------------------------------
TEST(LevelsOfDetail, NumbersOfTetsAreGuessedBetweenThoseKnown)
{
  const LevelSample sample(Association::Point);
  auto detail = sample.MakeLevels(sample.MakeTree());
  std::uint64_t before = 0;
  for (std::uint64_t points = detail.GetFewestPoints(); points <= 729; points += 50)
  {
    EXPECT_GE(detail.EstimateTets(points), before);
    before = detail.EstimateTets(points);
  }
  EXPECT_EQ(detail.EstimateTets(729), sample.Mesh.GetTets());
  EXPECT_EQ(detail.EstimateTets(PlentyForLevels), sample.Mesh.GetTets());
}

//------------------------------------------------------------------------------
TEST(LevelsOfDetail, ATreeOfAnotherMeshIsRefused)
{
  const LevelSample sample(Association::Point);
  EXPECT_THROW(sample.MakeLevels(MergeTree(728, {})), Error);
  EXPECT_THROW(sample.MakeLevels(MergeTree()), Error);
}

//------------------------------------------------------------------------------
TEST(LevelsOfDetail, SourcesOutliveWhatMadeThem)
{
  const LevelSample sample(Association::Point);
  const MergeTree tree = sample.MakeTree();
  std::shared_ptr<RaySource> source;
  {
    LevelSample original(sample);
    source = original.MakeLevels(tree).MakeLevel({ 300, {} }, {}).Source;
    std::fill(original.Mesh.Ids.begin(), original.Mesh.Ids.end(), -1);
  }
  EXPECT_EQ(Collect(*source), Merge(sample, tree, 300));
}
}
}
