// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes are simplified more in some places than in others.

#include "gatunError.h"
#include "gatunMergeBuilder.h"
#include "gatunMergeCut.h"
#include "gatunMergeDependencies.h"
#include "gatunParallel.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>

namespace gatun::test
{
namespace
{
using Tet = MergeTree::Tet;
using Vec = std::array<double, 3>;

/** A cube with round sides, so that the boundary is curved. */
struct Ball
{
  std::vector<Vec> Points;
  std::vector<Tet> Tets;
  MergeTree Tree;
  MergeDependencies Dependencies;

  explicit Ball(std::int64_t n, unsigned seed = 1)
  {
    const auto mesh = MakeCubes(n, 0.25, seed);
    std::vector<double> values;
    for (std::size_t i = 0; i < mesh.GetPoints(); ++i)
    {
      Vec p{};
      double largest = 0;
      double length = 0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        p[c] = 2 * mesh.Coordinates[3 * i + c] / static_cast<double>(n) - 1;
        largest = std::max(largest, std::abs(p[c]));
        length = std::hypot(length, p[c]);
      }
      for (double& x : p)
      {
        x *= length > 0 ? 0.5 + 0.5 * largest / length : 1;
      }
      this->Points.push_back(p);
      values.push_back(std::sin(4 * p[0]) * std::cos(3 * p[1]) + p[2] * p[2]);
    }
    for (std::size_t i = 0; i < mesh.GetTets(); ++i)
    {
      Tet tet{};
      std::copy_n(&mesh.Ids[4 * i], 4, tet.begin());
      if (GetVolume(tet) < 0)
      {
        std::swap(tet[0], tet[1]);
      }
      this->Tets.push_back(tet);
    }
    this->Tree = BuildMergeTree({ this->Points, this->Tets, { { values, 1 } } });
    this->Dependencies = MergeDependencies(this->Tree, this->Tets);
  }

  /** Six times the volume of the tetrahedron with a corner replaced. */
  double GetVolume(const Tet& tet, std::size_t corner = 4, const Vec& by = {}) const
  {
    std::array<Vec, 4> p{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      p[i] = i == corner ? by : this->Points[tet[i]];
    }
    std::array<Vec, 3> u{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        u[i][c] = p[i + 1][c] - p[0][c];
      }
    }
    return u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) +
      u[0][1] * (u[1][2] * u[2][0] - u[1][0] * u[2][2]) +
      u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0]);
  }

  /** Merges that are wanted: those with a place and a rank, from 0 to 1, for which this is so. */
  std::vector<bool> Want(const std::function<bool(const Vec&, double)>& isWanted) const
  {
    const auto& merges = this->Tree.GetMerges();
    std::vector<bool> wanted(merges.size());
    for (std::size_t i = 0; i < merges.size(); ++i)
    {
      wanted[i] = isWanted(
        this->Points[merges[i].Point], static_cast<double>(i) / static_cast<double>(merges.size()));
    }
    return wanted;
  }

  std::vector<Tet> Simplify(const std::vector<std::uint32_t>& ancestors) const
  {
    auto tets = this->Tets;
    std::erase_if(tets, [&](Tet& tet) { return !gatun::Simplify(tet, ancestors); });
    return tets;
  }

  /** How many places, of some random ones, lie in more than one tetrahedron. */
  std::size_t CountCoveredTwice(const std::vector<Tet>& tets) const
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    std::size_t twice = 0;
    for (int i = 0; i < 4000; ++i)
    {
      const Vec p{ any(random), any(random), any(random) };
      std::size_t covered = 0;
      for (const Tet& tet : tets)
      {
        bool isIn = true;
        for (std::size_t corner = 0; corner < 4 && isIn; ++corner)
        {
          isIn = this->GetVolume(tet, corner, p) > 1e-12;
        }
        covered += isIn ? 1 : 0;
      }
      twice += covered > 1 ? 1 : 0;
    }
    return twice;
  }
};

struct Wish
{
  const char* Name;
  std::function<bool(const Vec&, double)> IsWanted;
};

std::vector<Wish> MakeSelections()
{
  const Vec eye{ 1, 1, 1 };
  const auto distance = [=](const Vec& p)
  { return std::hypot(p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]) / 3; };
  return { { "smooth", [=](const Vec& p, double rank) { return rank < distance(p); } },
    { "mostly coarse", [=](const Vec& p, double rank) { return rank < 3 * distance(p); } },
    { "step", [](const Vec& p, double) { return p[0] < 0.3; } },
    { "a fine ball",
      [](const Vec& p, double) { return std::hypot(p[0], p[1] - 0.6, p[2]) > 0.5; } },
    { "noise",
      [](const Vec& p, double)
      { return std::fmod(std::abs(p[0] * 7919 + p[1] * 104729), 1) < 0.9; } },
    { "late ones only", [](const Vec&, double rank) { return rank > 0.02; } } };
}

//------------------------------------------------------------------------------
/** The length of the longest chain of merges that depend on each other. */
std::size_t GetDepth(const MergeDependencies& dependencies)
{
  std::vector<std::size_t> depth(dependencies.GetNumberOfMerges(), 1);
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    for (const auto earlier : dependencies.Get(i))
    {
      depth[i] = std::max(depth[i], depth[earlier] + 1);
    }
  }
  return *std::max_element(depth.begin(), depth.end());
}

TEST(MergeCut, BatchesMakeMergesDependOnFewerOthers)
{
  const Ball ball(12);
  std::vector<double> values;
  for (const Vec& p : ball.Points)
  {
    values.push_back(std::sin(4 * p[0]) * std::cos(3 * p[1]) + p[2] * p[2]);
  }
  const auto build = [&](double part)
  {
    return BuildMergeTree(
      { ball.Points, ball.Tets, { { values, 1 } } }, { MergeMetric::Mass, 0.5, part });
  };
  std::vector<std::size_t> depths;
  for (const double part : { 0., 0.1, 0.3, 1. })
  {
    const auto tree = build(part);
    const auto merges = tree.GetMerges().size();
    EXPECT_GT(10 * merges, 9 * ball.Tree.GetMerges().size());
    depths.push_back(GetDepth(MergeDependencies(tree, ball.Tets)));
    const auto half = ball.Simplify(tree.FindAncestors(merges / 2));
    EXPECT_TRUE(std::all_of(
      half.begin(), half.end(), [&](const Tet& tet) { return ball.GetVolume(tet) > 0; }));
    // Other threads make no difference.
    WithNumberOfThreads(
      3, [&] { EXPECT_EQ(build(part).FindAncestors(merges / 2), tree.FindAncestors(merges / 2)); });
  }
  EXPECT_LT(depths[1], depths[0]);
  EXPECT_LT(depths[2], depths[1]);
  EXPECT_LT(2 * depths[3], depths[0]);
}

TEST(MergeCut, HasNoInvertedTetrahedraAndCoversEachPlaceOnce)
{
  std::size_t invertedBefore = 0;
  std::size_t twiceBefore = 0;
  for (const unsigned seed : { 1u, 2u })
  {
    const Ball ball(8, seed);
    ASSERT_EQ(ball.CountCoveredTwice(ball.Tets), 0u);
    for (const Wish& wish : MakeSelections())
    {
      SCOPED_TRACE(wish.Name);
      const auto wanted = ball.Want(wish.IsWanted);
      const MergeCut cut(ball.Tree, ball.Dependencies, wanted);
      const auto tets = ball.Simplify(cut.GetAncestors());
      EXPECT_TRUE(std::all_of(
        tets.begin(), tets.end(), [&](const Tet& tet) { return ball.GetVolume(tet) > 0; }));
      EXPECT_EQ(ball.CountCoveredTwice(tets), 0u);
      std::map<std::set<std::uint32_t>, int> faces;
      for (const Tet& tet : tets)
      {
        for (const auto corner : tet)
        {
          std::set<std::uint32_t> face(tet.begin(), tet.end());
          face.erase(corner);
          ++faces[face];
        }
      }
      EXPECT_TRUE(
        std::all_of(faces.begin(), faces.end(), [](auto& face) { return face.second <= 2; }));
      EXPECT_EQ(std::count(cut.GetDone().begin(), cut.GetDone().end(), true),
        static_cast<std::ptrdiff_t>(cut.GetNumberOfMerges()));

      // Without the rule, the same wishes make a mesh that is no good.
      auto ancestors = ball.Tree.FindAncestors(0);
      for (std::size_t i = wanted.size(); i > 0; --i)
      {
        const Merge& merge = ball.Tree.GetMerges()[i - 1];
        ancestors[merge.Point] = wanted[i - 1] ? ancestors[merge.Into] : ancestors[merge.Point];
      }
      const auto naive = ball.Simplify(ancestors);
      invertedBefore += static_cast<std::size_t>(std::count_if(
        naive.begin(), naive.end(), [&](const Tet& tet) { return ball.GetVolume(tet) <= 0; }));
      twiceBefore += ball.CountCoveredTwice(naive);
    }
  }
  EXPECT_GT(invertedBefore, 0u);
  EXPECT_GT(twiceBefore, 0u);
}

//------------------------------------------------------------------------------
TEST(MergeCut, HasTetrahedraThatTheWholeSequenceHas)
{
  const Ball ball(6);
  std::vector<std::set<Tet>> versions(ball.Tets.size());
  auto now = ball.Tets;
  for (std::size_t n = 0;; ++n)
  {
    for (std::size_t i = 0; i < now.size(); ++i)
    {
      versions[i].insert(now[i]);
    }
    if (n == ball.Tree.GetMerges().size())
    {
      break;
    }
    const Merge& merge = ball.Tree.GetMerges()[n];
    for (Tet& tet : now)
    {
      std::replace(tet.begin(), tet.end(), merge.Point, merge.Into);
    }
  }
  for (const Wish& wish : MakeSelections())
  {
    SCOPED_TRACE(wish.Name);
    const MergeCut cut(ball.Tree, ball.Dependencies, ball.Want(wish.IsWanted));
    EXPECT_GT(cut.GetNumberOfMerges(), 0u);
    for (std::size_t i = 0; i < ball.Tets.size(); ++i)
    {
      Tet tet = ball.Tets[i];
      if (Simplify(tet, cut.GetAncestors()))
      {
        EXPECT_TRUE(versions[i].contains(tet)) << i;
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(MergeCut, IsTheLargestOneThatIsWanted)
{
  const Ball ball(6);
  for (const Wish& wish : MakeSelections())
  {
    SCOPED_TRACE(wish.Name);
    const auto wanted = ball.Want(wish.IsWanted);
    const MergeCut cut(ball.Tree, ball.Dependencies, wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      const auto earlier = ball.Dependencies.Get(i);
      const bool isPossible = std::all_of(
        earlier.begin(), earlier.end(), [&](std::uint32_t k) { return cut.GetDone()[k]; });
      EXPECT_EQ(cut.GetDone()[i], wanted[i] && isPossible) << i;
      EXPECT_TRUE(std::all_of(earlier.begin(), earlier.end(), [=](auto k) { return k < i; }));
    }
    // Asking again for what there is changes nothing.
    const MergeCut again(ball.Tree, ball.Dependencies, cut.GetDone());
    EXPECT_EQ(again.GetAncestors(), cut.GetAncestors());
  }
}

//------------------------------------------------------------------------------
TEST(MergeCut, OfTheFirstMergesIsTheUniformOne)
{
  const Ball ball(6);
  const std::size_t all = ball.Tree.GetMerges().size();
  for (const std::size_t n : { std::size_t{ 0 }, std::size_t{ 1 }, all / 2, all, all + 5 })
  {
    const MergeCut uniform(ball.Tree, n);
    EXPECT_EQ(uniform.GetAncestors(), ball.Tree.FindAncestors(n));
    EXPECT_TRUE(uniform.IsUniform());
    EXPECT_EQ(uniform.GetLast(), std::min(n, all));
    std::vector<bool> first(all, false);
    std::fill_n(first.begin(), std::min(n, all), true);
    const MergeCut asked(ball.Tree, ball.Dependencies, first);
    EXPECT_EQ(asked.GetAncestors(), uniform.GetAncestors());
    EXPECT_TRUE(asked.IsUniform());
  }
}

//------------------------------------------------------------------------------
TEST(MergeCut, OfTriangles)
{
  // The middle of a fan goes only after the points around it that were merged before.
  const std::vector<std::array<std::uint32_t, 3>> fan{ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 },
    { 0, 4, 5 } };
  const MergeTree tree(7, { { 2, 1, 1 }, { 4, 5, 2 }, { 0, 3, 3 } });
  const MergeDependencies dependencies(tree, fan);
  ASSERT_EQ(dependencies.GetNumberOfMerges(), 3u);
  EXPECT_TRUE(dependencies.Get(0).empty());
  EXPECT_TRUE(dependencies.Get(1).empty());
  EXPECT_EQ(std::vector<std::uint32_t>(dependencies.Get(2).begin(), dependencies.Get(2).end()),
    (std::vector<std::uint32_t>{ 0, 1 }));
  const MergeCut cut(tree, dependencies, { true, false, true });
  EXPECT_EQ(cut.GetDone(), (std::vector<bool>{ true, false, false }));
  EXPECT_EQ(cut.GetLast(), 1u);
}

//------------------------------------------------------------------------------
TEST(MergeCut, NeedsTheMergeThatBaredAFace)
{
  // The first merge takes away a tetrahedron with a face of the boundary, so that the one behind
  // it, whose corners stay, gets to the boundary.
  const std::vector<Tet> tets{ { 0, 1, 2, 3 }, { 1, 2, 3, 4 } };
  const MergeTree tree(5, { { 0, 1, 1 }, { 4, 2, 2 } });
  const MergeDependencies dependencies(tree, tets);
  ASSERT_EQ(dependencies.Get(1).size(), 1u);
  EXPECT_EQ(dependencies.Get(1)[0], 0u);
}

//------------------------------------------------------------------------------
TEST(MergeCut, RefusesWhatDoesNotFit)
{
  const Ball ball(4);
  EXPECT_THROW(MergeCut(ball.Tree, ball.Dependencies, { true }), Error);
  const MergeTree other(5, { { 0, 1, 1 } });
  EXPECT_THROW(MergeCut(other, ball.Dependencies, { true }), Error);
  EXPECT_THROW(MergeDependencies(other, ball.Tets), Error);
  EXPECT_THROW(MergeDependencies(ball.Tree, ball.Tets, [](double) { return false; }), Error);

  // Cells that are none, and merges of points that have no cell in common.
  const std::vector<Tet> odd{ { 0, 0, 1, 2 }, { 0, 1, 2, 3 } };
  const MergeTree far(6, { { 0, 5, 1 }, { 4, 5, 1 } });
  const MergeDependencies dependencies(far, odd);
  EXPECT_TRUE(dependencies.Get(1).empty());
}
}
}
