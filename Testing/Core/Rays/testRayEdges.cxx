// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The ray caster where something ends: rays at limits and planes, tables at their last entries,
// light at what is opaque, images before they are done.

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
constexpr RayMode AllModes[] = { RayMode::Composite, RayMode::Sampled, RayMode::Maximum,
  RayMode::XRay };

/** Compares with the definition; returns how much there was to see. */
double Check(const ReferenceMesh& mesh, const Viewer& viewer, const Setting& setting)
{
  Reference reference;
  reference.Mode = setting.Mode;
  reference.Color = [&](double value)
  { return setting.Color(std::clamp(value, setting.Values.Min, setting.Values.Max)); };
  reference.Breaks = setting.Breaks;
  reference.Planes = setting.Planes;
  reference.Unit = setting.Unit;
  const auto expected = reference.Render(mesh, viewer);
  auto used = setting;
  used.Settings.Opaque = setting.Mode == RayMode::Sampled ? setting.Settings.Opaque : 0;
  const auto image = Render(mesh, viewer, used);
  const auto difference = Compare(image, expected, viewer.SampleDistance);
  const bool withDepth = setting.Mode == RayMode::Composite || setting.Mode == RayMode::Sampled;
  EXPECT_LE(static_cast<double>(ExpectAsDefined(difference, setting.Mode, withDepth)),
    5e-4 * static_cast<double>(expected.size()));
  return difference.Lit / static_cast<double>(expected.size());
}

//------------------------------------------------------------------------------
TEST(RayCaster, WhatIsBeforeNearAndBehindFarIsNotSeen)
{
  const auto mesh = ToReference(MakeCubes(5, 0.2));
  for (const bool parallel : { false, true })
  {
    auto viewer = Viewer::LookAt({ 9, 7, 8 }, { 2.5, 2.5, 2.5 }, parallel, 7);
    for (const RayMode mode : AllModes)
    {
      Setting setting;
      setting.Mode = mode;
      viewer.Frustum.Near = 8.03;
      viewer.Frustum.Far = 10.57;
      EXPECT_GT(Check(mesh, viewer, setting), 0.3);
      viewer.Frustum.Near = 9.51;
      viewer.Frustum.Far = 1e30;
      EXPECT_GT(Check(mesh, viewer, setting), 0.2);
      viewer.Frustum.Near = 30;
      EXPECT_EQ(Check(mesh, viewer, setting), 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, OfPlanesAndNearAndFarTheOneThatCutsMoreCounts)
{
  const auto mesh = ToReference(MakeCubes(5, 0.2));
  const Vec eye{ 9, 7, 8 };
  for (const bool parallel : { false, true })
  {
    auto viewer = Viewer::LookAt(eye, { 2.5, 2.5, 2.5 }, parallel, 7);
    const Vec& to = viewer.Forward;
    const auto before = [&](double depth) {
      return std::array<double, 4>{ to[0], to[1], to[2], -Dot(to, eye) - depth };
    };
    const auto behind = [&](double depth) {
      return std::array<double, 4>{ -to[0], -to[1], -to[2], Dot(to, eye) + depth };
    };
    for (const RayMode mode : AllModes)
    {
      Setting setting;
      setting.Mode = mode;
      viewer.Frustum.Near = 9.51;
      viewer.Frustum.Far = 10.57;
      setting.Planes = { before(8.03), behind(12.04) };
      EXPECT_GT(Check(mesh, viewer, setting), 0.2);
      viewer.Frustum.Near = 8.03;
      viewer.Frustum.Far = 12.04;
      setting.Planes = { before(9.51), behind(10.57) };
      EXPECT_GT(Check(mesh, viewer, setting), 0.2);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, OfSeveralPlanesEachCuts)
{
  const auto mesh = ToReference(MakeCubes(5, 0.2));
  for (const bool parallel : { false, true })
  {
    const auto viewer = Viewer::LookAt({ 2.5, 2.5, 12 }, { 2.5, 2.5, 2.5 }, parallel, 7);
    const std::array<double, 4> near{ 0, 0, -1, 3.13 };
    const std::array<double, 4> nearer{ 0, 0, -1, 4.21 };
    const std::array<double, 4> far{ 0, 0, 1, -1.13 };
    const std::array<double, 4> farther{ 0, 0, 1, -0.53 };
    Setting setting;
    for (const RayMode mode : { RayMode::Composite, RayMode::Sampled })
    {
      setting.Mode = mode;
      for (const auto& first : { near, nearer })
      {
        for (const auto& last : { far, farther })
        {
          // In any order, the one that cuts more counts.
          setting.Planes = { first, near, last, far };
          EXPECT_GT(Check(mesh, viewer, setting), 0.2);
          setting.Planes = { far, last, near, first };
          EXPECT_GT(Check(mesh, viewer, setting), 0.2);
        }
      }
      // Along the rays: each is on one side as a whole.
      setting.Planes = { { 0, 1, 0, -2.51 } };
      const double half = Check(mesh, viewer, setting);
      setting.Planes = {};
      EXPECT_NEAR(half, Check(mesh, viewer, setting) / 2, 0.05);
      // Behind the eye, which leaves nothing, or all.
      setting.Planes = { { 0, 0, 1, -20 } };
      EXPECT_EQ(Check(mesh, viewer, setting), 0);
      setting.Planes = { { 0, 0, -1, 20 } };
      EXPECT_GT(Check(mesh, viewer, setting), 0.2);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, WideTetrahedraAreNearerInTheirMiddleThanAtTheirCorners)
{
  // A plate across the view: all corners are as far away as each other.
  auto mesh = ToReference(MakeCubes(1, 0));
  for (auto& point : mesh.Points)
  {
    point = { 6 * point[0] - 3, 6 * point[1] - 3, -3 - 0.03 * point[2] };
  }
  auto viewer = Viewer::LookAt({ 0, 0, 0 }, { 0, 0, -3 }, false, 6);
  viewer.SampleDistance = 0.25;
  Setting setting;
  setting.Color = [](double) { return std::array<double, 4>{ 1, 0.5, 0.2, 0.9 }; };
  EXPECT_GT(Check(mesh, viewer, setting), 0.05);
}

//------------------------------------------------------------------------------
TEST(RayCaster, TheEyeMayBeWithinATetrahedronOnAFaceOrInACorner)
{
  const auto mesh = ToReference(MakeCubes(2, 0));
  for (const Vec& eye : { Vec{ 1.1, 0.9, 1.3 }, Vec{ 1, 1, 0.5 }, Vec{ 0, 0, 0 } })
  {
    auto viewer = Viewer::LookAt(eye, eye + Vec{ 0.3, 0.5, 0.7 }, false, 1.4);
    viewer.SampleDistance = 0.03;
    viewer.Frustum.Near = 0.01; // whose the eye is, only rounding knows
    Setting setting;
    setting.Color = [](double value) {
      return std::array<double, 4>{ value, 1 - value, 0.5, 0.5 * value };
    };
    for (const RayMode mode : AllModes)
    {
      SCOPED_TRACE(testing::Message() << eye[0] << ", mode " << static_cast<int>(mode));
      setting.Mode = mode;
      EXPECT_GT(Check(mesh, viewer, setting), 0.5);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, ValuesBeyondTheTableLookAsItsEnds)
{
  const auto mesh = ToReference(MakeCubes(5, 0.2));
  Setting setting;
  setting.Values = { 0.4, 0.6 };
  setting.Breaks = { 0.4, 0.6 };
  setting.Color = [](double value) {
    return std::array<double, 4>{ value, 1 - value, 5 * (value - 0.4), 0.9 * value - 0.2 };
  };
  for (const RayMode mode : AllModes)
  {
    setting.Mode = mode;
    EXPECT_GT(Check(mesh, MakeViewers(5, false)[4], setting), 0.3);
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, OnlyTheLastValueMayBeVisible)
{
  // Visible is but the highest value, or the lowest: that of all in a part of the mesh.
  auto mesh = ToReference(MakeCubes(4, 0.1));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    mesh.Values[i] = mesh.Points[i][0] < 2.5 ? 0 : 1;
  }
  const auto viewer = MakeViewers(4, true)[4];
  Setting setting;
  for (const double visible : { 0, 1 })
  {
    setting.Color = [=](double value) {
      return std::array<double, 4>{ 1, 1, 1, value == visible ? 0.7 : 0 };
    };
    for (const RayMode mode : { RayMode::Composite, RayMode::Maximum, RayMode::XRay })
    {
      setting.Mode = mode;
      const RayTable table(mode, setting.Color, { 0, 1 }, 0.1, 1);
      EXPECT_FALSE(table.IsTransparent({ visible, visible }));
      EXPECT_FALSE(table.IsTransparent({ -3, 4 }));
      EXPECT_TRUE(table.IsTransparent({ 0.3, 0.6 }));
      EXPECT_TRUE(table.IsTransparent({ 1 - visible, 1 - visible }));
      EXPECT_TRUE(table.IsTransparent({ 1, 0 })); // there are none
      EXPECT_EQ(table.IsTransparent({ 2, 3 }), visible == 0);
      EXPECT_EQ(table.IsTransparent({ -3, -2 }), visible == 1);
      const auto image = Render(mesh, viewer, setting);
      double light = 0;
      for (std::size_t i = 3; i < image.Colors.size(); i += 4)
      {
        light += image.Colors[i];
      }
      EXPECT_GT(light, 200);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, WhatIsVisibleOnlyBetweenTwoEntriesOfTheTableIsSeen)
{
  // One entry is visible, and so the cells on both sides of it; of the lower one, only its end.
  constexpr double entry = 1.0 / RayTable::Size;
  constexpr double top = 1024 * entry;
  auto mesh = ToReference(MakeCubes(4, 0.1));
  std::fill(mesh.Values.begin(), mesh.Values.end(), top - entry / 2);
  const auto viewer = MakeViewers(4, true)[4];
  Setting setting;
  setting.Unit = viewer.SampleDistance;
  for (const RayMode mode : AllModes)
  {
    setting.Mode = mode;
    // What the table holds is linear between its entries: opacities, or optical depths.
    const bool ofDepths = mode == RayMode::Composite || mode == RayMode::XRay;
    setting.Color = [=](double value)
    {
      const double height = std::max(0.0, 1 - std::abs(value - top) / entry) / 16;
      return std::array<double, 4>{ 1, 1, 1, ofDepths ? -std::expm1(-height) : height };
    };
    const RayTable table(mode, setting.Color, setting.Values, viewer.SampleDistance, setting.Unit);
    EXPECT_TRUE(table.IsTransparent({ top - 1.9 * entry, top - 1.1 * entry }));
    EXPECT_FALSE(table.IsTransparent({ top - 0.9 * entry, top - 0.1 * entry }));
    EXPECT_FALSE(table.IsTransparent({ top + 0.1 * entry, top + 0.9 * entry }));
    EXPECT_TRUE(table.IsTransparent({ top + 1.1 * entry, top + 1.9 * entry }));
    EXPECT_GT(Check(mesh, viewer, setting), 0.2);
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, OneValueIsARange)
{
  auto mesh = ToReference(MakeCubes(4, 0.1));
  std::fill(mesh.Values.begin(), mesh.Values.end(), 7.25);
  Setting setting;
  setting.Values = { 7.25, 7.25 };
  setting.Color = [](double value) {
    return std::array<double, 4>{ value / 10, 0.5, 0, value == 7.25 ? 0.4 : 0 };
  };
  for (const RayMode mode : AllModes)
  {
    setting.Mode = mode;
    EXPECT_GT(Check(mesh, MakeViewers(4, false)[5], setting), 0.3);
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, WhatIsFullyOpaqueHasAColor)
{
  const auto mesh = ToReference(MakeCubes(4, 0.1));
  Setting setting;
  setting.Color = [](double value) { return std::array<double, 4>{ value, 1 - value, 0.5, 1 }; };
  for (const double unit : { 0.05, 1.0, 40.0 })
  {
    setting.Unit = unit;
    for (const RayMode mode : AllModes)
    {
      setting.Mode = mode;
      setting.Settings.Opaque = 0;
      EXPECT_GT(Check(mesh, MakeViewers(4, true)[6], setting), 0.3);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, WhatIsBehindOpaqueFragmentsIsLeftOutInAnyOrder)
{
  // Layers that are opaque, one behind the other, with nothing in between: fragments become opaque
  // in any order.
  auto mesh = ToReference(MakeCubes(7, 0.2));
  Setting setting;
  setting.Color = [](double value)
  {
    const double layer = std::sin(40 * value);
    return std::array<double, 4>{ value, 1 - value, layer > 0 ? 1.0 : 0.0, layer > 0 ? 0.9999 : 0 };
  };
  for (const bool parallel : { false, true })
  {
    const auto viewer = MakeViewers(7, parallel)[5];
    std::mt19937 random(5);
    for (const RayMode mode : { RayMode::Composite, RayMode::Sampled })
    {
      setting.Mode = mode;
      setting.Settings = {};
      setting.Settings.Opaque = 0;
      setting.TetsInBlock = 100000;
      const auto expected = Render(mesh, viewer, setting);
      setting.Settings.Opaque = 1e-3f;
      for (const std::size_t tetsInBlock : { 1, 13, 300, 100000 })
      {
        std::shuffle(mesh.Tets.begin(), mesh.Tets.end(), random);
        setting.TetsInBlock = tetsInBlock;
        for (const bool both : { false, true })
        {
          setting.Settings.FromBothEnds = both;
          const auto image = Render(mesh, viewer, setting);
          EXPECT_LE(GetLargestDifference(expected, image), 1.0f / 255);
          float mostDepth = 0;
          for (std::size_t i = 0; i < image.Depths.size(); ++i)
          {
            const float difference = image.Depths[i] == expected.Depths[i]
              ? 0
              : std::abs(image.Depths[i] - expected.Depths[i]);
            mostDepth = std::max(mostDepth, difference);
          }
          EXPECT_LE(mostDepth, 1e-4f);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, OrderOfReleaseKeepsFragmentsFew)
{
  auto mesh = ToReference(MakeCubes(8, 0.25));
  std::mt19937 random(2);
  std::shuffle(mesh.Tets.begin(), mesh.Tets.end(), random);
  const auto viewers = MakeViewers(8, false);
  for (const std::size_t view : { 4, 5, 6 })
  {
    for (const bool both : { false, true })
    {
      RaySettings settings;
      settings.FromBothEnds = both;
      settings.Opaque = 0;
      RayCaster caster(viewers[view].GetView(),
        RayTable(RayMode::Composite, Ramp, { 0, 1 }, 0.1, 1), {}, settings);
      caster.Draw(MakeBlocks(mesh, mesh.Tets.size()));
      const auto pixels = static_cast<double>(viewers[view].Width) * viewers[view].Height;
      const auto statistics = caster.GetStatistics();
      EXPECT_EQ(statistics.Tets, mesh.Tets.size());
      EXPECT_LE(statistics.SeenTets, mesh.Tets.size());
      EXPECT_LT(static_cast<double>(statistics.MostFragments), (both ? 1.1 : 1.02) * pixels);
      EXPECT_LT(statistics.MostWaiting, mesh.Tets.size());
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, SamplesAreCountedToTheFarthestCornerOfTheImage)
{
  CountingSource source(ToReference(MakeCubes(2, 0.1)), 100);
  auto viewer = Viewer::LookAt({ 1, 1, -5 }, { 1, 1, 1 }, false, 4);
  viewer.Width = viewer.Height = 2;
  viewer.SampleDistance = 3e-6; // 2.4 million straight ahead
  EXPECT_NO_THROW(RenderSource(source, viewer, Ramp, 1e-3f));
  for (const double side : { -1.0, 1.0 })
  {
    auto aside = viewer;
    aside.Frustum.Right = side > 0 ? 5 : 0.1;
    aside.Frustum.Left = side > 0 ? -0.1 : -5;
    EXPECT_THROW(RenderSource(source, aside, Ramp, 1e-3f), Error);
  }
}

//------------------------------------------------------------------------------
TEST(RayCaster, ADrawingThatIsStoppedCanBeFinished)
{
  CountingSource source(ToReference(MakeCubes(6, 0.1)), 20);
  const auto viewer = MakeViewers(6, false)[4];
  RayCaster caster(viewer.GetView(), RayTable(RayMode::Composite, Ramp, { 0, 1 }, 0.1, 1));
  int signs = 0;
  try
  {
    caster.Draw(source, [&](double fraction) { return ++signs < 3 && fraction >= 0; });
    FAIL() << "went on";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Aborted);
  }
  EXPECT_EQ(signs, 3);
  const auto asked = source.Asked;
  EXPECT_LT(asked, source.GetNumberOfBlocks());
  std::vector<float> rgba(4 * static_cast<std::size_t>(viewer.Width) * viewer.Height, -1);
  caster.Finish(rgba.data());
  EXPECT_TRUE(std::all_of(rgba.begin(), rgba.end(), [](float c) { return c >= 0 && c <= 1; }));
}
}
}
