// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDomainSurvey.h"
#include "gatunScale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace gatun;

template <typename T>
constexpr ScalarType TypeOf = std::is_same_v<T, float> ? ScalarType::Float32
  : std::is_same_v<T, double>                          ? ScalarType::Float64
  : std::is_same_v<T, std::int32_t>                    ? ScalarType::Int32
                                                       : ScalarType::UInt64;

template <typename T>
Domain Find(const std::vector<T>& values)
{
  return FindDomain(TypeOf<T>, values.data(), values.size(), 1, 0, PaletteUse::Array);
}

/** The scale that is found for values, which must survive it. */
template <typename T>
Scale ExpectKept(const std::vector<T>& values)
{
  const auto domain = Find(values);
  Key last = 0;
  auto sorted = values;
  std::sort(
    sorted.begin(), std::partition(sorted.begin(), sorted.end(), [](T v) { return v == v; }));
  for (const auto& value : sorted)
  {
    T back{};
    const Key key = domain.Read(&value);
    EXPECT_TRUE(domain.IsValid(key));
    EXPECT_TRUE(last <= key || value != value); // NaN is anywhere
    domain.Write(key, &back);
    EXPECT_EQ(std::memcmp(&back, &value, sizeof(T)), 0) << +value << " " << +back;
    last = key;
  }
  return domain.GetScale();
}

/** Numbers as a text of so many significant digits has them. */
template <typename T>
std::vector<T> MakeDecimals(int digits, int low, int high, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  std::uniform_int_distribution<int> power(low, high);
  std::vector<T> values{ 0 };
  for (int i = 0; i < 3000; ++i)
  {
    std::string text(64, '\0');
    const double number = mantissa(random) * std::pow(10.0, power(random));
    text.resize(static_cast<std::size_t>(
      std::snprintf(text.data(), text.size(), "%.*e", digits - 1, number)));
    values.push_back(std::is_same_v<T, float> ? static_cast<T>(std::strtof(text.c_str(), nullptr))
                                              : static_cast<T>(std::strtod(text.c_str(), nullptr)));
  }
  return values;
}

template <typename T>
void ExpectDecimals(int mostDigits)
{
  for (int digits = 1; digits <= mostDigits; ++digits)
  {
    auto values = MakeDecimals<T>(digits, -5, 5, static_cast<unsigned>(digits));
    values.erase(
      std::remove_if(values.begin(), values.end(), [](T v) { return std::signbit(v) && v == 0; }),
      values.end());
    // Few digits are few values.
    const auto scale = ExpectKept(values);
    if (digits > 3)
    {
      EXPECT_EQ(scale.Kind, ScaleKind::Decimal) << digits;
      EXPECT_EQ(scale.Digits, digits);
      EXPECT_LE(scale.First, -5);
    }
  }
}

TEST(Scale, KeepsDecimalNumbers)
{
  ExpectDecimals<float>(6);
  ExpectDecimals<double>(15);
}

TEST(Scale, KeepsPowersOfTenThatAreRounded)
{
  std::vector<float> values;
  for (int i = -18; i <= 22; ++i)
  {
    for (int m = 1; m < 1000; m += 7)
    {
      values.push_back(std::strtof((std::to_string(m) + "e" + std::to_string(i)).c_str(), nullptr));
    }
  }
  const auto scale = ExpectKept(values);
  EXPECT_EQ(scale.Kind, ScaleKind::Decimal);
  EXPECT_EQ(scale.Digits, 3);
  EXPECT_EQ(scale.First, -18);
}

TEST(Scale, KeepsWholeNumbersAndFixedPlaces)
{
  std::vector<double> values;
  for (int i = -40000; i < 40000; ++i)
  {
    values.push_back(i * 7001.0);
  }
  EXPECT_EQ(ExpectKept(values), (Scale{ ScaleKind::Binary, 0, 0 }));
  for (auto& value : values)
  {
    value /= 1000;
  }
  EXPECT_EQ(ExpectKept(values), (Scale{ ScaleKind::Fixed, 3, 0 }));
}

TEST(Scale, KeepsBitsThatAreZero)
{
  std::mt19937_64 random(1);
  std::vector<double> floats;
  for (int i = 0; i < 5000; ++i)
  {
    floats.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
  }
  EXPECT_EQ(ExpectKept(std::vector<double>(floats.begin(), floats.end())),
    (Scale{ ScaleKind::Shift, 29, 0 }));
  std::vector<std::int32_t> eights;
  std::vector<std::uint64_t> large;
  for (int i = -2000; i < 2000; ++i)
  {
    eights.push_back(8 * i);
    large.push_back(random() << 50);
  }
  EXPECT_EQ(ExpectKept(eights), (Scale{ ScaleKind::Shift, 3, 0 }));
  EXPECT_EQ(ExpectKept(large), (Scale{ ScaleKind::Shift, 50, 0 }));
}

template <typename T>
std::vector<T> MakeMultiples(int first, std::int64_t most, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::int64_t> multiple(-most, most);
  std::vector<T> values{ 0, static_cast<T>(std::ldexp(1.0, first)) };
  for (int i = 0; i < 4000; ++i)
  {
    const auto m = multiple(random);
    values.push_back(m == 0 ? T{ 0 } : static_cast<T>(std::ldexp(static_cast<double>(m), first)));
  }
  return values;
}

TEST(Scale, KeepsMultiplesOfAPowerOfTwo)
{
  constexpr std::int64_t mostOfFloat = (1 << 24) - 1;
  constexpr std::int64_t mostOfDouble = (std::int64_t{ 1 } << 52) - 1;
  for (const int first : { -126, -100, -13, 0, 7, 103 })
  {
    const Scale scale{ ScaleKind::Binary, 0, static_cast<std::int8_t>(first) };
    EXPECT_EQ(ExpectKept(MakeMultiples<float>(first, 1 << 14, 1)), scale);
    EXPECT_EQ(ExpectKept(MakeMultiples<double>(first, 1 << 14, 2)), scale);
    EXPECT_EQ(ExpectKept(MakeMultiples<float>(first, mostOfFloat, 3)), scale);
    EXPECT_EQ(ExpectKept(MakeMultiples<double>(first, mostOfDouble, 4)), scale);
  }
  // One multiple too far away, or too low.
  auto values = MakeMultiples<float>(-13, 1 << 14, 5);
  values.push_back(2048); // 2^24 of them
  EXPECT_NE(ExpectKept(values).Kind, ScaleKind::Binary);
  values.back() = std::ldexp(1.0f, -23); // so that all would have ten bits more
  EXPECT_EQ(ExpectKept(values), (Scale{ ScaleKind::Shift, 10, 0 }));
  values.back() = -0.0f;
  EXPECT_NE(ExpectKept(values).Kind, ScaleKind::Binary);
}

TEST(Scale, IsNotFoundWhereOneValueIsElsewhere)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto decimals = MakeDecimals<double>(5, -3, 3, 9);
  ASSERT_EQ(Find(decimals).GetScale().Kind, ScaleKind::Decimal);
  for (const double other : { infinity, -infinity, infinity - infinity, -0.0, 1.0 / 3, 5e-324,
         1e-30, 1e60, 1.234567890123456789, 12345.000000000002 })
  {
    auto values = decimals;
    values[values.size() / 2] = other;
    EXPECT_NE(Find(values).GetScale(), Find(decimals).GetScale()) << other;
    const auto domain = Find(values);
    for (const double value : values)
    {
      double back = 0;
      domain.Write(domain.Read(&value), &back);
      EXPECT_EQ(std::bit_cast<Key>(back), std::bit_cast<Key>(value));
    }
  }
  std::mt19937 random(2);
  std::uniform_real_distribution<float> any(-1, 1);
  std::vector<float> noise(1000);
  std::generate(noise.begin(), noise.end(), [&] { return any(random) * 0.731f; });
  EXPECT_EQ(Find(noise).GetScale().Kind, ScaleKind::None);
}

TEST(Scale, OfPartsIsThatOfTheWhole)
{
  for (const auto& values : { MakeDecimals<double>(7, -4, 2, 3), MakeDecimals<double>(9, -1, 0, 4),
         MakeMultiples<double>(-13, 1 << 14, 5), MakeMultiples<double>(9, 1 << 20, 6) })
  {
    const auto whole = Find(values);
    DomainSurvey all(ScalarType::Float64);
    for (std::size_t begin = 0; begin < values.size(); begin += 700)
    {
      DomainSurvey part(ScalarType::Float64);
      part.Add(values.data() + begin, std::min<std::size_t>(700, values.size() - begin), 1, 0);
      ByteWriter message;
      part.Put(message);
      ByteReader in(message.Data);
      all.Add(in);
    }
    EXPECT_EQ(all.Finish(values.size(), PaletteUse::Array).GetScale(), whole.GetScale());
    EXPECT_TRUE(whole.GetScale());
  }
}

TEST(Scale, OfTheStepBeforeIsKeptIfItHasAllValues)
{
  const auto find = [](const std::vector<double>& values, const Scale& before)
  {
    return FindDomain(
      ScalarType::Float64, values.data(), values.size(), 1, 0, PaletteUse::Array, &before)
      .GetScale();
  };
  const auto five = MakeDecimals<double>(5, -3, 3, 5);
  const auto scale = Find(five).GetScale();
  EXPECT_EQ(find(MakeDecimals<double>(4, -2, 2, 6), scale), scale);
  EXPECT_EQ(find(five, Scale()), Scale());
  const auto six = MakeDecimals<double>(6, -3, 3, 7);
  EXPECT_EQ(find(six, scale), Find(six).GetScale());
  EXPECT_NE(find(six, scale), scale);
  const Scale binary{ ScaleKind::Binary, 0, -13 };
  EXPECT_EQ(find(MakeMultiples<double>(-11, 1 << 14, 8), binary), binary);
  EXPECT_EQ(
    find(MakeMultiples<double>(-14, 1 << 14, 8), binary), (Scale{ ScaleKind::Binary, 0, -14 }));
}

/** Numbers give the closest key, and keys survive. */
void ExpectNumbersToBeRounded(ScalarType type, const Scale& scale)
{
  ASSERT_TRUE(scale.IsValid(type));
  const Domain domain(type, scale);
  std::mt19937_64 random(3);
  Key end = domain.GetBits() == 64 ? ~Key{ 0 } : (Key{ 1 } << domain.GetBits()) - 1;
  while (!domain.IsValid(end))
  {
    end = end / 2 + 1;
  }
  for (int i = 0; i < 20000; ++i)
  {
    const Key key = random() % end;
    const double low = domain.ToNumber(key);
    const double high = domain.ToNumber(key + 1);
    if (!std::isfinite(low) || !std::isfinite(high))
    {
      continue;
    }
    ASSERT_LE(low, high);
    if (low < high && high - low > std::abs(low) * 1e-6)
    {
      EXPECT_EQ(domain.FromNumber(low), key) << low;
      EXPECT_EQ(domain.FromNumber(low + 0.4 * (high - low)), key) << low;
      EXPECT_EQ(domain.FromNumber(low + 0.6 * (high - low)), key + 1) << low;
    }
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double number : { infinity, infinity - infinity })
  {
    EXPECT_EQ(domain.FromNumber(number), domain.FromNumber(0));
  }
  for (const double number :
    { 1e308, -1e308, 1e-320, -1e-320, 0.0, -0.0, 1e36, 9.999999e35, 1e-22, 1e-23 })
  {
    EXPECT_TRUE(domain.IsValid(domain.FromNumber(number))) << number;
  }
}

TEST(Scale, RoundsNumbersToTheClosestKey)
{
  ExpectNumbersToBeRounded(ScalarType::Float32, { ScaleKind::Decimal, 3, -5 });
  ExpectNumbersToBeRounded(ScalarType::Float64, { ScaleKind::Decimal, 4, -19 });
  ExpectNumbersToBeRounded(ScalarType::Float64, { ScaleKind::Decimal, 1, 22 });
  ExpectNumbersToBeRounded(ScalarType::Float64, { ScaleKind::Decimal, 15, -8 });
  ExpectNumbersToBeRounded(ScalarType::Float64, { ScaleKind::Fixed, 2, 0 });
  ExpectNumbersToBeRounded(ScalarType::Float32, { ScaleKind::Fixed, 22, 0 });
  ExpectNumbersToBeRounded(ScalarType::Float32, { ScaleKind::Binary, 0, -13 });
  ExpectNumbersToBeRounded(ScalarType::Float64, { ScaleKind::Binary, 0, 3 });
  ExpectNumbersToBeRounded(ScalarType::Float32, { ScaleKind::Shift, 16, 0 });
  ExpectNumbersToBeRounded(ScalarType::Float64, { ScaleKind::Shift, 45, 0 });
  ExpectNumbersToBeRounded(ScalarType::Int32, { ScaleKind::Shift, 7, 0 });
  ExpectNumbersToBeRounded(ScalarType::UInt8, { ScaleKind::Shift, 7, 0 });
}

TEST(Scale, HasLimits)
{
  const auto isValid = [](ScalarType type, ScaleKind kind, int digits, int first)
  {
    return Scale{ kind, static_cast<std::uint8_t>(digits), static_cast<std::int8_t>(first) }
      .IsValid(type);
  };
  EXPECT_FALSE(isValid(ScalarType::UInt8, ScaleKind::Shift, 8, 0));
  EXPECT_FALSE(isValid(ScalarType::UInt8, ScaleKind::Shift, 0, 0));
  EXPECT_FALSE(isValid(ScalarType::Int32, ScaleKind::Decimal, 3, 0));
  EXPECT_FALSE(isValid(ScalarType::Int32, ScaleKind::Fixed, 3, 0));
  EXPECT_FALSE(isValid(ScalarType::Float32, ScaleKind::Decimal, 0, 0));
  EXPECT_FALSE(isValid(ScalarType::Float64, ScaleKind::Decimal, 16, 0));
  EXPECT_TRUE(isValid(ScalarType::Float64, ScaleKind::Decimal, 15, -8));
  EXPECT_FALSE(isValid(ScalarType::Float64, ScaleKind::Decimal, 15, -9));
  EXPECT_TRUE(isValid(ScalarType::Float64, ScaleKind::Decimal, 2, 23));
  EXPECT_FALSE(isValid(ScalarType::Float64, ScaleKind::Decimal, 2, 24));
  EXPECT_FALSE(isValid(ScalarType::Float64, ScaleKind::Fixed, 23, 0));
  EXPECT_TRUE(isValid(ScalarType::Float32, ScaleKind::Binary, 0, -126));
  EXPECT_TRUE(isValid(ScalarType::Float32, ScaleKind::Binary, 0, 103));
  EXPECT_FALSE(isValid(ScalarType::Float32, ScaleKind::Binary, 0, -127));
  EXPECT_FALSE(isValid(ScalarType::Float64, ScaleKind::Binary, 0, 104));
  EXPECT_FALSE(isValid(ScalarType::UInt64, ScaleKind::Binary, 0, 3));
}

TEST(Scale, RefusesValuesThatAreElsewhere)
{
  const Domain domain(ScalarType::Float64, Scale{ ScaleKind::Decimal, 3, -2 });
  const double right = 1.23, wrong = 1.234;
  EXPECT_NO_THROW(domain.Read(&right));
  EXPECT_THROW(domain.Read(&wrong), Error);
}
}
