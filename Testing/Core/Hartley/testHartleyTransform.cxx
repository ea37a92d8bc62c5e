// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunError.h"
#include "gatunHartleyLayout.h"
#include "gatunHartleyTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace gatun
{
namespace
{
using Triple = HartleyLayout::Triple;
using Number = long double;

std::size_t GetCount(const Triple& size)
{
  return std::size_t{ size[0] } * size[1] * size[2];
}

std::string ToText(const Triple& size)
{
  return std::to_string(size[0]) + " " + std::to_string(size[1]) + " " + std::to_string(size[2]);
}

std::vector<double> MakeNoise(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-1, 1);
  std::vector<double> values(count);
  for (auto& value : values)
  {
    value = between(random);
  }
  return values;
}

Number GetFrequency(std::uint32_t u, std::uint32_t n)
{
  return 2 * u <= n ? Number(u) : Number(u) - Number(n);
}

/** The definition, at any real frequency, in periods of the block. */
Number SumHartley(
  const std::vector<double>& values, const Triple& n, const std::array<Number, 3>& k)
{
  Number sum = 0;
  std::size_t i = 0;
  for (std::uint32_t z = 0; z < n[2]; ++z)
  {
    for (std::uint32_t y = 0; y < n[1]; ++y)
    {
      for (std::uint32_t x = 0; x < n[0]; ++x, ++i)
      {
        const Number angle = 2 * std::numbers::pi_v<Number> *
          (k[0] * (x - Number(n[0] - 1) / 2) / n[0] + k[1] * (y - Number(n[1] - 1) / 2) / n[1] +
            k[2] * (z - Number(n[2] - 1) / 2) / n[2]);
        sum += values[i] * (std::cos(angle) + std::sin(angle));
      }
    }
  }
  return sum / std::sqrt(Number(GetCount(n)));
}

void CheckDefinition(const Triple& size)
{
  const auto values = MakeNoise(GetCount(size), size[0] + 10 * size[1] + 100 * size[2]);
  auto transformed = values;
  HartleyTransform transform(size);
  transform.Forward(transformed);
  std::size_t i = 0;
  for (std::uint32_t w = 0; w < size[2]; ++w)
  {
    for (std::uint32_t v = 0; v < size[1]; ++v)
    {
      for (std::uint32_t u = 0; u < size[0]; ++u, ++i)
      {
        const auto expected = SumHartley(values, size,
          { GetFrequency(u, size[0]), GetFrequency(v, size[1]), GetFrequency(w, size[2]) });
        ASSERT_NEAR(
          transformed[i], static_cast<double>(expected), 1e-15 * (size[0] + size[1] + size[2]))
          << ToText(size) << " at " << u << " " << v << " " << w;
      }
    }
  }
}

Number GetSquares(const std::vector<double>& values)
{
  return std::inner_product(values.begin(), values.end(), values.begin(), Number(0));
}
}

//------------------------------------------------------------------------------
TEST(HartleyTransform, IsItsDefinition)
{
  for (std::uint32_t x = 2; x <= 9; ++x)
  {
    for (std::uint32_t y = 2; y <= 9; y += 1 + x % 2)
    {
      for (std::uint32_t z = 2; z <= 9; z += 2 + (x + y) % 2)
      {
        CheckDefinition({ x, y, z });
      }
    }
  }
}

TEST(HartleyTransform, IsItsDefinitionInFewerDimensions)
{
  for (const Triple& size : { Triple{ 1, 1, 1 }, { 5, 1, 1 }, { 1, 6, 1 }, { 1, 1, 7 }, { 1, 4, 6 },
         { 8, 1, 3 }, { 4, 9, 1 }, { 2, 2, 1 }, { 1, 2, 2 } })
  {
    CheckDefinition(size);
  }
}

TEST(HartleyTransform, IsItsDefinitionForLongLines)
{
  // Long enough for the fast transform; even, odd and prime.
  for (const Triple& size : { Triple{ 33, 2, 3 }, { 2, 40, 3 }, { 3, 2, 36 }, { 64, 3, 1 },
         { 1, 37, 34 }, { 45, 1, 2 }, { 100, 1, 1 }, { 1, 1, 81 } })
  {
    CheckDefinition(size);
  }
}

TEST(HartleyTransform, GoesBack)
{
  for (const Triple& size :
    { Triple{ 2, 2, 2 }, { 3, 3, 3 }, { 8, 8, 8 }, { 7, 12, 9 }, { 16, 16, 16 }, { 32, 32, 32 },
      { 64, 64, 64 }, { 63, 31, 17 }, { 1, 90, 50 }, { 120, 100, 96 } })
  {
    const auto values = MakeNoise(GetCount(size), 7);
    auto transformed = values;
    HartleyTransform transform(size);
    transform.Forward(transformed);
    // Parseval.
    EXPECT_NEAR(static_cast<double>(GetSquares(transformed) / GetSquares(values)), 1, 1e-14)
      << ToText(size);
    transform.Inverse(transformed);
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      largest = std::max(largest, std::abs(values[i] - transformed[i]));
    }
    EXPECT_LT(largest, 2e-14) << ToText(size);
  }
}

TEST(HartleyTransform, IsOrthonormal)
{
  for (const Triple& size : { Triple{ 4, 4, 4 }, { 2, 3, 4 }, { 6, 1, 4 }, { 34, 2, 1 } })
  {
    const auto count = GetCount(size);
    HartleyTransform transform(size);
    std::vector<std::vector<double>> basis;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::vector<double> one(count);
      one[i] = 1;
      transform.Inverse(one);
      basis.push_back(one);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t j = 0; j <= i; ++j)
      {
        const double product =
          std::inner_product(basis[i].begin(), basis[i].end(), basis[j].begin(), 0.0);
        ASSERT_NEAR(product, i == j, 2e-15 * static_cast<double>(count))
          << ToText(size) << ": " << i << " and " << j;
      }
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
using Vector = std::array<double, 3>;

/** exp(-1/2 of the sum of squares along three directions at right angles), in a block. */
struct Gaussian
{
  std::array<Vector, 3> Axes;
  Vector Widths{};
  Vector Center{}; ///< from that of the block

  static double Dot(const Vector& a, const Vector& b)
  {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }

  double Get(const Vector& x) const
  {
    const Vector d{ x[0] - this->Center[0], x[1] - this->Center[1], x[2] - this->Center[2] };
    double squares = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      squares += std::pow(Dot(d, this->Axes[i]) / this->Widths[i], 2);
    }
    return std::exp(-squares / 2);
  }

  /** The square of its width along a direction, of its shadow there. */
  double GetCovariance(const Vector& a, const Vector& b) const
  {
    double sum = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      sum += std::pow(this->Widths[i], 2) * Dot(a, this->Axes[i]) * Dot(b, this->Axes[i]);
    }
    return sum;
  }

  double GetIntegral() const
  {
    return std::pow(2 * std::numbers::pi, 1.5) * this->Widths[0] * this->Widths[1] *
      this->Widths[2];
  }

  /** Its Hartley transform about the block's center, at a frequency in periods a voxel. */
  double Transform(const Vector& k) const
  {
    const double pi = std::numbers::pi;
    const double angle = 2 * pi * Dot(k, this->Center);
    return this->GetIntegral() * std::exp(-2 * pi * pi * this->GetCovariance(k, k)) *
      (std::cos(angle) + std::sin(angle));
  }

  /** The integral along the direction at right angles to a and b, through a point of their plane.
   */
  double Project(const Vector& a, const Vector& b, double x, double y) const
  {
    const double aa = this->GetCovariance(a, a);
    const double ab = this->GetCovariance(a, b);
    const double bb = this->GetCovariance(b, b);
    const double determinant = aa * bb - ab * ab;
    const double u = x - Dot(a, this->Center);
    const double v = y - Dot(b, this->Center);
    return this->GetIntegral() / (2 * std::numbers::pi * std::sqrt(determinant)) *
      std::exp(-(bb * u * u - 2 * ab * u * v + aa * v * v) / (2 * determinant));
  }
};

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/** Three directions at right angles. */
std::array<Vector, 3> MakeAxes(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const auto scale = [](const Vector& v)
  {
    const double length = std::sqrt(Gaussian::Dot(v, v));
    return Vector{ v[0] / length, v[1] / length, v[2] / length };
  };
  const auto first = scale({ normal(random), normal(random), normal(random) });
  const auto second = scale(Cross(first, { normal(random), normal(random), normal(random) }));
  return { first, second, Cross(first, second) };
}
}

// The transform of the shadow of a block along a direction is a slice through the block's
// transform.
TEST(HartleyTransform, HasTheProjectionSliceTheorem)
{
  constexpr std::uint32_t voxels = 34;
  constexpr std::uint32_t pixels = 32;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> width(1.9, 2.3);
  std::uniform_real_distribution<double> shift(-1.5, 1.5);
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    const Gaussian gaussian{ MakeAxes(random), { width(random), width(random), width(random) },
      { shift(random), shift(random), shift(random) } };
    const Triple size{ voxels, voxels, voxels };
    std::vector<double> values;
    std::vector<Vector> places;
    for (std::uint32_t i = 0; i < GetCount(size); ++i)
    {
      constexpr double center = (voxels - 1) / 2.0;
      places.push_back(
        { i % voxels - center, i / voxels % voxels - center, i / (voxels * voxels) - center });
      values.push_back(gaussian.Get(places.back()));
    }
    // Coefficients of the block, against the transform of the Gaussian.
    auto coefficients = values;
    HartleyTransform(size).Forward(coefficients);
    const double root = std::sqrt(static_cast<double>(values.size()));
    for (const Triple& u : { Triple{ 0, 0, 0 }, { 1, 0, 0 }, { 33, 2, 0 }, { 3, 32, 1 } })
    {
      Vector k{};
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        k[axis] = static_cast<double>(GetFrequency(u[axis], voxels)) / voxels;
      }
      EXPECT_NEAR(root * coefficients[u[0] + voxels * (u[1] + voxels * u[2])],
        gaussian.Transform(k), 1e-7 * gaussian.GetIntegral());
    }

    // A slice at any angle: the sum over the voxels at frequencies between those of the block.
    const auto view = MakeAxes(random);
    std::vector<double> slice;
    for (std::uint32_t v = 0; v < pixels; ++v)
    {
      for (std::uint32_t u = 0; u < pixels; ++u)
      {
        const double x = static_cast<double>(GetFrequency(u, pixels)) / pixels;
        const double y = static_cast<double>(GetFrequency(v, pixels)) / pixels;
        Vector k{};
        for (unsigned axis = 0; axis < 3; ++axis)
        {
          k[axis] = x * view[0][axis] + y * view[1][axis];
        }
        double sum = 0;
        // Nothing is left of the Gaussian beyond half a period a voxel but what samples repeat.
        if (x * x + y * y <= 0.25)
        {
          for (std::size_t i = 0; i < values.size(); ++i)
          {
            if (values[i] > 1e-10)
            {
              const double angle = 2 * std::numbers::pi * Gaussian::Dot(k, places[i]);
              sum += values[i] * (std::cos(angle) + std::sin(angle));
            }
          }
          ASSERT_NEAR(sum, gaussian.Transform(k), 1e-7 * gaussian.GetIntegral())
            << attempt << ": " << x << " " << y;
        }
        slice.push_back(sum / pixels);
      }
    }
    // Back in two dimensions, it is the shadow.
    HartleyTransform({ pixels, pixels, 1 }).Inverse(slice);
    double largest = 0;
    double difference = 0;
    for (std::uint32_t i = 0; i < slice.size(); ++i)
    {
      constexpr double center = (pixels - 1) / 2.0;
      const double expected =
        gaussian.Project(view[0], view[1], i % pixels - center, i / pixels - center);
      largest = std::max(largest, expected);
      difference = std::max(difference, std::abs(slice[i] - expected));
    }
    EXPECT_LT(difference, 1e-6 * largest) << attempt;
  }
}
}
