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

//--------------------------------------------------------------------------------------------------
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
}
