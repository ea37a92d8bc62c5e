// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Steps of quantizers, checked with whole numbers.

#include "gatunExactBound.h"
#include "gatunQuantizer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

using Limits = std::numeric_limits<double>;

/** The sign of step - bound * (high - low). */
int CompareStep(double step, double bound, double low, double high)
{
  ExactSum sum;
  sum.Add(Dyadic::Of(step));
  sum.Add(Dyadic::Of(bound), Dyadic::Of(high), true);
  sum.Add(Dyadic::Of(bound), Dyadic::Of(low));
  return sum.GetSign();
}

TEST(ExactBound, SumsAreThoseOfWholeNumbers)
{
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i)
  {
    // Products of up to 46 bits, moved to any place, and numbers that leave 0 or next to nothing.
    const int exponent = static_cast<int>(random() % 1500) - 1030;
    const auto a = static_cast<std::int64_t>(random() % (1u << 23)) - (1 << 22);
    const auto b = static_cast<std::int64_t>(random() % (1u << 23)) - (1 << 22);
    const auto change = static_cast<std::int64_t>(random() % 3) - 1;
    ExactSum sum;
    sum.Add(Dyadic::Of(std::ldexp(static_cast<double>(a), exponent)), Dyadic::Of(b));
    sum.Add(Dyadic::Of(a * b + change), Dyadic::Of(std::ldexp(1.0, exponent)), true);
    EXPECT_EQ(sum.GetSign(), -change) << a << " " << b << " " << exponent;
  }
  ExactSum sum;
  sum.Add(Dyadic::Of(Limits::max()), Dyadic::Of(Limits::max()));
  sum.Add(Dyadic::Of(Limits::denorm_min()), Dyadic::Of(Limits::denorm_min()), true);
  sum.Add(Dyadic::Of(Limits::max()), Dyadic::Of(-Limits::max()));
  EXPECT_EQ(sum.GetSign(), -1);
}

TEST(ExactBound, HoldsToTheLastBit)
{
  const std::vector<double> values{ -1, 3 };
  const ExactBound<double> relative({ ErrorKind::Relative, 0.25 }, values.data(), values.size());
  const auto after = [](double number) { return std::nextafter(number, 100); };
  EXPECT_TRUE(relative.IsWithin(2, 3));
  EXPECT_FALSE(relative.IsWithin(2, after(3)));
  EXPECT_FALSE(relative.IsWithin(3, std::nextafter(2.0, 0)));
  const double tiny = Limits::denorm_min();
  const ExactBound<double> absolute({ ErrorKind::Absolute, tiny }, values.data(), values.size());
  EXPECT_TRUE(absolute.IsWithin(5 * tiny, 4 * tiny));
  EXPECT_FALSE(absolute.IsWithin(5 * tiny, 3 * tiny));
  const ExactBound<double> bits({ ErrorKind::Bits, 3 }, values.data(), values.size());
  EXPECT_TRUE(bits.IsWithin(7, 7.5));
  EXPECT_FALSE(bits.IsWithin(7, after(7.5)));
  EXPECT_FALSE(bits.IsWithin(0, tiny));
  const ExactBound<double> pointwise({ ErrorKind::Pointwise, 0.5 }, values.data(), values.size());
  EXPECT_TRUE(pointwise.IsWithin(-4 * tiny, -2 * tiny));
  EXPECT_FALSE(pointwise.IsWithin(-4 * tiny, -tiny));
  const std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const std::vector<std::int64_t> wide{ most - 10, most };
  const ExactBound<std::int64_t> whole({ ErrorKind::Relative, 0.5 }, wide.data(), wide.size());
  EXPECT_TRUE(whole.IsWithin(most - 5, most));
  EXPECT_FALSE(whole.IsWithin(most - 6, most));
}

TEST(ExactBound, KeepsWhatIsNoNumber)
{
  const std::vector<float> values{ 0, 1 };
  const ExactBound<float> bound({ ErrorKind::Absolute, 10, true }, values.data(), values.size());
  const auto nan = std::bit_cast<float>(0x7fc12345u), other = std::bit_cast<float>(0x7fc12346u);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(bound.IsWithin(nan, nan));
  EXPECT_FALSE(bound.IsWithin(nan, other));
  EXPECT_FALSE(bound.IsWithin(infinity, 1));
  EXPECT_FALSE(bound.IsWithin(1, nan));
  EXPECT_FALSE(bound.IsWithin(-0.0f, 0.0f)); // zeros are kept
  EXPECT_TRUE(bound.IsWithin(1, 0));
}

TEST(Quantizer, RelativeStepsAreNotMoreThanTheProduct)
{
  std::mt19937_64 random(7);
  const auto anyNumber = [&](int least, int most)
  {
    const auto exponent = least + static_cast<int>(random() % static_cast<unsigned>(most - least));
    const double number =
      std::ldexp(1 + static_cast<double>(random() % 1000003) / 1000003, exponent);
    return random() % 2 ? number : -number;
  };
  std::size_t steps = 0;
  for (int i = 0; i < 100000; ++i)
  {
    // Subnormal ranges, narrow ones around a large number, and any.
    const int least = i % 3 == 0 ? -1074 : i % 3 == 1 ? 0 : -1074;
    const int most = i % 3 == 0 ? -1000 : i % 3 == 1 ? 1 : 1023;
    FiniteRange range;
    const double one = anyNumber(least, most);
    range.Include(one);
    range.Include(i % 3 == 1 ? one + static_cast<double>(random() % 100) * Limits::epsilon()
                             : anyNumber(least, most));
    const double bound = std::min(1.0, std::abs(anyNumber(-40, 1)));
    const auto quantizer =
      MakeQuantizer(ScalarType::Float64, { ErrorKind::Relative, bound }, range);
    if (!quantizer || quantizer.Step >= Limits::max() / 4)
    {
      continue;
    }
    ++steps;
    const double step = quantizer.Step;
    ASSERT_LE(CompareStep(step, bound, range.Low, range.High), 0)
      << step << " " << bound << " " << range.Low << " " << range.High;
    const double more = step * (1 + 4 * Limits::epsilon()) + 2 * Limits::denorm_min();
    ASSERT_GT(CompareStep(more, bound, range.Low, range.High), 0)
      << step << " " << bound << " " << range.Low << " " << range.High;
  }
  EXPECT_GT(steps, 50000u);
}

TEST(Quantizer, RelativeStepsOfWholeNumbersAreExact)
{
  FiniteRange range;
  range.Include(0);
  range.Include(100);
  const auto quantizer = MakeQuantizer(ScalarType::Int32, { ErrorKind::Relative, 0.25 }, range);
  EXPECT_EQ(quantizer.GetAllowed(ScalarType::Int32), 25);
}
}
