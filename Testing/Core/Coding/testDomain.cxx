// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDomain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace
{
using namespace gatun;

template <typename T>
void ExpectMonotoneAndInvertible(ScalarType type)
{
  const Domain domain(type);
  ASSERT_EQ(domain.GetBits(), 8 * sizeof(T));
  std::vector<T> values{ std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max(),
    std::numeric_limits<T>::min(), T(0), T(1), T(3), T(100) };
  if constexpr (std::is_signed_v<T>)
  {
    values.insert(values.end(), { T(-1), T(-3), T(-100) });
  }
  if constexpr (std::is_floating_point_v<T>)
  {
    const T infinity = std::numeric_limits<T>::infinity();
    values.insert(values.end(), { infinity, -infinity, T(0.1), T(-0.1) });
    values.push_back(std::numeric_limits<T>::denorm_min());
  }
  std::sort(values.begin(), values.end());
  Key before = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const Key key = domain.Read(&values[i]);
    if (i > 0)
    {
      EXPECT_EQ(before < key, values[i - 1] < values[i]);
    }
    T back{};
    domain.Write(key, &back);
    EXPECT_EQ(std::memcmp(&back, &values[i], sizeof(T)), 0);
    EXPECT_EQ(domain.ToNumber(key), static_cast<double>(values[i]));
    if (sizeof(T) < 8 && std::isfinite(domain.ToNumber(key)))
    {
      EXPECT_EQ(domain.FromNumber(domain.ToNumber(key)), key);
    }
    EXPECT_EQ(domain.Add(before, domain.Subtract(key, before)), key);
    before = key;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double number : { infinity, -infinity, infinity - infinity })
  {
    EXPECT_EQ(domain.FromNumber(number), domain.FromNumber(0));
  }
  for (const double number : { 1e308, -1e308, 1e-320, 9.3e18, -9.3e18, 1.9e19 })
  {
    T value{};
    domain.Write(domain.FromNumber(number), &value); // the nearest there is, no overflow
    const auto low = static_cast<double>(std::numeric_limits<T>::lowest());
    const auto high = static_cast<double>(std::numeric_limits<T>::max());
    if (std::abs(number) > 1)
    {
      EXPECT_EQ(static_cast<double>(value),
        static_cast<double>(static_cast<T>(number <= low ? std::numeric_limits<T>::lowest()
            : number >= high                             ? std::numeric_limits<T>::max()
                                                         : static_cast<T>(number))));
    }
  }
}

TEST(Domain, IsMonotoneAndInvertible)
{
  ExpectMonotoneAndInvertible<std::int8_t>(ScalarType::Int8);
  ExpectMonotoneAndInvertible<std::uint8_t>(ScalarType::UInt8);
  ExpectMonotoneAndInvertible<std::int16_t>(ScalarType::Int16);
  ExpectMonotoneAndInvertible<std::uint16_t>(ScalarType::UInt16);
  ExpectMonotoneAndInvertible<std::int32_t>(ScalarType::Int32);
  ExpectMonotoneAndInvertible<std::uint32_t>(ScalarType::UInt32);
  ExpectMonotoneAndInvertible<std::int64_t>(ScalarType::Int64);
  ExpectMonotoneAndInvertible<std::uint64_t>(ScalarType::UInt64);
  ExpectMonotoneAndInvertible<float>(ScalarType::Float32);
  ExpectMonotoneAndInvertible<double>(ScalarType::Float64);
}

TEST(Domain, KeepsPayloadsOfNaN)
{
  const Domain domain(ScalarType::Float64);
  for (const std::uint64_t bits :
    { 0x7ff8000000000001u, 0xfff0000000000001u, 0x7fffffffffffffffu, 0xffffffffffffffffu })
  {
    std::uint64_t back = 0;
    domain.Write(domain.Read(&bits), &back);
    EXPECT_EQ(back, bits);
  }
}

TEST(Domain, RanksInAPalette)
{
  const Domain domain(
    ScalarType::UInt16, std::make_shared<const Palette>(Palette{ 2, 3, 5, 7, 1000 }));
  for (const std::uint16_t value : { 2, 3, 5, 7, 1000 })
  {
    std::uint16_t back = 0;
    domain.Write(domain.Read(&value), &back);
    EXPECT_EQ(back, value);
  }
  EXPECT_TRUE(domain.IsValid(4));
  EXPECT_FALSE(domain.IsValid(5));
  EXPECT_EQ(domain.FromNumber(1e9), 4u);
  EXPECT_EQ(domain.FromNumber(-3), 0u);
}

/** Keys, numbers and residuals of a special case of a domain are those of the domain. */
template <typename Special>
void ExpectSame(const Special& special, const Domain& domain, Key key, Key before,
  std::initializer_list<double> numbers)
{
  ASSERT_TRUE(special.IsValid(key));
  ASSERT_EQ(std::bit_cast<std::uint64_t>(special.ToNumber(key)),
    std::bit_cast<std::uint64_t>(domain.ToNumber(key)));
  const auto residual = special.Subtract(key, before);
  ASSERT_EQ(residual, domain.Subtract(key, before));
  ASSERT_EQ(special.Add(before, residual), key);
  ASSERT_EQ(special.Add(key, residual), domain.Add(key, residual));
  for (const double number : numbers)
  {
    ASSERT_EQ(special.FromNumber(number), domain.FromNumber(number)) << number;
  }
}

TEST(Domain, OfFloat32IsTheSameWithoutDispatch)
{
  const Domain domain(ScalarType::Float32);
  ASSERT_TRUE(Float32Domain::Matches(domain));
  EXPECT_FALSE(Float32Domain::Matches(Domain(ScalarType::Float64)));
  EXPECT_FALSE(Float32Domain::Matches(
    Domain(ScalarType::Float32, std::make_shared<const Palette>(Palette{ 1, 2 }))));
  EXPECT_EQ(Float32Domain::GetBits(), domain.GetBits());
  std::mt19937_64 random(6);
  Key before = 0;
  for (int i = 0; i < 200000; ++i)
  {
    // All exponents, NaN and infinity among them.
    const Key key = i < 1000 ? static_cast<Key>(i) << 22 : random() & 0xffffffffu;
    const double number = domain.ToNumber(key);
    const double wide = std::bit_cast<double>(random());
    ASSERT_NO_FATAL_FAILURE(ExpectSame(Float32Domain(), domain, key, before,
      { number, number * 1.00000001, number * number, wide, -0.0 }));
    before = key;
  }
}

TEST(Domain, OfShiftedFloat32IsTheSameWithoutDispatch)
{
  EXPECT_FALSE(ShiftedFloat32Domain::Matches(Domain(ScalarType::Float64)));
  EXPECT_FALSE(
    ShiftedFloat32Domain::Matches(Domain(ScalarType::Float32, Scale{ ScaleKind::Fixed, 2, 0 })));
  EXPECT_FALSE(ShiftedFloat32Domain::Matches(
    Domain(ScalarType::Float32, std::make_shared<const Palette>(Palette{ 1, 2 }))));
  std::mt19937_64 random(7);
  for (std::uint8_t digits = 0; digits < 32; ++digits)
  {
    const Domain domain = digits == 0
      ? Domain(ScalarType::Float32)
      : Domain(ScalarType::Float32, Scale{ ScaleKind::Shift, digits, 0 });
    ASSERT_TRUE(ShiftedFloat32Domain::Matches(domain));
    const ShiftedFloat32Domain shifted(domain);
    EXPECT_EQ(shifted.GetBits(), domain.GetBits());
    const Key last = 0xffffffffu >> digits;
    Key before = 0;
    for (int i = 0; i < 10000; ++i)
    {
      const Key key = i == 0 ? 0 : i == 1 ? last : random() & last;
      const double number = domain.ToNumber(key);
      const double wide = std::bit_cast<double>(random());
      ASSERT_NO_FATAL_FAILURE(ExpectSame(shifted, domain, key, before,
        { number, number * 1.01, number * 1.00000001, wide, -0.0, 0.0 }))
        << "with " << int{ digits };
      before = key;
    }
    EXPECT_TRUE(digits == 0 || !shifted.IsValid(last + 1));
  }
}

TEST(Domain, OfRanksIsTheSameWithoutDispatch)
{
  EXPECT_FALSE(RankDomain::Matches(Domain(ScalarType::Float32)));
  std::mt19937_64 random(9);
  for (const std::size_t size : { 1, 2, 3, 255, 256, 65536 })
  {
    Palette palette(size);
    std::iota(palette.begin(), palette.end(), Key{ 77 });
    const Domain domain(ScalarType::Float64, std::make_shared<const Palette>(palette));
    ASSERT_TRUE(RankDomain::Matches(domain));
    const RankDomain ranks(domain);
    EXPECT_EQ(ranks.GetBits(), domain.GetBits());
    EXPECT_FALSE(ranks.IsValid(size));
    Key before = 0;
    for (int i = 0; i < 10000; ++i)
    {
      const Key key = i == 0 ? 0 : i == 1 ? size - 1 : random() % size;
      const auto number = static_cast<double>(key);
      const double wide = std::bit_cast<double>(random());
      ASSERT_NO_FATAL_FAILURE(ExpectSame(ranks, domain, key, before,
        { number, number + 0.5, number - 0.5, number + 0.49999, number - 0.50001, wide, -0.0,
          std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() }));
      before = key;
    }
  }
}

TEST(Domain, OfMultiplesOfPowersOfTwoIsTheSameWithoutDispatch)
{
  EXPECT_FALSE(BinaryDomain::Matches(Domain(ScalarType::Float64)));
  EXPECT_FALSE(BinaryDomain::Matches(Domain(ScalarType::Float32, Scale{ ScaleKind::Fixed, 2, 0 })));
  std::mt19937_64 random(8);
  for (const auto type : { ScalarType::Float32, ScalarType::Float64 })
  {
    for (const int first : { -126, -40, -12, 0, 5, 103 })
    {
      const Domain domain(type, Scale{ ScaleKind::Binary, 0, static_cast<std::int8_t>(first) });
      ASSERT_TRUE(BinaryDomain::Matches(domain));
      const BinaryDomain binary(domain);
      EXPECT_EQ(binary.GetBits(), domain.GetBits());
      EXPECT_EQ(binary.GetType(), type);
      const Key zero = domain.FromNumber(0);
      Key before = zero;
      for (int i = 0; i < 10000; ++i)
      {
        const Key key = i == 0 ? 0 : i == 1 ? 2 * zero : random() % (2 * zero + 1);
        const double number = domain.ToNumber(key);
        const double wide = std::bit_cast<double>(random());
        const double half = number + std::ldexp(0.5, first);
        ASSERT_NO_FATAL_FAILURE(ExpectSame(binary, domain, key, before,
          { number, half, -half, number * 1.01, number * 1.00000001, wide, -0.0, 0.0 }))
          << "with " << first;
        before = key;
      }
      EXPECT_FALSE(binary.IsValid(2 * zero + 1));
      EXPECT_FALSE(domain.IsValid(2 * zero + 1));
    }
  }
}
}
