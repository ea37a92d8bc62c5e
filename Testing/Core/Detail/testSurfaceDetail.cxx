// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces are simplified for a view.

#include "gatunError.h"
#include "gatunFileWriter.h"
#include "gatunSharedFile.h"
#include "gatunSurfaceDetail.h"
#include "gatunTestFile.h"
#include "gatunTestSheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace gatun::test
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int WindowPixels = 400;

/** A view from a place to another one, with x or y to the right. */
SurfaceDetailView MakeView(const SheetPoint& from, const SheetPoint& to, bool isParallel = false)
{
  const auto normalize = [](SheetPoint v)
  {
    const double length = std::hypot(v[0], v[1], v[2]);
    return SheetPoint{ v[0] / length, v[1] / length, v[2] / length };
  };
  const auto cross = [](const SheetPoint& a, const SheetPoint& b)
  {
    return SheetPoint{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
      a[0] * b[1] - a[1] * b[0] };
  };
  const SheetPoint back = normalize({ from[0] - to[0], from[1] - to[1], from[2] - to[2] });
  const SheetPoint right =
    normalize(cross(std::abs(back[2]) < 0.9 ? SheetPoint{ 0, 0, 1 } : SheetPoint{ 0, 1, 0 }, back));
  const SheetPoint up = cross(back, right);
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const SheetPoint& axis = i == 0 ? right : i == 1 ? up : back;
    std::copy(axis.begin(), axis.end(), rows[i].begin());
    rows[i][3] = -(axis[0] * from[0] + axis[1] * from[1] + axis[2] * from[2]);
  }
  RayFrustum frustum;
  frustum.Parallel = isParallel;
  frustum.Near = 1e-3;
  frustum.Far = 100;
  const double wide = isParallel ? 2 : 0.5;
  frustum.Left = frustum.Bottom = -wide;
  frustum.Right = frustum.Top = wide;
  SurfaceDetailView view{ RayView(rows, frustum, WindowPixels, WindowPixels, 0.01) };
  view.IsOpaque = true;
  return view;
}

/** A surface with all that its cuts need. */
struct SheetSample
{
  Sheet Surface;
  std::shared_ptr<const MergeTree> Tree;
  std::shared_ptr<const MergeDependencies> Dependencies;

  explicit SheetSample(Sheet sheet)
    : Surface(std::move(sheet))
    , Tree(std::make_shared<const MergeTree>(BuildMergeTree(this->Surface.GetInput())))
    , Dependencies(std::make_shared<const MergeDependencies>(*this->Tree, this->Surface.Triangles))
  {
  }

  SurfaceDetail MakeDetail() const
  {
    return { this->Tree, this->Dependencies, this->Surface.Points, this->Surface.Triangles };
  }

  std::vector<SheetTriangle> Cut(const MergeCut& cut) const
  {
    std::vector<SheetTriangle> left = this->Surface.Triangles;
    std::erase_if(left, [&](SheetTriangle& t) { return !gatun::Simplify(t, cut.GetAncestors()); });
    return left;
  }

  /** The points that are left on a side of a plane through the origin, and their share. */
  std::size_t CountLeft(const MergeCut& cut, const SheetPoint& side) const
  {
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < this->Surface.Points.size(); ++i)
    {
      const SheetPoint& p = this->Surface.Points[i];
      count += cut.GetAncestors()[i] == i && p[0] * side[0] + p[1] * side[1] + p[2] * side[2] > 0;
    }
    return count;
  }
};

SheetTriangle Sort(SheetTriangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

class CutSurfaces : public testing::TestWithParam<const char*>
{
};

INSTANTIATE_TEST_SUITE_P(All, CutSurfaces,
  testing::Values("Sphere", "Torus", "SeamedTorus", "SeamedCube", "Tube", "Moebius", "Hill"),
  [](const auto& test) { return std::string(test.param); });

TEST_P(CutSurfaces, KeepTheirTopologyAndHaveNoNewTriangles)
{
  const SheetSample sample(MakeSheet(GetParam()));
  const auto& points = sample.Surface.Points;
  const Topology before(points, sample.Surface.Triangles);
  std::set<SheetTriangle> versions;
  for (std::size_t n = 0; n <= sample.Tree->GetMerges().size(); ++n)
  {
    for (const SheetTriangle& t : Simplify(sample.Surface.Triangles, *sample.Tree, n))
    {
      versions.insert(Sort(t));
    }
  }
  const SurfaceDetail detail = sample.MakeDetail();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  std::size_t uniform = 0;
  for (int i = 0; i < 100; ++i)
  {
    const SheetPoint from{ any(random), any(random), any(random) };
    auto view = MakeView(from, { 0.1 * any(random), 0, 0 }, i % 5 == 0);
    view.Points = static_cast<std::uint64_t>((1 + i % 9) * static_cast<int>(points.size()) / 20);
    view.PixelError = i % 3;
    view.IsOpaque = i % 2 == 0;
    const MergeCut cut = detail.Choose(view);
    uniform += cut.IsUniform() ? 1 : 0;
    const auto left = sample.Cut(cut);
    const Topology after(points, left);
    EXPECT_TRUE(after.IsManifold) << i;
    EXPECT_EQ(after.EulerCharacteristic, before.EulerCharacteristic) << i;
    EXPECT_EQ(after.Border.empty(), before.Border.empty()) << i;
    for (const SheetTriangle& t : left)
    {
      EXPECT_TRUE(versions.contains(Sort(t))) << i;
    }
  }
  // The sides of a cube are flat, without any error.
  EXPECT_TRUE(uniform < 50 || std::string(GetParam()) == "SeamedCube");
}

TEST(SurfaceDetail, IsFineWhereTheEyeIs)
{
  const SheetSample sample(MakeSheet(120, 20, false, false,
    [](double u, double v) {
      return SheetPoint{ 4 * u - 2, 0.4 * v - 0.2, 0.1 * std::sin(20 * u) * std::cos(17 * v) };
    }));
  const SurfaceDetail detail = sample.MakeDetail();
  auto view = MakeView({ -2.4, 0, 0.3 }, { 2, 0, 0 });
  view.Points = 800;
  const MergeCut cut = detail.Choose(view);
  const std::size_t near = sample.CountLeft(cut, { -1, 0, 0 });
  const std::size_t far = sample.CountLeft(cut, { 1, 0, 0 });
  EXPECT_GT(near, 2 * far);
  EXPECT_GT(near + far, 700);
  EXPECT_LT(near + far, 900);
  // In a parallel projection from above, distance does not count.
  auto parallel = MakeView({ 0, 0, 5 }, { 0, 0, 0 }, true);
  parallel.Points = 800;
  const MergeCut even = detail.Choose(parallel);
  const double share = static_cast<double>(sample.CountLeft(even, { -1, 0, 0 })) /
    static_cast<double>(sample.CountLeft(even, { 1, 0, 0 }));
  EXPECT_GT(share, 0.7);
  EXPECT_LT(share, 1.4);
  // No point counts more than the bound, which is not far away.
  for (const double x : { -2.4, -2.05, 0.0 })
  {
    const auto close = MakeView({ x, 0, 0.3 }, { 2, 0, 0 });
    const auto all = detail.Weigh(close);
    const double most = *std::max_element(all.begin(), all.end());
    EXPECT_LE(most, detail.BoundWeights(close));
    EXPECT_LT(detail.BoundWeights(close), 50 * most);
  }
  // Behind the eye there is nothing to see, and all merges are made that can be.
  const auto weights = detail.Weigh(MakeView({ 3, 0, 0 }, { 5, 0, 0 }));
  EXPECT_EQ(*std::max_element(weights.begin(), weights.end()), 0);
}

TEST(SurfaceDetail, HasTheErrorThatIsAllowed)
{
  const SheetSample sample(MakeSphere(16));
  const SurfaceDetail detail = sample.MakeDetail();
  auto view = MakeView({ 0, 0, 3 }, { 0, 0, 0 });
  const auto weights = detail.Weigh(view);
  const auto& merges = sample.Tree->GetMerges();
  std::size_t last = 0;
  for (const double error : { 0.0, 0.5, 2.0, 10.0 })
  {
    view.PixelError = error;
    const MergeCut cut = detail.Choose(view);
    for (std::size_t i = 0; i < merges.size(); ++i)
    {
      EXPECT_TRUE(!cut.GetDone()[i] ||
        double{ weights[merges[i].Point] } * double{ merges[i].Error } <= error);
    }
    EXPECT_GE(cut.GetNumberOfMerges(), last);
    last = cut.GetNumberOfMerges();
  }
  EXPECT_GT(last, 0);
  // Merges that are made in any case.
  view.PixelError = 0;
  const MergeCut cut = detail.Choose(view, merges.size() / 2);
  EXPECT_TRUE(std::all_of(cut.GetDone().begin(),
    cut.GetDone().begin() + static_cast<std::ptrdiff_t>(merges.size() / 2),
    [](bool is) { return is; }));
  // In other units, and from twice as far, the same.
  view.Scale = 2;
  const auto twice = detail.Weigh(view);
  EXPECT_FLOAT_EQ(twice[3], 2 * weights[3]);
}

TEST(SurfaceDetail, KnowsInsideFromOutside)
{
  for (const char* const name : { "Sphere", "Torus", "Tube", "Moebius", "Hill", "SeamedCube" })
  {
    const SheetSample sample(MakeSheet(name));
    const SurfaceDetail detail = sample.MakeDetail();
    const bool isSolid = std::string(name) == "Sphere" || std::string(name) == "Torus";
    // The sheets of a cube and a torus are wound either way.
    Sheet turned = sample.Surface;
    for (SheetTriangle& t : turned.Triangles)
    {
      std::swap(t[1], t[2]);
    }
    const SurfaceDetail other = SheetSample(turned).MakeDetail();
    EXPECT_EQ(detail.IsSolid() != other.IsSolid(), isSolid) << name;
    EXPECT_FALSE(detail.IsSolid() && other.IsSolid()) << name;
    const SurfaceDetail& solid = detail.IsSolid() ? detail : other;
    EXPECT_FALSE(solid.IsInside({ 3, 0, 0 })) << name;
    EXPECT_FALSE(solid.IsInside({ 0, 0, -2 })) << name;
    EXPECT_EQ(solid.IsInside({ 1.02, 0.02, 0.01 }), std::string(name) == "Torus") << name;
    EXPECT_EQ(solid.IsInside({ 0, 0, 0 }), std::string(name) == "Sphere") << name;
    EXPECT_TRUE(!isSolid || solid.IsInside({ NaN, 0, 0 })) << name;
  }
}

TEST(SurfaceDetail, IsCoarseWhereTheSurfaceIsTurnedAway)
{
  Sheet sphere = MakeSphere(24);
  Sheet turned = sphere;
  for (SheetTriangle& t : turned.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  const bool isOutward = SheetSample(sphere).MakeDetail().IsSolid();
  const SheetSample sample(isOutward ? sphere : turned);
  const SurfaceDetail detail = sample.MakeDetail();
  ASSERT_TRUE(detail.IsSolid());
  const SheetPoint from{ 0, 0, 6 };
  auto view = MakeView(from, { 0, 0, 0 });
  const auto count = [&]
  {
    view.Points = 600;
    const MergeCut cut = detail.Choose(view);
    return static_cast<double>(sample.CountLeft(cut, { 0, 0, 1 })) /
      static_cast<double>(sample.CountLeft(cut, { 0, 0, -1 }));
  };
  EXPECT_GT(count(), 4);
  // Errors at the silhouette count most.
  const auto weights = detail.Weigh(view);
  const auto middle = static_cast<std::size_t>(
    std::max_element(sample.Surface.Points.begin(), sample.Surface.Points.end(),
      [](const SheetPoint& a, const SheetPoint& b) { return a[2] < b[2]; }) -
    sample.Surface.Points.begin());
  std::size_t behind = 0;
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const double z = sample.Surface.Points[i][2];
    behind += z < -0.5 ? 1 : 0;
    hidden += z < -0.5 && weights[i] == 0 ? 1 : 0;
    EXPECT_TRUE(z < 0 || weights[i] > 0) << z;
    const bool isAtSilhouette = z > 0.1 && z < 0.2;
    EXPECT_TRUE(!isAtSilhouette || weights[i] > 1.5F * weights[middle]) << z;
  }
  // But for points into which much of the near side is merged.
  EXPECT_GT(hidden, behind * 9 / 10);
  // The far side can be seen.
  view.IsOpaque = false;
  EXPECT_LT(count(), 3);
  view.CullsBackFaces = true;
  EXPECT_GT(count(), 4);
  view.CullsBackFaces = false;
  view.CullsFrontFaces = true;
  EXPECT_LT(count(), 0.8);
  // From within.
  auto inside = MakeView({ 0, 0, 0.1 }, { 0, 0, -1 });
  inside.Points = 600;
  EXPECT_GT(sample.CountLeft(detail.Choose(inside), { 0, 0, -1 }),
    2 * sample.CountLeft(detail.Choose(inside), { 0, 0, 1 }));
}

TEST(SurfaceDetail, IsThatOfTheSurfaceInAFile)
{
  const SheetSample sample(MakeSphere(100));
  const std::vector<std::uint8_t> types(sample.Surface.Triangles.size(), 5);
  std::vector<std::uint32_t> offsets(types.size() + 1);
  for (std::uint32_t i = 0; i < offsets.size(); ++i)
  {
    offsets[i] = 3 * i;
  }
  MeshInput input;
  input.Points = sample.Surface.Points.size();
  input.CoordinateType = ScalarType::Float64;
  input.Coordinates = sample.Surface.Points.data();
  input.Cells = types.size();
  input.Connectivity = sample.Surface.Triangles.data();
  input.WideIds = false;
  input.Types = types.data();
  input.Offsets = offsets.data();
  WriterOptions options;
  options.IsSurface = true;
  options.ChunkSize = 1000;
  options.Tree = sample.Tree.get();
  options.Levels = 1;
  const auto path = TempPath("detail_of_surface.gtn");
  FileWriter(path, input, {}, options).Finish();
  SharedFile file(path, std::uint64_t{ 1 } << 30);
  ASSERT_EQ(file.GetNumberOfLevels(), 2u);
  const SurfaceDetail detail = sample.MakeDetail();
  const auto whole = ReadSurfaceDetail(file, 0, 0, {});
  const auto base = ReadSurfaceDetail(file, 1, 0, {});
  EXPECT_EQ(whole->IsSolid(), detail.IsSolid());
  auto view = MakeView({ 0, 0, 3 }, { 0, 0, 0 });
  view.Points = sample.Surface.Points.size() / 20;
  const auto all = static_cast<double>(detail.Choose(view).GetNumberOfMerges());
  // Normals are added up in another order.
  EXPECT_NEAR(static_cast<double>(whole->Choose(view).GetNumberOfMerges()), all, 5);
  const auto before = static_cast<double>(file.GetMergesOfLevel(1));
  const auto more = static_cast<double>(base->Choose(view).GetNumberOfMerges());
  EXPECT_NEAR(before + more, all, 0.01 * all);
  EXPECT_THROW(ReadSurfaceDetail(file, 0, 0, [](double) { return false; }), Error);
}

TEST(SurfaceDetail, TakesAnyPlaces)
{
  Sheet sheet = MakeSheet("Hill");
  const SheetSample sample(sheet);
  const auto points = sheet.Points;
  // The eye is on a point.
  auto view = MakeView(points[20], points[100]);
  view.Points = points.size() / 2;
  EXPECT_GT(sample.MakeDetail().Choose(view).GetNumberOfMerges(), 0);
  // Points that are nowhere, and everything at one place.
  for (const double x : { NaN, std::numeric_limits<double>::infinity(), 1.0 })
  {
    auto strange = points;
    for (std::size_t i = x == 1.0 ? 0 : 30; i < (x == 1.0 ? strange.size() : 50); ++i)
    {
      strange[i] = { x, x, x };
    }
    const SurfaceDetail detail(sample.Tree, sample.Dependencies, strange, sample.Surface.Triangles);
    const auto weights = detail.Weigh(view);
    EXPECT_TRUE(std::all_of(
      weights.begin(), weights.end(), [](float weight) { return std::isfinite(weight); }));
    EXPECT_EQ(weights[40], 0);
    view.PixelError = NaN;
    EXPECT_LE(detail.Choose(view).GetNumberOfMerges(), sample.Tree->GetMerges().size());
    view.PixelError = 0;
  }
  const auto fewer = std::span(points).first(points.size() - 1);
  EXPECT_THROW(SurfaceDetail(sample.Tree, sample.Dependencies, fewer, sheet.Triangles), Error);
  const std::vector<SheetTriangle> wrong{ { 0, 1, static_cast<std::uint32_t>(points.size()) } };
  EXPECT_THROW(SurfaceDetail(sample.Tree, sample.Dependencies, points, wrong), Error);
  EXPECT_THROW(
    SurfaceDetail(sample.Tree, std::make_shared<MergeDependencies>(), points, sheet.Triangles),
    Error);
}
}
}
