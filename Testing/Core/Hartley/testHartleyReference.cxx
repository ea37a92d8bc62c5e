// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The reference that images of volumes are compared with, against what is known without it.

#include "gatunVolumePhantoms.h"
#include "gatunVolumeReference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

using Triple = ReferenceVolume::Triple;

/** 3 + 2x - y + 0.5z + xyz / 50: trilinear between voxels, whatever the cell. */
double Trilinear(const Vector& p)
{
  return 3 + 2 * p[0] - p[1] + 0.5 * p[2] + p[0] * p[1] * p[2] / 50;
}

std::vector<double> MakeTrilinear(const Triple& size)
{
  std::vector<double> values;
  for (std::uint32_t z = 0; z < size[2]; ++z)
  {
    for (std::uint32_t y = 0; y < size[1]; ++y)
    {
      for (std::uint32_t x = 0; x < size[0]; ++x)
      {
        values.push_back(
          Trilinear({ static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) }));
      }
    }
  }
  return values;
}

TEST(HartleyReference, InterpolatesBetweenVoxels)
{
  const Triple size{ 5, 6, 7 };
  const auto values = MakeTrilinear(size);
  const ReferenceVolume volume(values.data(), size, 0);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector p{ 4 * uniform(random), 5 * uniform(random), 6 * uniform(random) };
    EXPECT_NEAR(volume.GetSample(p), Trilinear(p), 1e-12);
    EXPECT_EQ(volume.GetWeight(p), 1);
  }
  EXPECT_NEAR(volume.GetSample({ -0.25, 2, 3 }), 0.75 * Trilinear({ 0, 2, 3 }), 1e-12);
  EXPECT_NEAR(volume.GetWeight({ -0.25, 5.5, 3 }), 0.375, 1e-12);
  EXPECT_EQ(volume.GetSample({ 5, 2, 3 }), 0);
  EXPECT_EQ(volume.GetSample({ -1, 2, 3 }), 0);
}

/** A point before the end of the hats that is at the end once their beginning is taken away. */
TEST(HartleyReference, EndsWithTheVoxels)
{
  const Triple size{ 32, 32, 32 };
  const std::vector<float> values(32 * 32 * 32, 1);
  const ReferenceVolume block(values.data(), size, 0);
  const double end = std::nextafter(32.0, 0.0);
  EXPECT_LT(end, 32);
  EXPECT_EQ(end + 1, 33);
  EXPECT_NEAR(block.GetSample({ end, end, end }), 0, 1e-12);
}

/** The hats of all blocks add up to the volume. */
TEST(HartleyReference, BlocksAddUp)
{
  const Triple size{ 7, 5, 6 };
  const auto values = MakeTrilinear(size);
  const ReferenceVolume volume(values.data(), size, 1);
  const Vector point{ -2, 0.3, 1.1 };
  const Vector step{ 0.8, 0.5, 0.4 };
  double sum = 0;
  double weight = 0;
  for (std::uint32_t z = 0; z < size[2]; z += 3)
  {
    for (std::uint32_t y = 0; y < size[1]; y += 3)
    {
      for (std::uint32_t x = 0; x < size[0]; x += 3)
      {
        const ReferenceVolume block(values.data(), size, 1, { x, y, z },
          { std::min(x + 3, size[0]), std::min(y + 3, size[1]), std::min(z + 3, size[2]) });
        sum += block.Integrate(point, step);
        weight += block.IntegrateWeight(point, step);
      }
    }
  }
  EXPECT_NEAR(sum, volume.Integrate(point, step), 1e-11);
  EXPECT_NEAR(weight, volume.IntegrateWeight(point, step), 1e-11);
}

/** Line integrals against very fine sums, along rays in all directions. */
TEST(HartleyReference, IntegralsAreThoseOfFineSums)
{
  const auto head = MakeHead({ 13, 17, 11 });
  const ReferenceVolume volume(head.Values.data(), head.Size, 0);
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 50; ++i)
  {
    const Vector point{ 6 + 2 * normal(random), 8 + 2 * normal(random), 5 + 2 * normal(random) };
    Vector step{ normal(random), normal(random), normal(random) };
    if (i % 5 == 0)
    {
      step[static_cast<std::size_t>(i / 5) % 3] = 0;
    }
    const int parts = 20000;
    const RayPart ray = volume.Clip(point, step);
    double sum = 0;
    for (int k = 0; k < parts; ++k)
    {
      sum += volume.GetSample(
        AddTimes(point, ray.Begin + (ray.End - ray.Begin) * (k + 0.5) / parts, step));
    }
    sum *= (ray.End - ray.Begin) / parts;
    EXPECT_NEAR(volume.Integrate(point, step), sum, 1e-4 * std::max(1.0, sum));
  }
}

/** Along an axis, samples a voxel apart sum up to the voxels wherever they begin. */
TEST(HartleyReference, SumsAlongAnAxisAreExact)
{
  const auto head = MakeHead({ 12, 9, 10 });
  const ReferenceVolume volume(head.Values.data(), head.Size, 0);
  for (std::uint32_t y = 0; y < 9; ++y)
  {
    for (std::uint32_t x = 0; x < 12; ++x)
    {
      double sum = 0;
      for (std::uint32_t z = 0; z < 10; ++z)
      {
        sum += head.Values[x + 12 * (y + 9 * z)];
      }
      const Vector point{ static_cast<double>(x), static_cast<double>(y), -3.3 };
      EXPECT_NEAR(volume.SumSamples(point, { 0, 0, 1 }), sum, 1e-9);
      EXPECT_NEAR(volume.Integrate(point, { 0, 0, -1 }), sum, 1e-9);
    }
  }
}

/** One of the samples lies on the plane through the center. */
TEST(HartleyReference, SamplesHaveTheirPhase)
{
  const ReferenceVolume volume(std::vector<float>(27, 1).data(), { 3, 3, 3 }, 0);
  const Vector step{ 0.6, 0, 0.8 };
  const Vector point{ -4, 1.5, -5.2 };
  const RaySamples samples = volume.GetSamples(point, step);
  ASSERT_LT(samples.First, samples.End);
  const Vector place = AddTimes(point, samples.Phase, step);
  EXPECT_NEAR(InnerProduct(AddTimes(place, -1, volume.GetCenter()), step), 0, 1e-12);
  EXPECT_GT(volume.GetWeight(AddTimes(place, static_cast<double>(samples.First), step)), 0);
  EXPECT_EQ(volume.GetWeight(AddTimes(place, static_cast<double>(samples.First - 1), step)), 0);
  EXPECT_EQ(volume.GetWeight(AddTimes(place, static_cast<double>(samples.End), step)), 0);
}

/** Under the exponential model the opacity is that of the sum; of a constant, colors are in closed
 * form under any. */
TEST(HartleyReference, CastsByTheModels)
{
  const auto head = MakeHead({ 20, 20, 20 });
  const ReferenceVolume volume(head.Values.data(), head.Size, 0);
  HartleyShading shading;
  shading.OpacityModel = HartleyOpacityModel::Exponential;
  shading.Extinction = 0.002;
  shading.Table = { { 0, 0, 0, 0 }, { 1, 0.5f, 0.25f, 0.5f } };
  const Vector point{ 0, 3, -5 };
  const Vector step{ 0.48, 0.36, 0.8 };
  const auto cast = volume.Cast(point, step, shading);
  EXPECT_NEAR(cast[3], 1 - std::exp(-0.002 * volume.SumSamples(point, step)), 1e-12);
  EXPECT_NEAR(cast[0], 2 * cast[1], 1e-12);

  const auto constant = MakeConstant({ 9, 9, 9 }, 100);
  const ReferenceVolume flat(constant.Values.data(), constant.Size, 0);
  shading.OpacityModel = HartleyOpacityModel::TransferFunction;
  shading.Last = 200;
  const auto through = flat.Cast({ 4, 4, -3.7 }, { 0, 0, 1 }, shading);
  EXPECT_NEAR(through[3], 1 - std::pow(0.75, 9), 1e-6);
  EXPECT_NEAR(through[0], 0.5 * through[3], 1e-6);
}

/** The middle of an image sees the middle of the volume; the axes turn as they should. */
TEST(HartleyReference, TurnsViews)
{
  const Triple size{ 10, 20, 30 };
  const HartleyView view = MakeTurnedView(size, { 0.5, 0, 1 }, 65, 2);
  // About x by 90 degrees, y goes to z and z to -y; about z by 180 degrees, x goes to -x.
  EXPECT_EQ(view.Step, (Vector{ 0, 1, 0 }));
  EXPECT_EQ(view.ColumnStep, (Vector{ -0.5, 0, 0 }));
  EXPECT_EQ(view.RowStep, (Vector{ 0, 0, 0.5 }));
  const HartleyView other = MakeTurnedView(size, { 0.48, 0.1, 0.95 }, 65, 2);
  const Vector middle = GetPixel(other, 32, 32);
  EXPECT_NEAR(middle[0], 4.5, 1e-12);
  EXPECT_NEAR(middle[2], 14.5, 1e-12);
  EXPECT_NEAR(InnerProduct(other.Step, other.Step), 1, 1e-12);
  EXPECT_NEAR(InnerProduct(other.Step, other.RowStep), 0, 1e-12);
}
}
