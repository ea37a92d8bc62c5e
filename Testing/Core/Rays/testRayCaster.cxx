// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The ray caster against the definition, against formulas, and against itself with everything in
// another order.

#include "gatunError.h"
#include "gatunRayImages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gatun::test
{
namespace
{
/** Flat ones, some along the axes, and some twice as thin as the distance of samples; all of them
 * in sight. */
ReferenceMesh MakeSlivers()
{
  auto mesh = ToReference(MakeCubes(4, 0.2));
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i][2] = std::round(mesh.Points[i][2]) + 1e-9 * static_cast<double>(i);
  }
  const auto n = static_cast<std::uint32_t>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), { { 6, 0, 0 }, { 7, 0, 0 }, { 6, 1, 0 }, { 6, 0, 0.05 } });
  mesh.Points.insert(mesh.Points.end(), { { 7, 1, 0 }, { 6.5, 0.5, 0 }, { 7, 1, 0 } });
  mesh.Values.resize(mesh.Points.size(), 0.6);
  mesh.Tets.push_back({ n, n + 1, n + 2, n + 3 });
  mesh.Tets.push_back({ n, n + 1, n + 2, n + 4 }); // flat
  mesh.Tets.push_back({ n, n + 1, n + 2, n + 5 }); // flat
  mesh.Tets.push_back({ n, n + 4, n + 6, n + 3 }); // two points in one place
  mesh.Tets.push_back({ n, n, n + 2, n + 3 });     // a point twice
  return mesh;
}

/** Tetrahedra that do not touch each other, in no order. */
ReferenceMesh MakeLooseTets()
{
  auto mesh = ToReference(MakeCubes(5, 0));
  ReferenceMesh loose;
  std::mt19937 random(7);
  for (const auto& tet : mesh.Tets)
  {
    Vec middle{};
    for (const auto corner : tet)
    {
      middle = middle + 0.25 * mesh.Points[corner];
    }
    const auto first = static_cast<std::uint32_t>(loose.Points.size());
    for (const auto corner : tet)
    {
      loose.Points.push_back(middle + 0.9 * (mesh.Points[corner] - middle));
      loose.Values.push_back(Wave(loose.Points.back()));
    }
    loose.Tets.push_back({ first, first + 1, first + 2, first + 3 });
  }
  std::shuffle(loose.Tets.begin(), loose.Tets.end(), random);
  return loose;
}

class AgainstReference : public testing::TestWithParam<std::tuple<const char*, bool>>
{
protected:
  static ReferenceMesh GetMesh()
  {
    const std::string name = std::get<0>(GetParam());
    return name == "Cubes" ? ToReference(MakeCubes(5, 0.25))
      : name == "Lattice"  ? ToReference(MakeCubes(5, 0))
      : name == "Slivers"  ? MakeSlivers()
                           : MakeLooseTets();
  }

  static void Check(const Setting& setting, std::size_t views, bool withDepth)
  {
    const auto mesh = GetMesh();
    Reference reference;
    reference.Mode = setting.Mode;
    reference.Color = setting.Color;
    reference.Breaks = setting.Breaks;
    reference.Planes = setting.Planes;
    reference.Unit = setting.Unit;
    auto viewers = MakeViewers(5, std::get<1>(GetParam()));
    viewers.resize(views, viewers.front());
    std::size_t bad = 0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < viewers.size(); ++i)
    {
      const Viewer& viewer = viewers[i];
      const auto expected = reference.Render(mesh, viewer);
      for (const auto instructions : AllInstructions)
      {
        SCOPED_TRACE(testing::Message() << "view " << i << ", " << static_cast<int>(instructions));
        auto used = setting;
        used.Settings.Instructions = instructions;
        used.Settings.Opaque = setting.Mode == RayMode::Sampled ? setting.Settings.Opaque : 0;
        const auto difference =
          Compare(Render(mesh, viewer, used), expected, viewer.SampleDistance);
        bad += ExpectAsDefined(difference, setting.Mode, withDepth);
        pixels += expected.size();
        EXPECT_GT(difference.Lit, 300);
      }
    }
    EXPECT_LE(static_cast<double>(bad), 2e-4 * static_cast<double>(pixels));
  }
};

TEST_P(AgainstReference, Composite)
{
  Check({}, 20, true);
}

TEST_P(AgainstReference, Sampled)
{
  Setting setting;
  setting.Mode = RayMode::Sampled;
  Check(setting, 6, true);
}

TEST_P(AgainstReference, SharpBands)
{
  Setting setting;
  setting.Color = Bands;
  setting.Breaks = BandBreaks();
  Check(setting, 6, false);
  setting.Mode = RayMode::XRay;
  Check(setting, 3, false);
}

TEST_P(AgainstReference, NearlyOpaque)
{
  Setting setting;
  setting.Unit = 0.02;
  Check(setting, 6, true);
}

TEST_P(AgainstReference, Maximum)
{
  Setting setting;
  setting.Mode = RayMode::Maximum;
  Check(setting, 6, false);
}

TEST_P(AgainstReference, XRay)
{
  Setting setting;
  setting.Mode = RayMode::XRay;
  Check(setting, 6, false);
}

TEST_P(AgainstReference, ClippingPlanes)
{
  Setting setting;
  setting.Planes = { { 1, 0.5, 0.2, -3 }, { -0.1, -1, 0.3, 3.7 } };
  Check(setting, 6, true);
}

std::string GetReferenceName(const testing::TestParamInfo<AgainstReference::ParamType>& given)
{
  return std::string(std::get<0>(given.param)) + (std::get<1>(given.param) ? "Parallel" : "");
}

INSTANTIATE_TEST_SUITE_P(RayCaster, AgainstReference,
  testing::Combine(testing::Values("Cubes", "Lattice", "Slivers", "Loose"), testing::Bool()),
  GetReferenceName);

TEST(RayCaster, ImageDoesNotDependOnTheOrderOfAnything)
{
  auto mesh = ToReference(MakeCubes(7, 0.3));
  for (const bool parallel : { false, true })
  {
    const auto viewer = MakeViewers(7, parallel)[5];
    const auto expected = Render(mesh, viewer, {});
    auto shuffled = mesh;
    std::mt19937 random(11);
    std::shuffle(shuffled.Tets.begin(), shuffled.Tets.end(), random);
    for (auto& tet : shuffled.Tets)
    {
      std::shuffle(tet.begin(), tet.end(), random);
    }
    for (const std::size_t tetsInBlock : { 1, 17, 400, 100000 })
    {
      Setting setting;
      setting.TetsInBlock = tetsInBlock;
      EXPECT_LE(GetLargestDifference(expected, Render(mesh, viewer, setting)), 1.0f / 255);
      setting.Settings.Prefilter = false;
      EXPECT_LE(GetLargestDifference(expected, Render(mesh, viewer, setting)), 1.0f / 255);
      setting.Settings.Prefilter = true;
      setting.Settings.FromBothEnds = true;
      EXPECT_LE(GetLargestDifference(expected, Render(shuffled, viewer, setting)), 1.0f / 255);
      setting.Settings.Instructions = RayInstructions::Portable;
      EXPECT_LE(GetLargestDifference(expected, Render(shuffled, viewer, setting)), 1.0f / 255);
    }
  }
}

//------------------------------------------------------------------------------
/** Phong's model by the book, with angles: a lamp in the mesh and a reddish sun. */
Vec ShadeByAngles(const Vec& color, const Vec& gradient, const Vec& middle, const Viewer& viewer)
{
  const auto angle = [](const Vec& a, const Vec& b)
  { return std::acos(std::clamp(Dot(Normalize(a), Normalize(b)), -1.0, 1.0)); };
  const Vec toEye = viewer.Frustum.Parallel ? -1 * viewer.Forward : viewer.Eye - middle;
  Vec lit = 0.2 * color;
  const std::array<Vec, 2> toLights{ Vec{ 1, 2, 7 } - middle, Vec{ -1, 0.3, 0.5 } };
  const std::array<Vec, 2> tints{ Vec{ 1, 1, 1 }, Vec{ 0.8, 0.3, 0.1 } };
  for (std::size_t i = 0; i < 2; ++i)
  {
    // The side of the surface that the light falls on, and the light turned by half a circle.
    const double incidence = angle(gradient, toLights[i]);
    const Vec normal = Normalize(incidence > std::acos(-1) / 2 ? -1 * gradient : gradient);
    const Vec light = Normalize(toLights[i]);
    const Vec mirrored = light + 2 * (Dot(normal, light) * normal - light);
    const double diffuse = 0.6 * std::abs(std::cos(incidence));
    const double specular = 0.4 * std::pow(std::max(0.0, std::cos(angle(mirrored, toEye))), 5);
    for (std::size_t c = 0; c < 3; ++c)
    {
      lit[c] += diffuse * tints[i][c] * color[c] + specular * 0.5;
    }
  }
  return { std::min(1.0, lit[0]), std::min(1.0, lit[1]), std::min(1.0, lit[2]) };
}

class ShadedAgainstReference : public AgainstReference
{
};

TEST_P(ShadedAgainstReference, CompositeAndSampled)
{
  const auto mesh = GetMesh();
  for (const RayMode mode : { RayMode::Composite, RayMode::Sampled })
  {
    std::size_t bad = 0;
    std::size_t pixels = 0;
    auto viewers = MakeViewers(5, std::get<1>(GetParam()));
    viewers.resize(8, viewers.front());
    for (const Viewer& viewer : viewers)
    {
      Reference reference;
      reference.Mode = mode;
      reference.Color = Ramp;
      reference.Shade = [&](const Vec& color, const Vec& gradient, const Vec& middle)
      { return ShadeByAngles(color, gradient, middle, viewer); };
      RayShading shading;
      shading.Lights = { { { 1, 2, 7, 1 }, { 1, 1, 1 }, { 0.5, 0.5, 0.5 } },
        { { -1, 0.3, 0.5, 0 }, { 0.8, 0.3, 0.1 }, { 0.5, 0.5, 0.5 } } };
      const Vec& eye = viewer.Frustum.Parallel ? -1 * viewer.Forward : viewer.Eye;
      shading.Eye = { eye[0], eye[1], eye[2], viewer.Frustum.Parallel ? 0.0 : 1.0 };
      shading.Ambient = 0.2;
      shading.Diffuse = 0.6;
      shading.Specular = 0.4;
      shading.SpecularPower = 5;
      Setting setting;
      setting.Mode = mode;
      setting.Settings.Shading = shading;
      reference.Breaks = setting.Breaks;
      const auto expected = reference.Render(mesh, viewer);
      for (const auto instructions : AllInstructions)
      {
        setting.Settings.Instructions = instructions;
        const auto difference =
          Compare(Render(mesh, viewer, setting), expected, viewer.SampleDistance);
        bad += ExpectAsDefined(difference, mode, false);
        pixels += expected.size();
        EXPECT_GT(difference.Lit, 300);
      }
    }
    EXPECT_LE(static_cast<double>(bad), 2e-4 * static_cast<double>(pixels));
  }
}

// Not the slivers: where a face is within rounding of a sample, either side may have it, and light
// falls differently on the two.
INSTANTIATE_TEST_SUITE_P(RayCaster, ShadedAgainstReference,
  testing::Combine(testing::Values("Cubes", "Lattice", "Loose"), testing::Bool()),
  GetReferenceName);

TEST(RayCaster, ShadingIsThatOfTheWorldAndLeavesAloneWhatHasNoGradient)
{
  // A plane of values that is mirrored in x by the mesh's matrix, with its light from there.
  auto mesh = ToReference(MakeCubes(2, 0));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    mesh.Values[i] = mesh.Points[i][0] + mesh.Points[i][1];
  }
  const auto block = MakeBlocks(mesh, 100000).front();
  RayShading shading;
  shading.Ambient = 0.25;
  shading.Diffuse = 0.5;
  shading.Specular = 0;
  shading.Lights = { { { -3, 3, 0, 0 } } };
  // The gradient (1, 1, 0) is at a right angle to the light.
  EXPECT_NEAR(GetShade(shading, *block, 0).Scale[0], 0.25, 1e-6);
  shading.ToWorld[0] = { -1, 0, 0, 5 };
  EXPECT_NEAR(GetShade(shading, *block, 0).Scale[0], 0.75, 1e-6);
  // Twice as long in y: of (1, 1) becomes (-1, 1 / 2), and the cosine 3 / sqrt(10).
  shading.ToWorld[1] = { 0, 2, 0, 0 };
  EXPECT_NEAR(GetShade(shading, *block, 0).Scale[0], 0.25 + 0.5 * 3 / std::sqrt(10), 1e-6);

  for (double& value : mesh.Values)
  {
    value = 0.5;
  }
  const auto constant = GetShade(shading, *MakeBlocks(mesh, 100000).front(), 0);
  EXPECT_EQ(constant.Scale, RayShade().Scale);
  EXPECT_EQ(constant.Add, RayShade().Add);
}

//------------------------------------------------------------------------------
class RayCasterProjection : public testing::TestWithParam<bool>
{
};

TEST_P(RayCasterProjection, PrefilterLeavesOutWhatIsBetweenTheRays)
{
  // 20^3 cubes on about 10^2 pixels: most tetrahedra are smaller than what is between pixels.
  const auto mesh = ToReference(MakeCubes(20, 0.25));
  const auto viewer = Viewer::LookAt({ 40, 37, 53 }, { 10, 10, 10 }, GetParam(), 120);
  std::uint64_t seen[2];
  for (const bool prefilter : { false, true })
  {
    RaySettings settings;
    settings.Prefilter = prefilter;
    RayCaster caster(viewer.GetView(),
      RayTable(RayMode::Composite, Ramp, { 0, 1 }, viewer.SampleDistance, 1), {}, settings);
    caster.Draw(MakeBlocks(mesh, 100000));
    seen[prefilter ? 1 : 0] = caster.GetStatistics().SeenTets;
    EXPECT_EQ(caster.GetStatistics().Tets, mesh.Tets.size());
  }
  EXPECT_EQ(seen[0], mesh.Tets.size());
  EXPECT_LT(seen[1], mesh.Tets.size() / 2);

  // The paper's own count: whose box of pixels has none.
  std::uint64_t covering = 0;
  const RayView view = viewer.GetView();
  for (const auto& tet : mesh.Tets)
  {
    Vec low{ 1e9, 1e9, 1e9 };
    Vec high{ -1e9, -1e9, -1e9 };
    for (const auto corner : tet)
    {
      auto p = view.Transform(mesh.Points[corner]);
      if (view.Perspective)
      {
        p = (1 / p[2]) * p;
      }
      for (std::size_t c = 0; c < 2; ++c)
      {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    }
    const auto hasPixel = [&](std::size_t c) { return std::ceil(low[c]) <= std::floor(high[c]); };
    covering += hasPixel(0) && hasPixel(1) ? 1 : 0;
  }
  EXPECT_GE(seen[1], covering);
  EXPECT_LE(seen[1], covering + covering / 20);
}

INSTANTIATE_TEST_SUITE_P(, RayCasterProjection, testing::Bool());

//------------------------------------------------------------------------------
TEST(RayCaster, ConstantAndLinearFieldsInABoxHaveTheOpticalDepthOfTheFormula)
{
  // A box of 6^3 looked at along x: the light through it is exp(-integral of the extinction).
  auto mesh = ToReference(MakeCubes(6, 0));
  for (const bool linear : { false, true })
  {
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      mesh.Values[i] = linear ? mesh.Points[i][0] / 6 : 0.5;
    }
    // Extinction 0.4 times the value: opacity over a unit of length is 1 - exp(-0.4 value).
    Setting setting;
    setting.Color = [](double value) {
      return std::array<double, 4>{ 1, 1, 1, -std::expm1(-0.4 * value) };
    };
    setting.Settings.Opaque = 0;
    auto viewer = Viewer::LookAt({ -5, 3, 3 }, { 3, 3, 3 }, true, 4);
    viewer.SampleDistance = 0.01;
    const double expected = -std::expm1(-0.4 * 0.5 * 6);
    for (const RayMode mode : { RayMode::Composite, RayMode::XRay, RayMode::Sampled })
    {
      setting.Mode = mode;
      const auto image = Render(mesh, viewer, setting);
      for (std::size_t i = 0; i < image.Colors.size(); i += 4)
      {
        // One sample more or less, of extinction 0.4 at most, over 0.01.
        ASSERT_NEAR(image.Colors[i + 3], expected, 0.4 * 0.01);
        ASSERT_NEAR(image.Colors[i], image.Colors[i + 3], 1e-5);
      }
    }
  }
}

TEST(RayCaster, BlocksThatCannotBeSeenAreNeverAskedFor)
{
  const auto mesh = ToReference(MakeCubes(10, 0.1));
  const auto dense = [](double value) {
    return std::array<double, 4>{ value, 1 - value, 0.5, value > 0.2 ? 0.99 : 0.9 };
  };
  for (const bool parallel : { false, true })
  {
    const auto viewer = Viewer::LookAt({ 5, 5, -20 }, { 5, 5, 5 }, parallel, 8);
    CountingSource all(mesh, 60);
    CountingSource some(mesh, 60);
    const auto expected = RenderSource(all, viewer, dense, 0);
    const auto image = RenderSource(some, viewer, dense, 1e-3f);
    EXPECT_LT(some.Asked, all.Asked / 2); // behind the opaque ones in front
    EXPECT_LE(GetLargestDifference(expected, image), 1.5e-3f);

    const auto aside = Viewer::LookAt({ 1, 1, -20 }, { 1, 1, 4 }, parallel, 2);
    CountingSource seen(mesh, 60);
    RenderSource(seen, aside, Ramp, 0);
    EXPECT_LT(seen.Asked, all.Asked / 2); // outside the image

    CountingSource none(mesh, 60);
    RenderSource(
      none, viewer,
      [](double) {
        return std::array<double, 4>{ 1, 1, 1, 0 };
      },
      0);
    EXPECT_EQ(none.Asked, 0u);
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, WhatIsNotANumberIsNotSeen)
{
  auto mesh = ToReference(MakeCubes(4, 0.1));
  const auto viewer = MakeViewers(4, false)[4];
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();

  // The tetrahedra at some points count as not there.
  auto without = mesh;
  std::erase_if(without.Tets,
    [](const auto& tet)
    { return std::any_of(tet.begin(), tet.end(), [](auto c) { return c == 31 || c == 62; }); });

  // Also where there is no value without a color.
  Setting solid;
  solid.Color = [](double value) { return std::array<double, 4>{ value, 0.5, 1, 0.3 }; };
  for (const Setting& setting : { Setting{}, solid })
  {
    const auto expected = Render(without, viewer, setting);
    for (const double strange : { nan, infinity, -infinity })
    {
      auto values = mesh;
      values.Values[31] = values.Values[62] = strange;
      auto points = mesh;
      points.Points[31][0] = points.Points[62][2] = strange;
      EXPECT_LE(GetLargestDifference(expected, Render(points, viewer, setting)), 1e-3f);
      EXPECT_LE(GetLargestDifference(expected, Render(values, viewer, setting)), 1e-3f);
    }
  }
}

TEST(RayCaster, SamplesThatCannotBeToldApartAreRefused)
{
  CountingSource source(ToReference(MakeCubes(2, 0.1)), 100);
  for (const bool parallel : { false, true })
  {
    auto viewer = Viewer::LookAt({ 1, 1, -5 }, { 1, 1, 1 }, parallel, 4);
    viewer.Width = viewer.Height = 2;
    viewer.SampleDistance = 1e-5;
    EXPECT_NO_THROW(RenderSource(source, viewer, Ramp, 1e-3f));
    for (const double distance : { 1e-6, 1e-9, 1e-30, 1e-300 })
    {
      viewer.SampleDistance = distance;
      EXPECT_THROW(RenderSource(source, viewer, Ramp, 1e-3f), Error);
    }
  }
}

TEST(RayCaster, ViewsThatShowNothingAreRefused)
{
  const auto make = [](auto&& change)
  {
    auto viewer = Viewer::LookAt({ 4, 4, -20 }, { 4, 4, 4 }, false, 7);
    change(viewer);
    return viewer.GetView();
  };
  EXPECT_NO_THROW(make([](Viewer&) {}));
  EXPECT_THROW(make([](Viewer& v) { v.Width = 0; }), Error);
  EXPECT_THROW(make([](Viewer& v) { v.Height = -5; }), Error);
  EXPECT_THROW(make([](Viewer& v) { v.SampleDistance = 0; }), Error);
  EXPECT_THROW(make([](Viewer& v) { v.SampleDistance = -1; }), Error);
  EXPECT_THROW(make([](Viewer& v) { v.SampleDistance = std::nan(""); }), Error);
  EXPECT_THROW(make([](Viewer& v) { v.Frustum.Right = v.Frustum.Left; }), Error);
  EXPECT_THROW(make([](Viewer& v) { v.Up = v.Right; }), Error);
}
}
}
