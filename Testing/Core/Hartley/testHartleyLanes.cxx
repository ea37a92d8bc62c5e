// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The loops over eight lines, for each instruction set, and what stands on them: Fourier
// transforms, the spectrum of a whole volume, sums of a box.

#include "gatunExactSource.h"
#include "gatunHartleyBox.h"
#include "gatunHartleyDensities.h"
#include "gatunHartleyFourier.h"
#include "gatunHartleyVolumeSpectrum.h"
#include "gatunParallel.h"
#include "gatunVolumePhantoms.h"
#include "gatunVolumeReference.h"

#include <gtest/gtest.h>

#include <bit>
#include <complex>
#include <cstring>
#include <numbers>
#include <random>

namespace gatun::test
{
namespace
{
using Triple = HartleyLayout::Triple;

/** All that this processor can run. */
std::vector<const HartleyLaneLoops*> GetAllLoops()
{
  std::vector<const HartleyLaneLoops*> all{ &GetPortableHartleyLanes() };
  if (&GetBestHartleyLanes() != all.front())
  {
    all.push_back(&GetBestHartleyLanes());
  }
  return all;
}

class Random
{
public:
  float operator()() { return this->Number(this->Engine); }

private:
  std::mt19937 Engine{ 5 };
  std::uniform_real_distribution<float> Number{ -1, 1 };
};

std::vector<ComplexLanes> MakeLines(std::size_t size)
{
  Random random;
  std::vector<ComplexLanes> lines(size);
  for (ComplexLanes& numbers : lines)
  {
    std::generate(std::begin(numbers.Re), std::end(numbers.Re), [&] { return random(); });
    std::generate(std::begin(numbers.Im), std::end(numbers.Im), [&] { return random(); });
  }
  return lines;
}

std::complex<double> Get(const ComplexLanes& numbers, std::size_t lane)
{
  return { static_cast<double>(numbers.Re[lane]), static_cast<double>(numbers.Im[lane]) };
}

/** The value of a half, by its definition. */
double DecodeHalf(unsigned half)
{
  const int exponent = static_cast<int>(half >> 10 & 31);
  const double mantissa = half & 1023;
  const double value =
    exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
  return half >> 15 != 0 ? -value : value;
}
}

//------------------------------------------------------------------------------
TEST(HartleyLanes, TransformsAreThoseOfTheDefinition)
{
  for (const HartleyLaneLoops* const loops : GetAllLoops())
  {
    for (const std::size_t size : { 1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 11u, 12u, 15u, 16u, 25u,
           30u, 49u, 60u, 61u, 64u, 122u, 240u, 243u, 250u, 512u, 648u })
    {
      const auto lines = MakeLines(size);
      const LaneFourier fourier(size, *loops);
      EXPECT_EQ(fourier.GetSize(), size);
      for (const bool inverse : { false, true })
      {
        auto values = lines;
        std::vector<ComplexLanes> room(size);
        const ComplexLanes* const found = inverse ? fourier.Inverse(values.data(), room.data())
                                                  : fourier.Forward(values.data(), room.data());
        double worst = 0;
        for (std::size_t lane = 0; lane < ComplexLanes::Count; ++lane)
        {
          for (std::size_t u = 0; u < size; ++u)
          {
            std::complex<double> sum = 0;
            for (std::size_t x = 0; x < size; ++x)
            {
              const double angle = 2 * std::numbers::pi * static_cast<double>(u * x % size) /
                static_cast<double>(size);
              sum += Get(lines[x], lane) * std::polar(1.0, inverse ? angle : -angle);
            }
            worst = std::max(worst, std::abs(sum - Get(found[u], lane)));
          }
        }
        // Numbers are about 1, so sums are about the root of the size; single precision.
        EXPECT_LT(worst, 3e-6 * std::sqrt(static_cast<double>(size))) << size << ' ' << inverse;
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyLanes, RealLinesAreJoinedAndSeparated)
{
  for (const HartleyLaneLoops* const loops : GetAllLoops())
  {
    for (const std::size_t size : { 12u, 15u })
    {
      // Two real lines as one complex line.
      const auto lines = MakeLines(size);
      const LaneFourier fourier(size, *loops);
      std::vector<ComplexLanes> values = lines, room(size), first(size), second(size);
      const ComplexLanes* const found = fourier.Forward(values.data(), room.data());
      const std::array<float, 2> factor{ 0.6f, -0.8f };
      for (std::size_t u = 0; u < size; ++u)
      {
        loops->Separate(found[u], found[(size - u) % size], factor.data(), first[u], second[u]);
        std::complex<double> one = 0, two = 0;
        for (std::size_t x = 0; x < size; ++x)
        {
          const auto turn = std::polar(1.0,
            -2 * std::numbers::pi * static_cast<double>(u * x % size) / static_cast<double>(size));
          one += Get(lines[x], 3).real() * turn;
          two += Get(lines[x], 3).imag() * turn;
        }
        const std::complex<double> turned(0.6, -0.8);
        EXPECT_LT(std::abs(one * turned - Get(first[u], 3)), 1e-5);
        EXPECT_LT(std::abs(two * turned - Get(second[u], 3)), 1e-5);
      }
      // And back, without the highest frequency of even sizes.
      const std::array<float, 2> back{ 0.6f, 0.8f };
      for (std::size_t u = 0; u < size; ++u)
      {
        loops->Turn(&first[u], back.data(), 1);
        loops->Turn(&second[u], back.data(), 1);
      }
      std::vector<ComplexLanes> joined(size, lines[0]);
      loops->Join(first.data(), second.data(), (size + 1) / 2, size, joined.data());
      if (size % 2 == 0)
      {
        std::copy_n(first[size / 2].Re, ComplexLanes::Count, joined[size / 2].Re);
        std::copy_n(second[size / 2].Re, ComplexLanes::Count, joined[size / 2].Im);
      }
      const ComplexLanes* const again = fourier.Inverse(joined.data(), room.data());
      for (std::size_t x = 0; x < size; ++x)
      {
        EXPECT_LT(std::abs(Get(again[x], 6) / static_cast<double>(size) - Get(lines[x], 6)), 1e-6);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyLanes, HalvesAreRoundedToTheNearest)
{
  for (const HartleyLaneLoops* const loops : GetAllLoops())
  {
    // All finite halves are exact, and what is between two goes to the nearest, ties to the even.
    for (unsigned sign : { 0u, 0x8000u })
    {
      for (unsigned half = 0; half < 0x7bff; ++half)
      {
        const double here = DecodeHalf(half | sign);
        const double next = DecodeHalf((half + 1) | sign);
        const std::array<double, 8> exact{ here, here + 0.25 * (next - here),
          here + 0.5 * (next - here), here + 0.75 * (next - here), next, here, next, here };
        std::array<float, 8> values{}, back{};
        for (std::size_t i = 0; i < 8; ++i)
        {
          values[i] = static_cast<float>(exact[i] / 4);
        }
        std::array<std::uint16_t, 8> stored{};
        loops->ToHalf(values.data(), 8, 4, stored.data());
        const unsigned even = half % 2 == 0 ? half : half + 1;
        const std::array<unsigned, 5> expected{ half, half, even, half + 1, half + 1 };
        for (std::size_t i = 0; i < 5; ++i)
        {
          ASSERT_EQ(stored[i], expected[i] | sign) << half << ' ' << i;
        }
        loops->FromHalf(stored.data(), 8, back.data());
        ASSERT_EQ(static_cast<double>(back[0]), here);
        ASSERT_EQ(static_cast<double>(back[4]), next);
      }
    }
    // Rows of complex numbers.
    const auto lines = MakeLines(8);
    std::vector<std::uint16_t> rows(8 * 20, 7);
    loops->StoreRows(lines.data(), 2, 8, 5, rows.data(), 20);
    for (std::size_t lane = 0; lane < 8; ++lane)
    {
      for (std::size_t i = 0; i < 5; ++i)
      {
        const auto value = 2.0 * Get(lines[i], lane);
        EXPECT_NEAR(DecodeHalf(rows[lane * 20 + 2 * i]), value.real(), 1e-3);
        EXPECT_NEAR(DecodeHalf(rows[lane * 20 + 2 * i + 1]), value.imag(), 1e-3);
      }
      EXPECT_EQ(rows[lane * 20 + 10], 7);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyLanes, InterpolationIsTheWeightedSum)
{
  Random random;
  for (const HartleyLaneLoops* const loops : GetAllLoops())
  {
    std::vector<float> weights(16 * 4), numbers(400);
    for (std::size_t i = 0; i < weights.size(); i += 2)
    {
      weights[i] = weights[i + 1] = random();
    }
    std::generate(numbers.begin(), numbers.end(), [&] { return random(); });
    std::vector<std::uint16_t> halves(numbers.size());
    loops->ToHalf(numbers.data(), numbers.size(), 1, halves.data());
    for (const std::ptrdiff_t stride : { 1, 9, 23 })
    {
      const HartleySample sample{ 3, 5, 1.25f, 2, -3 };
      std::array<float, 16> to{};
      to[5] = 4; // Sample adds.
      loops->Sample(&sample, 1, halves.data(), weights.data(), stride, to.data());
      std::complex<double> expected = 0;
      for (std::size_t tap = 0; tap < 8; ++tap)
      {
        const double weight = 0.75 * static_cast<double>(weights[16 + 2 * tap]) +
          0.25 * static_cast<double>(weights[32 + 2 * tap]);
        const std::size_t at = 6 + 2 * tap * static_cast<std::size_t>(stride);
        expected += weight * std::complex(DecodeHalf(halves[at]), DecodeHalf(halves[at + 1]));
      }
      EXPECT_NEAR(to[5], 4 + 2 * expected.real(), 1e-5);
      EXPECT_NEAR(to[13], -3 * expected.imag(), 1e-5);
    }

    // Four by four points of a lattice.
    const std::array<float, 12> kernel{ 0, 1, 0, 0, -0.2f, 0.7f, 0.6f, -0.1f, 0, 0, 1, 0 };
    const HartleyResampling resampling{ numbers.data(), 20, kernel.data(), 2 };
    std::array<float, 3> pixels{};
    loops->Resample(resampling, 4.0, 5.25, 0.25, 1, 3, pixels.data());
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto getWeight = [&](double part, std::size_t tap)
      {
        const auto step = static_cast<std::size_t>(2 * part);
        const double rest = 2 * part - static_cast<double>(step);
        return (1 - rest) * static_cast<double>(kernel[4 * step + tap]) +
          rest * static_cast<double>(kernel[4 * step + 4 + tap]);
      };
      double expected = 0;
      for (std::size_t row = 0; row < 4; ++row)
      {
        for (std::size_t column = 0; column < 4; ++column)
        {
          expected += getWeight(0.25 * static_cast<double>(i), column) * getWeight(0.25, row) *
            static_cast<double>(numbers[(4 + i + row) * 20 + 3 + column]);
        }
      }
      EXPECT_NEAR(pixels[i], expected, 1e-5);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyLanes, SumsOfABoxAreExact)
{
  for (const Triple& size : { Triple{ 20, 17, 9 }, Triple{ 1, 1, 1 }, Triple{ 1, 30, 2 } })
  {
    const std::vector<std::uint8_t> ones(std::size_t{ size[0] } * size[1] * size[2], 1);
    const ReferenceVolume reference(ones.data(), size, 0);
    for (const Vector& turns : { Vector{ 0, 0, 0 }, Vector{ 0.5, 0, 1 }, Vector{ 0.25, 0.25, 0.25 },
           Vector{ 0.003, 0.002, 0 }, Vector{ 0.7, -0.2, 0.4 }, Vector{ 0.25, 0, 0 } })
    {
      HartleyView view = MakeTurnedView(size, turns, 61, 2.1);
      for (double& step : view.Step)
      {
        step *= 1.3;
      }
      std::vector<float> samples(std::size_t{ view.Width } * view.Height);
      MeasureHartleyBox(size, view, samples);
      double worst = 0;
      for (unsigned row = 0; row < view.Height; ++row)
      {
        for (unsigned column = 0; column < view.Width; ++column)
        {
          const double expected = reference.IntegrateWeight(GetPixel(view, column, row), view.Step);
          worst = std::max(
            worst, std::abs(expected - static_cast<double>(samples[row * view.Width + column])));
        }
      }
      EXPECT_LT(worst, 1e-4) << turns[0] << ' ' << turns[1] << ' ' << turns[2];
    }
  }
  // The other instruction sets agree.
  const HartleyBox box{ { 10, 9, 5 }, { 0.3f, -0.1f, 0 }, { 0.2f, 0.4f, 0.9f },
    { 5, -2.5f, 1 / 0.9f } };
  const std::array<float, 3> origin{ -12, 3, 0 };
  std::array<float, 77> one{}, two{};
  GetPortableHartleyLanes().Measure(box, origin.data(), one.size(), one.data());
  GetBestHartleyLanes().Measure(box, origin.data(), two.size(), two.data());
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_NEAR(one[i], two[i], 1e-4);
  }
  EXPECT_GT(*std::max_element(one.begin(), one.end()), 5);
}

//------------------------------------------------------------------------------
// By the definition: the sum over the voxels, at points all over what is stored.
TEST(HartleyVolumeSpectrum, IsTheTransformAboutTheMiddle)
{
  Random random;
  for (const Triple& size : { Triple{ 13, 10, 19 }, Triple{ 8, 17, 6 }, Triple{ 1, 4, 9 } })
  {
    std::vector<float> voxels(std::size_t{ size[0] } * size[1] * size[2]);
    std::generate(voxels.begin(), voxels.end(), [&] { return random(); });
    for (const double cut : { 0.5, 0.3 })
    {
      const auto plan = VolumeSpectrumPlan::Make(size, cut);
      const HartleyVolumeSpectrum spectrum(plan, voxels);
      double most = 0;
      double worst = 0;
      for (std::ptrdiff_t u = -3; u <= plan.Highest[0] + 4; u += 3)
      {
        for (std::ptrdiff_t v = -plan.Highest[1] - 3; v <= plan.Highest[1] + 4; v += 2)
        {
          for (std::ptrdiff_t w = -plan.Highest[2] - 3; w <= plan.Highest[2] + 4; w += 2)
          {
            std::complex<double> expected = 0;
            const auto getAngle = [&](std::ptrdiff_t k, std::size_t axis, std::uint32_t x)
            {
              return -2 * std::numbers::pi * static_cast<double>(k) * (x - (size[axis] - 1.0) / 2) /
                static_cast<double>(plan.Points[axis]);
            };
            std::size_t i = 0;
            for (std::uint32_t z = 0; z < size[2]; ++z)
            {
              for (std::uint32_t y = 0; y < size[1]; ++y)
              {
                for (std::uint32_t x = 0; x < size[0]; ++x, ++i)
                {
                  expected += static_cast<double>(voxels[i]) *
                    std::polar(1.0, getAngle(u, 0, x) + getAngle(v, 1, y) + getAngle(w, 2, z));
                }
              }
            }
            const std::uint16_t* const point =
              spectrum.GetValues() + 2 * spectrum.GetPoint({ u, v, w });
            const std::complex<double> found(DecodeHalf(point[0]), DecodeHalf(point[1]));
            most = std::max(most, std::abs(expected));
            worst = std::max(worst, std::abs(expected - found * spectrum.GetScale()));
          }
        }
      }
      // Rounded twice to 11 bits.
      EXPECT_LT(worst, 1.5e-3 * most);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyDensities, AreTheVoxels)
{
  for (const Triple& size : { Triple{ 37, 33, 35 }, Triple{ 8, 50, 21 }, Triple{ 1, 7, 5 } })
  {
    const auto volume = MakeHead(size);
    for (const std::uint32_t block : { 4u, 8u, 13u, 64u, 0u })
    {
      const auto source = MakeSource(volume.Values, size, block);
      LargeArray<float> found, single;
      WithNumberOfThreads(2, [&] { found = DecodeHartleyDensities(*source); });
      WithNumberOfThreads(1, [&] { single = DecodeHartleyDensities(*source); });
      EXPECT_EQ(found, single);
      ASSERT_EQ(found.size(), volume.Values.size());
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        ASSERT_NEAR(static_cast<double>(found[i]) + source->GetBase(), volume.Values[i], 1e-2);
      }
    }
  }
}

//------------------------------------------------------------------------------
// A volume without fine detail needs few frequencies; the border does not count.
TEST(HartleyDensities, SmoothVolumesNeedFewFrequencies)
{
  const Triple size{ 64, 60, 50 };
  const double error = 0.02 / (255.0 * 255.0);
  auto smooth = MakeSmooth(size).Values;
  for (float& value : smooth)
  {
    value += 500;
  }
  const auto detail = HartleyDetail::Take(size, smooth, error);
  EXPECT_LT(detail.Cut, 0.3);
  EXPECT_NEAR(detail.Border, 500, 20);
  const auto head = MakeHead(size);
  std::vector<float> sharp(head.Values.begin(), head.Values.end());
  const auto sharpDetail = HartleyDetail::Take(size, sharp, error);
  EXPECT_EQ(sharpDetail.Cut, 0.5);
  // Largest is that of the volume with its border.
  double most = 0;
  for (std::size_t i = 0; i < std::size_t{ size[0] } * size[1]; ++i)
  {
    double sum = 0;
    for (std::size_t z = 0; z < size[2]; ++z)
    {
      sum += head.Values[i + z * size[0] * size[1]];
    }
    most = std::max(most, sum);
  }
  EXPECT_NEAR(sharpDetail.Largest[2] / most, 1, 1e-3);
}
}
