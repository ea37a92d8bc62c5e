// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Images by the opacity models.

#include "gatunHartleyProjector.h"

#include "gatunExactSource.h"
#include "gatunHartleyPixels.h"
#include "gatunVolumePhantoms.h"
#include "gatunVolumeReference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace gatun::test
{
namespace
{
using Triple = HartleyLayout::Triple;
}

//------------------------------------------------------------------------------
// Equation 6: the opacity of a ray is that of its integral, whatever the blocks are.
TEST(HartleyOpacity, ExponentialModelIsExact)
{
  const auto volume = MakeHead({ 37, 33, 35 });
  const ReferenceVolume reference(volume.Values.data(), volume.Size, 0);
  HartleyShading shading = MakeGray(HartleyOpacityModel::Exponential);
  shading.Extinction = 4e-4;
  for (const std::uint32_t block : { 2u, 5u, 8u, 16u, 32u, 0u })
  {
    HartleyProjector projector(MakeSource(volume.Values, volume.Size, block));
    for (const Vector& turns : GetTurns())
    {
      SCOPED_TRACE(testing::Message()
        << "block " << block << " turns " << turns[0] << " " << turns[1] << " " << turns[2]);
      const auto view = MakeTurnedView(volume.Size, turns, 61, 1);
      const auto image = projector.Draw(view, shading);
      PixelDifference opacity;
      ForEachPixel(view,
        [&](std::size_t i, const Vector& point)
        {
          const double depth = shading.Extinction * reference.Integrate(point, view.Step);
          opacity.Add(static_cast<double>(image.Colors[i][3]), 1 - std::exp(-depth));
        });
      EXPECT_LT(opacity.Mean, 2e-3);
      EXPECT_LT(opacity.Largest, 2e-2);
    }
  }
}

//------------------------------------------------------------------------------
// Most of a slab is empty, and nothing of the rest is lost. A table with colors has more planes, of
// which the first is the same.
TEST(HartleyOpacity, ScatteredSpotsAreDrawn)
{
  Phantom<std::uint8_t> volume{ { 70, 60, 50 }, {} };
  volume.Values.resize(70 * 60 * 50);
  std::mt19937 random(5);
  std::uniform_int_distribution<std::size_t> place(0, volume.Values.size() - 1);
  for (int i = 0; i < 40; ++i)
  {
    volume.Values[place(random)] = 200;
  }
  const ReferenceVolume reference(volume.Values.data(), volume.Size, 0);
  HartleyShading gray;
  gray.OpacityModel = HartleyOpacityModel::Exponential;
  gray.Extinction = 2e-3;
  HartleyShading colored = gray;
  gray.Table.assign(2, { 0.5f, 0.5f, 0.5f, 0 });
  colored.Table.assign(2, { 0.5f, 0.25f, 0.75f, 0 });
  for (const std::uint32_t block : { 4u, 8u, 16u })
  {
    const auto source = MakeSource(volume.Values, volume.Size, block);
    HartleyProjector projector(source);
    HartleyProjector sums(source, { HartleyMethod::Basis });
    for (const Vector& turns : GetTurns())
    {
      const auto view = MakeTurnedView(volume.Size, turns, 90, 1);
      const auto image = projector.Draw(view, gray);
      const auto other = projector.Draw(view, colored);
      const auto summed = sums.Draw(view, gray);
      PixelDifference opacity;
      ForEachPixel(view,
        [&](std::size_t i, const Vector& point)
        {
          const double depth = gray.Extinction * reference.Integrate(point, view.Step);
          opacity.Add(static_cast<double>(image.Colors[i][3]), 1 - std::exp(-depth));
          EXPECT_NEAR(other.Colors[i][0], image.Colors[i][0], 1e-6);
          EXPECT_NEAR(other.Colors[i][3], image.Colors[i][3], 1e-6);
          EXPECT_NEAR(summed.Colors[i][3], image.Colors[i][3], 1e-4);
        });
      EXPECT_LT(opacity.Mean, 2e-3); // lattice points round off the kinks of single voxels
    }
  }
}

//------------------------------------------------------------------------------
// Densities may count from any value on, whatever the smallest is.
TEST(HartleyOpacity, ExponentialModelCountsFromZero)
{
  auto volume = MakeSmooth({ 19, 17, 18 });
  for (float& value : volume.Values)
  {
    value += 3;
  }
  const ReferenceVolume reference(volume.Values.data(), volume.Size, 0);
  HartleyShading shading = MakeGray(HartleyOpacityModel::Exponential);
  shading.Extinction = 0.01;
  shading.Zero = 1.5;
  for (const std::uint32_t block : { 4u, 0u })
  {
    HartleyProjector projector(MakeSource(volume.Values, volume.Size, block));
    const auto view = MakeTurnedView(volume.Size, { 0.1, 0.2, 0.3 }, 31, 1);
    const auto image = projector.Draw(view, shading);
    PixelDifference opacity;
    ForEachPixel(view,
      [&](std::size_t i, const Vector& point)
      {
        const double depth = shading.Extinction *
          (reference.Integrate(point, view.Step) -
            shading.Zero * reference.IntegrateWeight(point, view.Step));
        opacity.Add(static_cast<double>(image.Colors[i][3]), 1 - std::exp(-depth));
      });
    EXPECT_LT(opacity.Largest, 1e-2);
    EXPECT_LT(opacity.Mean, 2e-3);
  }
}

//------------------------------------------------------------------------------
// The mean density of a block stands for its voxels: good where blocks are small, and worse the
// larger they are.
TEST(HartleyOpacity, TransferFunctionComesCloserWithSmallerBlocks)
{
  const auto volume = MakeSmooth({ 32, 32, 32 });
  const auto [least, most] = std::minmax_element(volume.Values.begin(), volume.Values.end());
  const ReferenceVolume reference(volume.Values.data(), volume.Size, static_cast<double>(*least));
  for (const Vector& turns : { Vector{ 0, 0, 0 }, Vector{ 0.48, 0.1, 0.95 } })
  {
    const auto view = MakeTurnedView(volume.Size, turns, 48, 1);
    double before = 0;
    for (const std::uint32_t block : { 2u, 8u, 32u })
    {
      HartleyShading shading = MakeGray(HartleyOpacityModel::TransferFunction);
      shading.First = static_cast<double>(*least);
      shading.Last = static_cast<double>(*most);
      HartleyProjector projector(MakeSource(volume.Values, volume.Size, block));
      const auto image = projector.Draw(view, shading);
      PixelDifference difference;
      ForEachPixel(view,
        [&](std::size_t i, const Vector& point)
        {
          const auto expected = reference.Cast(point, view.Step, shading, 4);
          for (std::size_t channel = 0; channel < 4; ++channel)
          {
            difference.Add(static_cast<double>(image.Colors[i][channel]), expected[channel]);
          }
        });
      EXPECT_GT(difference.Mean, before);
      before = difference.Mean;
      EXPECT_LT(difference.Mean, block == 2 ? 0.01 : 0.2);
    }
  }
}

//------------------------------------------------------------------------------
// What is in front hides what is behind, from all sides.
TEST(HartleyOpacity, FrontHidesBack)
{
  const Triple size{ 24, 24, 24 };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::vector<std::uint8_t> values(24 * 24 * 24, 0);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const std::array<std::size_t, 3> place{ i % 24, i / 24 % 24, i / 576 };
      values[i] = place[axis] < 8 ? 100 : place[axis] < 16 ? 0 : 200;
    }
    HartleyShading shading;
    shading.OpacityModel = HartleyOpacityModel::TransferFunction;
    shading.Table.assign(256, { 0, 0, 0, 0 });
    for (std::size_t i = 50; i < 256; ++i)
    {
      const bool high = i > 150;
      shading.Table[i] = { high ? 0.0f : 1.0f, 0, high ? 1.0f : 0.0f, 0.9f };
    }
    for (const std::uint32_t block : { 4u, 8u, 5u })
    {
      HartleyProjector projector(MakeSource(values, size, block));
      for (const double side : { 1.0, -1.0 })
      {
        for (const double slope : { 0.0, 0.3, -0.3 })
        {
          HartleyView view;
          view.Width = view.Height = 1;
          view.Origin = { 11.5, 11.5, 11.5 };
          view.ColumnStep = view.RowStep = view.Step = {};
          view.ColumnStep[(axis + 1) % 3] = 1;
          view.RowStep[(axis + 2) % 3] = 1;
          view.Step[axis] = side;
          view.Step[(axis + 1) % 3] = slope;
          view.Step[(axis + 2) % 3] = -slope / 2;
          const auto pixel = projector.Draw(view, shading).Colors[0];
          EXPECT_GT(pixel[side > 0 ? 0 : 2], 0.97f);
          EXPECT_LT(pixel[side > 0 ? 2 : 0], 0.03f);
          EXPECT_GT(pixel[3], 0.999f);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// Of two blocks of a slab, too, that which an oblique ray meets first hides the other.
TEST(HartleyOpacity, SideHidesSide)
{
  HartleyShading shading;
  shading.OpacityModel = HartleyOpacityModel::TransferFunction;
  for (int i = 0; i < 256; ++i)
  {
    shading.Table.push_back({ i > 150 ? 0.0f : 1.0f, 0, i > 150 ? 1.0f : 0.0f, 0.95f });
  }
  for (std::size_t across = 0; across < 3; ++across)
  {
    Triple size{ 8, 8, 8 };
    size[across] = 16;
    std::vector<std::uint8_t> values(std::size_t{ size[0] } * size[1] * size[2]);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const std::array<std::size_t, 3> place{ i % size[0], i / size[0] % size[1],
        i / size[0] / size[1] };
      values[i] = place[across] < 8 ? 100 : 200;
    }
    HartleyProjector projector(MakeSource(values, size, 8));
    for (const std::size_t along : { (across + 1) % 3, (across + 2) % 3 })
    {
      for (const double forward : { 1.0, -1.0 })
      {
        for (const double sideways : { 0.9, -0.9 })
        {
          HartleyView view;
          view.Width = view.Height = 1;
          view.Origin = { 3.5, 3.5, 3.5 };
          view.Origin[across] = 7.5;
          view.ColumnStep = view.RowStep = view.Step = {};
          view.ColumnStep[across] = 1;
          view.RowStep[3 - across - along] = 1;
          view.Step[along] = forward;
          view.Step[across] = sideways;
          const auto pixel = projector.Draw(view, shading).Colors[0];
          EXPECT_GT(pixel[sideways > 0 ? 0 : 2], 0.95f);
          EXPECT_LT(pixel[sideways > 0 ? 2 : 0], 0.05f);
        }
      }
    }
  }
}
}
