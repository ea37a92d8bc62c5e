// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The loops that composite blocks and slabs, of each instruction set, next to the equations in
// double precision.

#include "gatunHartleyKernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace gatun::test
{
namespace
{
std::vector<const HartleyKernelLoops*> GetKernels()
{
  std::vector<const HartleyKernelLoops*> kernels{ &GetPortableHartleyKernel() };
  if (&GetBestHartleyKernel() != kernels.front())
  {
    kernels.push_back(&GetBestHartleyKernel());
  }
  return kernels;
}

class Numbers
{
public:
  float Get(float low, float high)
  {
    return std::uniform_real_distribution<float>(low, high)(this->Random);
  }
  std::vector<float> List(std::size_t count, float low, float high)
  {
    std::vector<float> numbers(count);
    std::generate(numbers.begin(), numbers.end(), [&] { return this->Get(low, high); });
    return numbers;
  }

private:
  std::mt19937 Random{ 11 };
};

constexpr auto XRay = HartleyOpacityModel::XRay;
constexpr auto Exponential = HartleyOpacityModel::Exponential;
constexpr auto Transfer = HartleyOpacityModel::TransferFunction;

/** An opacity model with a table of noise. */
struct Opacity
{
  Opacity(HartleyOpacityModel model, std::size_t planes, Numbers& numbers)
    : Table(numbers.List(planes * HartleyOpacity::TableSize, 0, 1))
    , Kernel{ model, planes, 10, 5, 90, 8, 45, 0.02f, -3, this->Table.data() }
  {
  }

  std::vector<float> Table;
  HartleyOpacity Kernel;
};

/** Equations 6 to 10 for one point. */
void AddPoint(
  const HartleyOpacity& opacities, double first, double samples, std::vector<double>& channels)
{
  double& last = channels.back();
  if (opacities.Model == XRay)
  {
    channels[0] += samples > 0 ? first : 0;
    last += std::max(0.0, samples);
    return;
  }
  if (samples < 0.005)
  {
    return;
  }
  const double mean =
    std::clamp<double>(first / samples + opacities.Base, opacities.Least, opacities.Most);
  const auto entry = static_cast<std::size_t>(std::clamp<double>(
    (mean - opacities.First) * opacities.PerDensity + 0.5, 0, HartleyOpacity::TableSize - 1));
  const double depth = opacities.Model == Exponential
    ? opacities.Extinction * std::max(0.0, first + samples * opacities.Zero)
    : samples * opacities.Table[(opacities.Planes - 1) * HartleyOpacity::TableSize + entry];
  const double through = opacities.Model == Exponential ? std::exp(-last) : 1 - last;
  const double opacity = -std::expm1(-depth);
  for (std::size_t color = 0; color + 1 < opacities.Planes; ++color)
  {
    channels[color] +=
      through * opacity * opacities.Table[color * HartleyOpacity::TableSize + entry];
  }
  last += opacities.Model == Exponential ? depth : through * opacity;
}

double GetCubic(double distance)
{
  const double d = std::abs(distance);
  return d < 1 ? 1 + d * d * (1.5 * d - 2.5) : d < 2 ? 2 + d * (-4 + d * (2.5 - 0.5 * d)) : 0;
}

/** A number of a plane between its points. */
double Interpolate(const HartleyPlanes& slab, std::size_t plane, double x, double y)
{
  double sum = 0;
  for (double row = std::floor(y) - 1; row <= std::floor(y) + 2; ++row)
  {
    for (double column = std::floor(x) - 1; column <= std::floor(x) + 2; ++column)
    {
      const auto at =
        static_cast<std::size_t>(row) * slab.Stride + static_cast<std::size_t>(column);
      sum += GetCubic(column - x) * GetCubic(row - y) * slab.Values[plane * slab.Plane + at];
    }
  }
  return sum;
}

void AddPixel(
  const HartleyOpacity& opacities, const std::vector<double>& channels, std::vector<double>& pixel)
{
  const double opaque = std::max(0.0, channels.back());
  const double opacity =
    opacities.Model == Exponential ? -std::expm1(-opaque) : std::min(1.0, opaque);
  for (std::size_t i = 0; i < pixel.size(); ++i)
  {
    if (opacities.Model == XRay)
    {
      pixel[i] += channels[i];
    }
    else if (i + 1 < pixel.size())
    {
      pixel[i] += pixel.back() * std::clamp(channels[i], 0.0, opacity);
    }
    else
    {
      pixel[i] *= 1 - opacity;
    }
  }
}

std::vector<Opacity> MakeOpacities(Numbers& numbers)
{
  std::vector<Opacity> models;
  models.reserve(5);
  for (const auto model : { XRay, Exponential, Transfer })
  {
    models.emplace_back(model, 2, numbers);
    if (model != XRay)
    {
      models.emplace_back(model, 4, numbers);
    }
  }
  return models;
}
}

//------------------------------------------------------------------------------
TEST(HartleyCompositing, BlocksByTheEquations)
{
  constexpr std::size_t width = 21;
  constexpr std::size_t stride = 24;
  Numbers numbers;
  for (Opacity& opacities : MakeOpacities(numbers))
  {
    opacities.Kernel.Table = opacities.Table.data();
    const auto before = numbers.List(opacities.Kernel.Planes * stride, 0, 0.9f);
    const auto image = numbers.List(stride, -20, 900);
    // Rays beside the block and such that only touch it.
    auto unit = numbers.List(stride, -1, 12);
    unit[3] = 0.004f;
    unit[4] = 0.006f;
    std::fill(unit.begin() + width, unit.end(), 0.0f);
    for (const float* const sums : { image.data(), static_cast<const float*>(nullptr) })
    {
      for (const HartleyKernelLoops* const kernel : GetKernels())
      {
        auto planes = before;
        kernel->AddBlock(opacities.Kernel, sums, unit.data(), width, planes.data(), stride);
        for (std::size_t i = 0; i < stride; ++i)
        {
          std::vector<double> expected;
          for (std::size_t plane = 0; plane < opacities.Kernel.Planes; ++plane)
          {
            expected.push_back(before[plane * stride + i]);
          }
          AddPoint(opacities.Kernel, sums ? sums[i] : 0, unit[i], expected);
          for (std::size_t plane = 0; plane < opacities.Kernel.Planes; ++plane)
          {
            EXPECT_NEAR(planes[plane * stride + i], expected[plane],
              1e-6 * std::max(1.0, std::abs(expected[plane])))
              << static_cast<int>(opacities.Kernel.Model) << " " << plane << " " << i;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// Opacities have no rounding errors of differences, however small they are.
TEST(HartleyCompositing, FaintBlocksAreNotLost)
{
  Numbers numbers;
  Opacity opacities(Exponential, 2, numbers);
  std::fill(opacities.Table.begin(), opacities.Table.end(), 1.0f);
  opacities.Kernel.Zero = 0;
  for (const HartleyKernelLoops* const kernel : GetKernels())
  {
    for (const float depth : { 1e-12f, 1e-6f, 1e-3f, 0.1f, 0.7f, 5.0f, 80.0f, 1e6f })
    {
      std::array<float, 8> image{}, unit{};
      image.fill(depth / opacities.Kernel.Extinction);
      unit.fill(1);
      std::array<float, 16> planes{};
      kernel->AddBlock(opacities.Kernel, image.data(), unit.data(), 8, planes.data(), 8);
      const double expected = -std::expm1(-static_cast<double>(depth));
      EXPECT_NEAR(planes[5], expected, 4e-7 * expected);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyCompositing, SlabsByTheEquations)
{
  constexpr std::size_t stride = 40;
  constexpr std::size_t rows = 30;
  constexpr std::size_t count = 13;
  constexpr std::size_t plane = 20; // of the pixels
  Numbers numbers;
  for (Opacity& opacities : MakeOpacities(numbers))
  {
    opacities.Kernel.Table = opacities.Table.data();
    const std::size_t planes = opacities.Kernel.Planes;
    const auto values = numbers.List(planes * stride * rows, -0.2f, 1.2f);
    const HartleyPlanes slab{ values.data(), stride, stride * rows, 37, 27 };
    const auto before = numbers.List(planes * plane, 0, 1);
    for (const HartleyRow& row : { HartleyRow{ 1, 27, 2.5, -1.7, count },
           HartleyRow{ 30.3, 2.2, -2.1, 1.9, count }, HartleyRow{ 5, 7, 1, 0, count } })
    {
      for (const HartleyKernelLoops* const kernel : GetKernels())
      {
        auto pixels = before;
        kernel->AddSlab(opacities.Kernel, slab, row, pixels.data(), plane);
        for (std::size_t i = 0; i < plane; ++i)
        {
          std::vector<double> expected, channels;
          for (std::size_t k = 0; k < planes; ++k)
          {
            expected.push_back(before[k * plane + i]);
            channels.push_back(i < count
                ? Interpolate(slab, k, row.X + static_cast<double>(i) * row.StepX,
                    row.Y + static_cast<double>(i) * row.StepY)
                : 0);
          }
          if (i < count)
          {
            AddPixel(opacities.Kernel, channels, expected);
          }
          for (std::size_t k = 0; k < planes; ++k)
          {
            EXPECT_NEAR(pixels[k * plane + i], expected[k], 2e-6)
              << static_cast<int>(opacities.Kernel.Model) << " " << k << " " << i;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyCompositing, StencilsAreWeightedSums)
{
  Numbers numbers;
  const auto values = numbers.List(400, -1, 1);
  std::vector<HartleyTap> taps;
  for (std::int32_t i = 0; i < 37; ++i)
  {
    taps.push_back({ 9 * i, numbers.Get(-1, 1), numbers.Get(-1, 1) });
  }
  for (const HartleyKernelLoops* const kernel : GetKernels())
  {
    for (std::size_t groups = 1; groups <= 4; ++groups)
    {
      std::vector<float> sums(64, 7);
      kernel->Project(values.data(), taps.data(), taps.size(), groups, sums.data());
      for (std::size_t k = 0; k < sums.size(); ++k)
      {
        double expected = k < 16 * groups ? 0 : 7;
        for (const HartleyTap& tap : taps)
        {
          const double value = values[static_cast<std::size_t>(tap.Place) + k / 2];
          expected += k < 16 * groups ? (k % 2 == 0 ? tap.Even : tap.Odd) * value : 0;
        }
        EXPECT_NEAR(sums[k], expected, 1e-5);
      }
    }
  }
}
}
