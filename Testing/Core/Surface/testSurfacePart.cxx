// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Arrays on the isosurfaces of a part of a mesh.

#include "gatunSurfaceSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace gatun::test
{
namespace
{
/** Interpolates from one tuple to another over part of the way. */
template <typename T>
std::vector<T> Interpolate(
  ScalarType type, const std::vector<T>& low, const std::vector<T>& high, double part)
{
  const TestMesh mesh{ { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 }, { 0, 1, 2, 3 } };
  const std::vector<double> values = { 0, 1, 1, 1 };
  std::vector<T> tuples(low);
  for (int i = 0; i < 3; ++i)
  {
    tuples.insert(tuples.end(), high.begin(), high.end());
  }
  SurfaceInput input;
  input.Mesh.Points = 4;
  input.Mesh.Connectivity = mesh.Ids.data();
  input.Mesh.Values = values.data();
  input.Points = { mesh.Coordinates.data(), ScalarType::Float64, 3 };
  input.PointArrays = { { tuples.data(), type, static_cast<std::uint32_t>(low.size()) } };
  SurfaceOptions options;
  options.Values = { part };
  const auto made = MakeSurfacePart(input, options, 0, 1);
  EXPECT_EQ(made.NumberOfPoints, 3u);
  EXPECT_EQ(made.PointArrays[0].size(), 3 * low.size() * sizeof(T));
  std::vector<T> out(3 * low.size());
  std::memcpy(out.data(), made.PointArrays[0].data(), out.size() * sizeof(T));
  EXPECT_TRUE(std::equal(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(low.size()),
    out.begin() + static_cast<std::ptrdiff_t>(low.size())));
  out.resize(low.size());
  return out;
}

template <typename T>
void ExpectInterpolated(ScalarType type)
{
  using Limits = std::numeric_limits<T>;
  const T most = Limits::max();
  const T least = Limits::lowest();
  // Halfway: halves of whole numbers go away from zero.
  const std::vector<T> low = { 1, 2, 10, most, least, 0, 100 };
  const std::vector<T> high = { 2, 1, 14, most, least, 3, 3 };
  const bool whole = std::is_integral_v<T>;
  EXPECT_EQ(Interpolate<T>(type, low, high, 0.5),
    (std::vector<T>{ static_cast<T>(whole ? 2 : 1.5), static_cast<T>(whole ? 2 : 1.5), 12, most,
      least, static_cast<T>(whole ? 2 : 1.5), static_cast<T>(whole ? 52 : 51.5) }));
  EXPECT_EQ(Interpolate<T>(type, low, high, 0.25),
    (std::vector<T>{ static_cast<T>(whole ? 1 : 1.25), static_cast<T>(whole ? 2 : 1.75), 11, most,
      least, static_cast<T>(whole ? 1 : 0.75), static_cast<T>(whole ? 76 : 75.75) }));
  EXPECT_EQ(Interpolate<T>(type, low, high, 1), high);
  if constexpr (Limits::is_signed)
  {
    EXPECT_EQ(
      Interpolate<T>(type, { -1, -2, -10, -3, 1, most }, { -2, -1, -14, 2, -2, least }, 0.5),
      (std::vector<T>{ static_cast<T>(whole ? -2 : -1.5), static_cast<T>(whole ? -2 : -1.5), -12,
        static_cast<T>(whole ? -1 : -0.5), static_cast<T>(whole ? -1 : -0.5),
        // Their middle is -0.5, which is lost in the rounding of those of 64 bits.
        static_cast<T>(whole && sizeof(T) < 8 ? -1 : 0) }));
  }
  // Always a number between both, wherever it is, also with limits at the ends.
  for (int i = 1; i <= 1000; ++i)
  {
    const auto part = i / 1000.0;
    const auto made =
      Interpolate<T>(type, { most, 0, most, least }, { 0, most, most, least }, part);
    if constexpr (std::is_same_v<T, double>)
    {
      EXPECT_DOUBLE_EQ(made[2], most) << part;
      EXPECT_DOUBLE_EQ(made[3], least) << part;
    }
    else
    {
      EXPECT_EQ(made[2], most) << part;
      EXPECT_EQ(made[3], least) << part;
    }
    const auto share = static_cast<long double>(most) * part;
    const long double error =
      std::max<long double>(whole ? 0.5L : 0, share * (whole ? 2e-16L : 2e-7L));
    EXPECT_NEAR(static_cast<long double>(made[1]), share, error + 1e-9L) << part;
    EXPECT_NEAR(static_cast<long double>(made[0]), static_cast<long double>(most) - share,
      std::max<long double>(error, static_cast<long double>(most) * (whole ? 2e-16L : 2e-7L)) +
        1e-9L);
  }
}
}

//------------------------------------------------------------------------------
TEST(SurfacePart, InterpolatesValuesOfEveryType)
{
  ExpectInterpolated<std::int8_t>(ScalarType::Int8);
  ExpectInterpolated<std::uint8_t>(ScalarType::UInt8);
  ExpectInterpolated<std::int16_t>(ScalarType::Int16);
  ExpectInterpolated<std::uint16_t>(ScalarType::UInt16);
  ExpectInterpolated<std::int32_t>(ScalarType::Int32);
  ExpectInterpolated<std::uint32_t>(ScalarType::UInt32);
  ExpectInterpolated<std::int64_t>(ScalarType::Int64);
  ExpectInterpolated<std::uint64_t>(ScalarType::UInt64);
  ExpectInterpolated<float>(ScalarType::Float32);
  ExpectInterpolated<double>(ScalarType::Float64);
}

//------------------------------------------------------------------------------
TEST(SurfacePart, WholeNumbersNearTheEndOfTheirTypeStayInIt)
{
  // Numbers that the nearest double is too large for, at the end of an edge and on the way. A
  // number becomes a double, and of that come two products and a sum: at most three steps of a
  // double.
  const std::int64_t steps = 3 * 1024;
  for (const std::int64_t under : { 0, 1, 511, 512, 513, 1024, 1025 })
  {
    const auto value = std::numeric_limits<std::int64_t>::max() - under;
    const auto unsignedValue =
      std::numeric_limits<std::uint64_t>::max() - static_cast<std::uint64_t>(under);
    for (const double part : { 0.1, 0.3, 0.5, 0.7, 1.0 })
    {
      const auto made = Interpolate<std::int64_t>(ScalarType::Int64, { value }, { value }, part)[0];
      EXPECT_LE(std::abs(made - value), steps) << under;
      EXPECT_GT(made, 0) << under;
      const auto unsignedMade = Interpolate<std::uint64_t>(
        ScalarType::UInt64, { unsignedValue }, { unsignedValue }, part)[0];
      EXPECT_GE(unsignedMade, unsignedValue - 2 * std::uint64_t{ steps }) << under;
      const auto negative =
        Interpolate<std::int64_t>(ScalarType::Int64, { -value - 1 }, { -value - 1 }, part)[0];
      EXPECT_LT(negative, -(std::int64_t{ 1 } << 62)) << under;
    }
  }
}

//------------------------------------------------------------------------------
TEST(SurfacePart, ValuesOfAComponentOrOfTheLength)
{
  const std::vector<std::int16_t> tuples = { 3, -4, 0, 0, -5, 12 };
  MarchInput mesh;
  std::vector<double> converted;
  const TupleView view{ tuples.data(), ScalarType::Int16, 2 };
  using Components = std::vector<double>;
  SetMarchValues(mesh, view, 3, 0, converted);
  EXPECT_EQ(converted, (Components{ 3, 0, -5 }));
  SetMarchValues(mesh, view, 3, 1, converted);
  EXPECT_EQ(converted, (Components{ -4, 0, 12 }));
  SetMarchValues(mesh, view, 3, -1, converted);
  EXPECT_EQ(converted, (Components{ 5, 0, 13 }));
  EXPECT_EQ(mesh.Values, converted.data());
  EXPECT_TRUE(mesh.WideValues);
  // Of one component, the value itself, not its length; floating point values where they are.
  SetMarchValues(mesh, { tuples.data(), ScalarType::Int16, 1 }, 6, -1, converted);
  EXPECT_EQ(converted, (Components{ 3, -4, 0, 0, -5, 12 }));
  const std::vector<float> floats = { 1, 2 };
  for (const int component : { -1, 0 })
  {
    SetMarchValues(mesh, { floats.data(), ScalarType::Float32, 1 }, 2, component, converted);
    EXPECT_EQ(mesh.Values, floats.data());
    EXPECT_FALSE(mesh.WideValues);
    SetMarchValues(mesh, { converted.data(), ScalarType::Float64, 1 }, 6, component, converted);
    EXPECT_EQ(mesh.Values, converted.data());
    EXPECT_TRUE(mesh.WideValues);
  }
}

//------------------------------------------------------------------------------
TEST(SurfacePart, PointsAtTheEndOfAnEdgeAreThoseOfTheMesh)
{
  // With coordinates like these, going all the way from one end does not arrive at the other.
  auto mesh = MakeSoup(400, 2000);
  Sample sample(mesh);
  for (std::size_t i = 0; i < sample.Values.size(); ++i)
  {
    sample.Values[i] = static_cast<double>(i % 3);
  }
  const double* x = mesh.Coordinates.data();
  bool misses = false;
  for (std::size_t i = 3; i < mesh.Coordinates.size(); ++i)
  {
    misses = misses || x[i - 3] + (x[i] - x[i - 3]) != x[i];
  }
  ASSERT_TRUE(misses);
  std::set<Vector> ends;
  for (std::size_t i = 0; i < mesh.GetPoints(); ++i)
  {
    ends.insert(sample.Point(i));
  }
  SurfaceOptions options;
  options.Values = { 2 };
  options.CoordinateType = ScalarType::Float64;
  const Content<double> content(Make(sample, options));
  ASSERT_GT(content.Points.size(), 300u);
  for (std::size_t i = 0; i < content.Points.size() / 3; ++i)
  {
    EXPECT_TRUE(ends.count(content.Point(i)));
    EXPECT_EQ(content.Values[i], 2);
  }
}
}
