// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces are simplified: what must hold after any number of merges.

#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunSurfaceMergeBuilder.h"
#include "gatunTestSheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <string>

namespace gatun::test
{
namespace
{
class SimplifiedSurfaces : public testing::TestWithParam<const char*>
{
};

INSTANTIATE_TEST_SUITE_P(All, SimplifiedSurfaces,
  testing::Values("Sphere", "Torus", "SeamedTorus", "SeamedCube", "Tube", "Moebius", "Hill"),
  [](const auto& test) { return std::string(test.param); });

TEST_P(SimplifiedSurfaces, KeepTheirTopology)
{
  const Sheet sheet = MakeSheet(GetParam());
  const Topology before(sheet.Points, sheet.Triangles);
  ASSERT_TRUE(before.IsManifold);
  const MergeTree tree = BuildMergeTree(sheet.GetInput());
  const std::size_t most = tree.GetMerges().size();
  EXPECT_GT(most, sheet.Points.size() / 2);
  for (std::size_t n = 0; n <= most; n += std::max<std::size_t>(1, most / 40))
  {
    const auto whole = CountWhole(tree, n, sheet.Points);
    EXPECT_EQ(tree.CountWholeMerges(n), whole);
    const Topology after(sheet.Points, Simplify(sheet.Triangles, tree, whole));
    EXPECT_TRUE(after.IsManifold) << n;
    EXPECT_EQ(after.EulerCharacteristic, before.EulerCharacteristic) << n;
    // A seam that has opened is a border.
    EXPECT_EQ(after.Border.empty(), before.Border.empty()) << n;
    for (const auto& edge : after.Border)
    {
      for (const SheetPoint& end : { edge.first, edge.second })
      {
        EXPECT_TRUE(std::any_of(before.Border.begin(), before.Border.end(),
          [&](const auto& old) { return old.first == end || old.second == end; }));
      }
    }
  }
}

TEST_P(SimplifiedSurfaces, AreTheSameWithAnyNumberOfThreads)
{
  const Sheet sheet = MakeSheet(GetParam());
  const auto build = [&](int threads)
  {
    MergeTree tree;
    WithNumberOfThreads(threads, [&] { tree = BuildMergeTree(sheet.GetInput()); });
    return tree;
  };
  const MergeTree one = build(1);
  const MergeTree four = build(4);
  ASSERT_EQ(one.GetMerges().size(), four.GetMerges().size());
  for (std::size_t i = 0; i < one.GetMerges().size(); ++i)
  {
    const Merge& a = one.GetMerges()[i];
    const Merge& b = four.GetMerges()[i];
    EXPECT_TRUE(a.Point == b.Point && a.Into == b.Into && a.Error == b.Error) << i;
  }
}

TEST(SurfaceMerges, TurnNoTriangleOver)
{
  const Sheet hill = MakeSheet(30, 30, false, false, PlaceOnHill);
  const MergeTree tree = BuildMergeTree(hill.GetInput());
  for (std::size_t n = 0; n <= tree.GetMerges().size(); n += 20)
  {
    double area = 0;
    for (const SheetTriangle& t : Simplify(hill.Triangles, tree, n))
    {
      const double up = GetNormal(hill.Points, t)[2];
      EXPECT_GT(up, 0) << n;
      area += up / 2;
    }
    // The border is a square, and stays.
    EXPECT_NEAR(area, 1, 1e-6) << n;
  }
}

TEST(SurfaceMerges, OfAPlaneWithALinearFieldCostNothing)
{
  Sheet plane = MakeSheet(12, 12, false, false, PlaceOnPlane);
  for (std::size_t i = 0; i < plane.Points.size(); ++i)
  {
    plane.Values[i] = 3 * plane.Points[i][0] - plane.Points[i][1];
  }
  const MergeTree tree = BuildMergeTree(plane.GetInput());
  const std::size_t most = plane.Points.size() - 4;
  ASSERT_GE(tree.GetMerges().size(), most);
  EXPECT_LT(tree.GetLargestError(most), 1e-6);
  EXPECT_EQ(Simplify(plane.Triangles, tree, most).size(), 2);
}

TEST(SurfaceMerges, KeepTheEdgesOfACube)
{
  for (const bool hasSeams : { false, true })
  {
    const Sheet cube = MakeCube(6, hasSeams);
    const MergeTree tree = BuildMergeTree(cube.GetInput());
    const std::size_t merges = CountWhole(tree, tree.CountMergesForError(1e-6), cube.Points);
    const auto left = Simplify(cube.Triangles, tree, merges);
    EXPECT_EQ(left.size(), 12) << hasSeams;
    EXPECT_EQ(cube.Points.size() - merges, hasSeams ? 24 : 8);
  }
}

TEST(SurfaceMerges, HoldEdgesAboveTheFeatureAngle)
{
  // Along a curved ridge, whose sides differ by about ten degrees.
  const Sheet roof = MakeSheet(20, 20, false, false,
    [](double u, double v)
    {
      return SheetPoint{ u, v,
        -0.09 * std::abs(u - 0.5 - 0.2 * std::sin(4 * v) * (1 - std::abs(2 * u - 1))) };
    });
  const SurfaceMergeInput input{ roof.Points, roof.Triangles, {} };
  const auto getError = [&](double angle)
  {
    const MergeTree tree = BuildMergeTree(input, { 0.5, angle, false });
    return tree.GetLargestError(roof.Points.size() * 9 / 10);
  };
  EXPECT_GT(getError(2), 1.1 * getError(60));
  EXPECT_EQ(getError(90), getError(60));
}

TEST(SurfaceMerges, MergePointsOfASeamOnTheirOwnSide)
{
  // No triangle gets values of the other side.
  const Sheet torus = MakeSheet("SeamedTorus");
  const MergeTree tree = BuildMergeTree(torus.GetInput());
  const auto merges = CountWhole(tree, torus.Points.size() * 3 / 4, torus.Points);
  std::size_t atSeam = 0;
  for (const SheetTriangle& t : Simplify(torus.Triangles, tree, merges))
  {
    const auto [low, high] = std::minmax({ t[0] % 25, t[1] % 25, t[2] % 25 });
    EXPECT_LT(high - low, 20u);
    atSeam += low == 0 || high == 24 ? 1 : 0;
  }
  EXPECT_GT(atSeam, 4);
}

TEST(SurfaceMerges, KeepTheBendOfAField)
{
  Sheet plane = MakeSheet(16, 16, false, false, PlaceOnPlane);
  for (std::size_t i = 0; i < plane.Points.size(); ++i)
  {
    plane.Values[i] = std::abs(plane.Points[i][0]);
  }
  const MergeTree tree = BuildMergeTree(plane.GetInput());
  const auto ancestors = tree.FindAncestors(tree.CountMergesForError(1e-6));
  std::size_t left = 0;
  for (std::size_t i = 0; i < ancestors.size(); ++i)
  {
    const SheetPoint& p = plane.Points[i];
    left += ancestors[i] == i ? 1 : 0;
    EXPECT_TRUE(ancestors[i] != i || p[0] == 0 || std::abs(p[0]) == 1) << i;
  }
  EXPECT_EQ(left, 6);
}

TEST(SurfaceMerges, ErrorsAreThoseOfTheShapeAndTheField)
{
  // The farther, the larger: by the mean square distance of a sphere's middles from its center.
  const Sheet sphere = MakeSphere(20);
  SurfaceMergeInput input{ sphere.Points, sphere.Triangles, {} };
  const MergeTree tree = BuildMergeTree(input);
  for (const double error : { 1e-3, 3e-3, 1e-2 })
  {
    const auto merges = tree.CountMergesForError(error);
    double squares = 0;
    double area = 0;
    for (const SheetTriangle& t : Simplify(sphere.Triangles, tree, merges))
    {
      double square = 0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const double x =
          (sphere.Points[t[0]][i] + sphere.Points[t[1]][i] + sphere.Points[t[2]][i]) / 3;
        square += x * x;
      }
      const SheetPoint n = GetNormal(sphere.Points, t);
      const double weight = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      squares += weight * (1 - std::sqrt(square)) * (1 - std::sqrt(square));
      area += weight;
    }
    const double measured = std::sqrt(squares / area) / std::sqrt(12.0);
    EXPECT_LT(measured, 2 * error);
    EXPECT_GT(measured, error / 10);
  }
}

TEST(SurfaceMerges, LeaveWholeParts)
{
  // A flat tetrahedron, one of whose points could be merged without turning anything, and a
  // triangle. Neither has a smaller form.
  const std::vector<SheetPoint> points{ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0.01 },
    { 9, 0, 0 }, { 9, 1, 0 }, { 8, 0, 0 } };
  const std::vector<SheetTriangle> triangles{ { 3, 0, 1 }, { 3, 1, 2 }, { 3, 2, 0 }, { 0, 2, 1 },
    { 4, 5, 6 } };
  EXPECT_TRUE(BuildMergeTree(SurfaceMergeInput{ points, triangles, {} }).GetMerges().empty());
}

TEST(SurfaceMerges, OfManyEqualCostsKeepTheTopology)
{
  // Rounds have many points, and each changes the surroundings of others.
  std::mt19937 random(3);
  for (std::uint32_t round = 0; round < 400; ++round)
  {
    const std::uint32_t n = 5 + round % 20;
    const Sheet sheet = MakeSheet(n, n, false, false,
      [&](double u, double v)
      {
        const auto noise = [&] { return 0.4 / n * (1e-3 * static_cast<double>(random() % 1000)); };
        return SheetPoint{ u + noise(), v + noise(), 0 };
      });
    const MergeTree tree = BuildMergeTree(SurfaceMergeInput{ sheet.Points, sheet.Triangles, {} });
    for (std::size_t i = 1; i <= 6; ++i)
    {
      const Topology after(
        sheet.Points, Simplify(sheet.Triangles, tree, tree.GetMerges().size() * i / 6));
      EXPECT_TRUE(after.IsManifold && after.EulerCharacteristic == 1) << n << " " << i;
    }
  }
}

TEST(SurfaceMerges, KeepWhatIsMarked)
{
  const Sheet hill = MakeSheet(10, 10, false, false, PlaceOnHill);
  std::vector<std::uint8_t> isKept(hill.Points.size(), 0);
  isKept[37] = isKept[60] = 1;
  SurfaceMergeInput input = hill.GetInput();
  input.IsKept = isKept;
  SurfaceMergeSettings settings;
  settings.KeepBorder = true;
  const MergeTree tree = BuildMergeTree(input, settings);
  EXPECT_GT(tree.GetMerges().size(), 60);
  for (const Merge& merge : tree.GetMerges())
  {
    const std::uint32_t x = merge.Point % 11;
    const std::uint32_t y = merge.Point / 11;
    EXPECT_TRUE(x > 0 && x < 10 && y > 0 && y < 10 && isKept[merge.Point] == 0) << merge.Point;
  }
}

TEST(SurfaceMerges, KeepWhatIsNoManifold)
{
  // Three sheets at one edge, a triangle that is there twice, some without an area, and points
  // without a triangle or without a place.
  Sheet sheet = MakeSheet(8, 8, false, false, PlaceOnHill);
  const auto add = [&](const SheetPoint& p)
  {
    sheet.Points.push_back(p);
    sheet.Values.push_back(0);
    return static_cast<std::uint32_t>(sheet.Points.size() - 1);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::uint32_t fin = add({ 0.5, 0.5, 1 });
  const std::uint32_t alone = add({ 0.3, 0.3, 0.3 });
  const std::uint32_t lost = add({ nan, 0, 0 });
  const std::uint32_t far = add({ std::numeric_limits<double>::infinity(), 0, 0 });
  sheet.Triangles.push_back({ 40, 41, fin });
  sheet.Triangles.push_back({ 0, 1, lost });
  sheet.Triangles.push_back({ 70, 71, far });
  sheet.Triangles.push_back(sheet.Triangles[20]);
  sheet.Triangles.push_back({ 50, 50, 51 });
  std::set<std::uint32_t> kept{ 40, 41, alone, lost, far, 50, 51 };
  kept.insert(sheet.Triangles[20].begin(), sheet.Triangles[20].end());
  const MergeTree tree = BuildMergeTree(sheet.GetInput());
  EXPECT_GT(tree.GetMerges().size(), 10);
  for (const Merge& merge : tree.GetMerges())
  {
    EXPECT_EQ(kept.count(merge.Point), 0) << merge.Point;
  }
}

TEST(SurfaceMerges, OfAnyTrianglesAreValid)
{
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round)
  {
    Sheet soup;
    const std::uint32_t points = 4 + random() % 40;
    for (std::uint32_t i = 0; i < points; ++i)
    {
      const auto coordinate = [&]
      {
        const auto kind = random() % 40;
        return kind == 0 ? std::numeric_limits<double>::quiet_NaN()
          : kind == 1    ? std::numeric_limits<double>::max()
                         : static_cast<double>(random() % 4);
      };
      soup.Points.push_back({ coordinate(), coordinate(), coordinate() });
      soup.Values.push_back(random() % 30 == 0 ? std::nan("") : static_cast<double>(random() % 9));
    }
    for (std::uint32_t i = random() % 120; i > 0; --i)
    {
      soup.Triangles.push_back({ static_cast<std::uint32_t>(random() % points),
        static_cast<std::uint32_t>(random() % points),
        static_cast<std::uint32_t>(random() % points) });
    }
    // The tree checks that points exist when they are merged.
    const MergeTree tree = BuildMergeTree(soup.GetInput());
    for (const Merge& merge : tree.GetMerges())
    {
      EXPECT_TRUE(std::isfinite(soup.Points[merge.Point][0] + soup.Values[merge.Point]));
    }
  }
}

TEST(SurfaceMerges, ManyTrianglesAroundAPoint)
{
  // A cone whose apex has all triangles.
  Sheet cone;
  constexpr std::uint32_t count = 3000;
  cone.Points.push_back({ 0, 0, 1 });
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const double a = 2 * std::numbers::pi * i / count;
    cone.Points.push_back({ std::cos(a), std::sin(a), 0 });
    cone.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % count });
  }
  SurfaceMergeInput input{ cone.Points, cone.Triangles, {} };
  const MergeTree tree = BuildMergeTree(input);
  EXPECT_GT(tree.GetMerges().size(), count / 2);
}

TEST(SurfaceMerges, RefuseInputThatDoesNotFit)
{
  const Sheet hill = MakeSheet(3, 3, false, false, PlaceOnHill);
  const auto refuses = [](const SurfaceMergeInput& input, const SurfaceMergeSettings& settings = {})
  {
    try
    {
      BuildMergeTree(input, settings);
    }
    catch (const Error& error)
    {
      return error.Code == ErrorCode::InvalidInput;
    }
    return false;
  };
  EXPECT_FALSE(refuses(hill.GetInput()));
  Sheet wrong = hill;
  wrong.Triangles[3][1] = 16;
  EXPECT_TRUE(refuses(wrong.GetInput()));
  wrong = hill;
  wrong.Values.pop_back();
  EXPECT_TRUE(refuses(wrong.GetInput()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(refuses(hill.GetInput(), { 1.5, 30, false }));
  EXPECT_TRUE(refuses(hill.GetInput(), { nan, 30, false }));
  EXPECT_TRUE(refuses(hill.GetInput(), { 0.5, 190, false }));
  EXPECT_TRUE(refuses(hill.GetInput(), { 0.5, nan, false }));
  EXPECT_TRUE(BuildMergeTree(SurfaceMergeInput{}).GetMerges().empty());
}

TEST(SurfaceMerges, StopWhenAskedTo)
{
  const Sheet hill = MakeSheet(20, 20, false, false, PlaceOnHill);
  EXPECT_THROW(BuildMergeTree(hill.GetInput(), {}, [](double) { return false; }), Error);
}
}
}
