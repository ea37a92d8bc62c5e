// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes are simplified: what must hold after any number of merges, on meshes of several
// topologies.

#include "gatunError.h"
#include "gatunMergeBuilder.h"
#include "gatunMergeLinks.h"
#include "gatunMergeMesh.h"
#include "gatunParallel.h"
#include "gatunPartMerges.h"
#include "gatunTestSolids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace gatun::test
{
namespace
{
using Tet = MergeTree::Tet;

MergeTree BuildWhole(const Solid& solid)
{
  return BuildMergeTree(solid.GetInput());
}

/** Two parts, in groups of some hundred tetrahedra. */
MergeTree BuildInParts(const Solid& solid)
{
  PartMergeSettings settings;
  settings.TetsOfGroup = 400;
  settings.Folder = GATUN_TEST_TEMP;
  return BuildInParts(solid, 2, settings);
}

/** A solid, and how its merges are found. */
using Simplified = std::tuple<const char*, MergeTree (*)(const Solid&)>;

class SimplifiedMesh : public testing::TestWithParam<Simplified>
{
protected:
  const Solid Mesh = MakeSolid(std::get<0>(GetParam()));
  const MergeTree Tree = std::get<1>(GetParam())(Mesh);
};

//------------------------------------------------------------------------------
TEST_P(SimplifiedMesh, IsTheSameAsMergingOneByOne)
{
  const Solid& solid = this->Mesh;
  const MergeTree& tree = this->Tree;
  ASSERT_GT(tree.GetMerges().size(), solid.Points.size() / 2);
  auto tets = solid.Tets;
  std::size_t n = 0;
  for (const Merge& merge : tree.GetMerges())
  {
    for (Tet& tet : tets)
    {
      std::replace(tet.begin(), tet.end(), merge.Point, merge.Into);
    }
    std::erase_if(tets, [](const Tet& tet) { return Simplex(tet.begin(), tet.end()).size() < 4; });
    if (++n % 20 == 0 || n == tree.GetMerges().size())
    {
      EXPECT_EQ(SimplifyAll(solid.Tets, tree, n), tets) << n;
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(SimplifiedMesh, KeepsOrientationBoundaryAndTopology)
{
  const Solid& solid = this->Mesh;
  const MergeTree& tree = this->Tree;
  const auto boundary = GetBoundary(solid.Tets);
  const auto toSimplices = [](const std::vector<Tet>& tets)
  {
    std::set<Simplex> simplices;
    for (const Tet& tet : tets)
    {
      simplices.insert(Simplex(tet.begin(), tet.end()));
    }
    return simplices;
  };
  const int whole = GetEulerCharacteristic(toSimplices(solid.Tets));
  const int surface = GetEulerCharacteristic(boundary);
  const std::size_t all = tree.GetMerges().size();
  for (std::size_t n = 0; n <= all; n += std::max<std::size_t>(1, n > all - 40 ? 1 : all / 12))
  {
    const auto tets = SimplifyAll(solid.Tets, tree, n);
    const auto ancestors = tree.FindAncestors(n);
    ASSERT_FALSE(tets.empty());
    for (const Tet& tet : solid.Tets)
    {
      Tet moved = tet;
      if (Simplify(moved, ancestors))
      {
        EXPECT_GT(GetTetVolume(solid.Points, moved) * GetTetVolume(solid.Points, tet), 0) << n;
      }
    }
    const auto simplices = toSimplices(tets);
    EXPECT_EQ(simplices.size(), tets.size()) << "two tetrahedra in one place after " << n;
    for (const auto& [face, count] : CountFaces(tets))
    {
      EXPECT_LE(count, 2) << n;
    }
    std::set<Simplex> expected;
    for (const Simplex& face : boundary)
    {
      Simplex moved;
      for (const auto point : face)
      {
        moved.insert(ancestors[point]);
      }
      if (moved.size() == 3)
      {
        expected.insert(moved);
      }
    }
    EXPECT_EQ(GetBoundary(tets), expected) << n;
    EXPECT_EQ(GetEulerCharacteristic(simplices), whole) << n;
    EXPECT_EQ(GetEulerCharacteristic(expected), surface) << n;
  }
}

//------------------------------------------------------------------------------
TEST_P(SimplifiedMesh, KeepsItsVolumeWhereOnlyInnerPointsMerge)
{
  const Solid& solid = this->Mesh;
  const MergeTree& tree = this->Tree;
  std::set<std::uint32_t> onBoundary;
  for (const Simplex& face : GetBoundary(solid.Tets))
  {
    onBoundary.insert(face.begin(), face.end());
  }
  double volume = 0;
  for (const Tet& tet : solid.Tets)
  {
    volume += std::abs(GetTetVolume(solid.Points, tet));
  }
  double before = volume;
  std::size_t n = 0;
  for (const Merge& merge : tree.GetMerges())
  {
    ++n;
    EXPECT_TRUE(onBoundary.count(merge.Point) == 0 || onBoundary.count(merge.Into) == 1);
    if (n % 8 != 0)
    {
      continue;
    }
    double now = 0;
    for (const Tet& tet : SimplifyAll(solid.Tets, tree, n))
    {
      now += std::abs(GetTetVolume(solid.Points, tet));
    }
    const bool onlyInner = std::none_of(tree.GetMerges().begin() + static_cast<long>(n - 8),
      tree.GetMerges().begin() + static_cast<long>(n),
      [&](const Merge& m) { return onBoundary.count(m.Point) != 0; });
    if (onlyInner)
    {
      EXPECT_NEAR(now, before, 1e-12 * volume);
    }
    before = now;
  }
}

INSTANTIATE_TEST_SUITE_P(, SimplifiedMesh,
  testing::Combine(testing::Values("Block", "Lattice", "Ring", "Void", "Parts"),
    testing::Values(&BuildWhole, static_cast<MergeTree (*)(const Solid&)>(&BuildInParts))),
  [](const auto& given)
  {
    const bool isWhole = std::get<1>(given.param) == &BuildWhole;
    return std::string(std::get<0>(given.param)) + (isWhole ? "" : "InParts");
  });

//------------------------------------------------------------------------------
TEST(MergeBuilder, LinearDataCostsNothingInside)
{
  Solid solid = MakeSolid("Block");
  for (std::size_t i = 0; i < solid.Points.size(); ++i)
  {
    const Position& p = solid.Points[i];
    solid.Values[i] = 1 + 2 * p[0] - 3 * p[1] + p[2];
  }
  const MergeTree tree = BuildMergeTree(solid.GetInput());
  // 125 of 343 points are inside; all that they cost is that long edges come after short ones.
  std::size_t cheap = 0;
  for (const Merge& merge : tree.GetMerges())
  {
    cheap += merge.Error < 1e-5 ? 1 : 0;
  }
  EXPECT_GE(cheap, 120u);

  // A bump in one place is worth more than anything else inside.
  std::size_t bump = 0;
  for (std::size_t i = 0; i < solid.Points.size(); ++i)
  {
    const Position& p = solid.Points[i];
    bump = std::abs(p[0] - 3) + std::abs(p[1] - 3) + std::abs(p[2] - 3) < 1 ? i : bump;
  }
  ASSERT_NE(bump, 0u);
  solid.Values[bump] += 40;
  const MergeTree second = BuildMergeTree(solid.GetInput());
  const auto at = std::find_if(second.GetMerges().begin(), second.GetMerges().end(),
    [&](const Merge& m) { return m.Point == bump; });
  EXPECT_GT(at - second.GetMerges().begin(), 200);
}

//------------------------------------------------------------------------------
TEST(MergeBuilder, ErrorsAddUp)
{
  const Solid solid = MakeSolid("Block");
  const MergeTree tree = BuildMergeTree(solid.GetInput());
  double last = 0;
  for (const Merge& merge : tree.GetMerges())
  {
    EXPECT_GE(merge.Error, last);
    last = merge.Error;
  }
  // Of two fields alike, each counts half; one without weight does not count.
  const std::vector<double> other(solid.Points.size(), 3);
  MergeInput twice = solid.GetInput();
  twice.Fields.push_back(twice.Fields.front());
  MergeInput ignored = solid.GetInput();
  ignored.Fields.push_back({ other, 0 });
  for (const MergeInput& input : { twice, ignored })
  {
    const MergeTree same = BuildMergeTree(input);
    ASSERT_EQ(same.GetMerges().size(), tree.GetMerges().size());
    EXPECT_NEAR(same.GetMerges()[60].Error, tree.GetMerges()[60].Error, 1e-6);
    EXPECT_NEAR(same.GetMerges().back().Error, last, 0.1 * last);
  }
}

//------------------------------------------------------------------------------
TEST(MergeBuilder, ChangesDoNotCancel)
{
  // Up and down from one layer of points to the next: what merges gain on one side they lose on
  // the other, but no point is free. All else is.
  Solid solid = MakeSolid("Lattice");
  const auto isWavy = [&](std::size_t i) { return solid.Points[i][0] > 2.5; };
  for (std::size_t i = 0; i < solid.Points.size(); ++i)
  {
    const Position& p = solid.Points[i];
    const auto layer = static_cast<int>(std::round(p[0] + p[1] + p[2]));
    solid.Values[i] = isWavy(i) ? (layer % 2 == 0 ? 1 : -1) : 0;
  }
  const MergeTree tree = BuildMergeTree(solid.GetInput());
  for (std::size_t i = 0; i < 60; ++i)
  {
    EXPECT_FALSE(isWavy(tree.GetMerges()[i].Point)) << i;
  }
}

//------------------------------------------------------------------------------
TEST(MergeBuilder, TheSameMeshGivesTheSameTreeByAnyNumberOfThreads)
{
  const Solid solid = MakeSolid("Ring");
  MergeTree first;
  WithNumberOfThreads(1, [&] { first = BuildMergeTree(solid.GetInput()); });
  for (const int threads : { 1, 2, 5 })
  {
    MergeTree second;
    WithNumberOfThreads(threads, [&] { second = BuildMergeTree(solid.GetInput()); });
    ASSERT_EQ(first.GetMerges().size(), second.GetMerges().size());
    for (std::size_t i = 0; i < first.GetMerges().size(); ++i)
    {
      EXPECT_EQ(first.GetMerges()[i].Point, second.GetMerges()[i].Point);
      EXPECT_EQ(first.GetMerges()[i].Into, second.GetMerges()[i].Into);
      EXPECT_EQ(first.GetMerges()[i].Error, second.GetMerges()[i].Error);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MergeBuilder, TakesWhateverMeshesThereAre)
{
  // No mesh, one tetrahedron, one with a point twice, a soup where faces have many sides.
  EXPECT_TRUE(BuildMergeTree({}).GetMerges().empty());
  Solid one{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { 0, 1, 2, 3 } },
    { 1, 2, 3, 4 } };
  EXPECT_TRUE(BuildMergeTree(one.GetInput()).GetMerges().empty());
  one.Tets.push_back({ 0, 1, 2, 2 });
  EXPECT_TRUE(BuildMergeTree(one.GetInput()).GetMerges().empty());

  const auto mesh = MakeSoup(60, 300);
  Solid soup;
  for (std::size_t i = 0; i < mesh.GetPoints(); ++i)
  {
    soup.Points.push_back(
      { mesh.Coordinates[3 * i], mesh.Coordinates[3 * i + 1], mesh.Coordinates[3 * i + 2] });
  }
  for (std::size_t i = 0; i < mesh.GetTets(); ++i)
  {
    auto& tet = soup.Tets.emplace_back();
    for (std::size_t c = 0; c < 4; ++c)
    {
      tet[c] = static_cast<std::uint32_t>(mesh.Ids[4 * i + c]);
    }
  }
  MergeInput input{ soup.Points, soup.Tets, {} };
  const auto tree = BuildMergeTree(input);
  const auto ancestors = tree.FindAncestors(tree.GetMerges().size());
  for (const Tet& tet : soup.Tets)
  {
    Tet moved = tet;
    if (Simplify(moved, ancestors))
    {
      EXPECT_GE(GetTetVolume(soup.Points, moved) * GetTetVolume(soup.Points, tet), 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MergeBuilder, WhatIsNotANumberStays)
{
  for (const bool ofPoints : { false, true })
  {
    Solid solid = MakeSolid("Block");
    constexpr std::uint32_t strange = 171;
    (ofPoints ? solid.Points[strange][1] : solid.Values[strange]) =
      std::numeric_limits<double>::quiet_NaN();
    const auto tree = BuildMergeTree(solid.GetInput());
    EXPECT_GT(tree.GetMerges().size(), 100u);
    for (const Merge& merge : tree.GetMerges())
    {
      EXPECT_NE(merge.Point, strange);
      EXPECT_NE(merge.Into, strange);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MergeBuilder, RefusesInputThatDoesNotFit)
{
  const Solid solid = MakeSolid("Block");
  const auto refuses = [](const MergeInput& input, const MergeSettings& settings = {})
  { EXPECT_THROW(BuildMergeTree(input, settings), Error); };
  MergeInput input = solid.GetInput();
  input.Points = input.Points.subspan(1);
  refuses(input);
  input = solid.GetInput();
  input.Fields[0].Values = input.Fields[0].Values.subspan(1);
  refuses(input);
  for (const double weight : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    input = solid.GetInput();
    input.Fields[0].Weight = weight;
    refuses(input);
    refuses(solid.GetInput(), { MergeMetric::Mass, weight });
    refuses(solid.GetInput(), { MergeMetric::Mass, 0.5, weight });
  }
  int calls = 0;
  EXPECT_THROW(BuildMergeTree(solid.GetInput(), {}, [&](double) { return ++calls < 2; }), Error);
  EXPECT_EQ(calls, 2);
}

//------------------------------------------------------------------------------
/** Makes a tetrahedron with each face of the boundary. */
constexpr std::uint32_t outside = 1000000;

/** What makes a simplex of some tetrahedra together with the given one. */
std::set<Simplex> GetLink(const std::vector<Tet>& tets, const Simplex& of)
{
  std::set<Simplex> whole;
  for (const Tet& tet : tets)
  {
    whole.insert(Simplex(tet.begin(), tet.end()));
  }
  for (Simplex face : GetBoundary(tets))
  {
    face.insert(outside);
    whole.insert(face);
  }
  std::set<Simplex> link;
  for (const Simplex& simplex : whole)
  {
    if (!std::includes(simplex.begin(), simplex.end(), of.begin(), of.end()))
    {
      continue;
    }
    std::vector<std::uint32_t> rest;
    std::set_difference(
      simplex.begin(), simplex.end(), of.begin(), of.end(), std::back_inserter(rest));
    for (unsigned subset = 1; subset < 1u << rest.size(); ++subset)
    {
      Simplex side;
      for (unsigned i = 0; i < rest.size(); ++i)
      {
        if ((subset >> i & 1) != 0)
        {
          side.insert(rest[i]);
        }
      }
      link.insert(side);
    }
  }
  return link;
}

//------------------------------------------------------------------------------
TEST(MergeLinks, MayMergeIsTheLinkCondition)
{
  // Wherever points are: merges that would turn tetrahedra over lead to all sorts of links.
  for (const std::uint32_t seed : { 1u, 2u, 3u })
  {
    const Solid solid = MakeSolid(4, 0, [](const Position& p) { return p[0] != 2 || p[1] != 2; });
    auto tets = solid.Tets;
    MergeMesh mesh(solid.Points.size(), tets);
    MergeLinks links(mesh);
    std::mt19937 random(seed);
    std::size_t refused = 0;
    for (int step = 0; step < 250 && tets.size() > 1; ++step)
    {
      const Tet& tet = tets[random() % tets.size()];
      const auto from = tet[random() % 4];
      const auto into = tet[random() % 4];
      if (from == into)
      {
        continue;
      }
      std::set<Simplex> common;
      const auto first = GetLink(tets, { from });
      const auto second = GetLink(tets, { into });
      std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
        std::inserter(common, common.end()));
      const auto ofEdge = GetLink(tets, { from, into });
      const bool leavesBoundary = first.count({ outside }) == 1 && ofEdge.count({ outside }) == 0;
      const bool expected = common == ofEdge && !leavesBoundary;
      ASSERT_EQ(links.MayMerge(from, into), expected) << step;
      refused += expected ? 0 : 1;
      if (expected)
      {
        mesh.Merge(from, into);
        for (Tet& other : tets)
        {
          std::replace(other.begin(), other.end(), from, into);
        }
        std::erase_if(
          tets, [](const Tet& other) { return Simplex(other.begin(), other.end()).size() < 4; });
      }
    }
    EXPECT_GT(refused, 20u);
  }
}
}
}
