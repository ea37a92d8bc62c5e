// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Coordinates of surfaces that are predicted on planes.

#include "gatunTestCells.h"

#include "gatunError.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr std::uint32_t PlaneSide = 40;

using GetHeight = std::function<double(double, double, std::mt19937&)>;

/** Triangles over an irregular lattice. */
TestCells MakeSheet(const GetHeight& getHeight)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> move(-0.3, 0.3);
  TestCells mesh;
  for (std::uint32_t y = 0; y < PlaneSide; ++y)
  {
    for (std::uint32_t x = 0; x < PlaneSide; ++x)
    {
      const double u = x + move(random);
      const double v = y + move(random);
      mesh.AddPoint(u, v, getHeight(u, v, random));
    }
  }
  for (std::uint32_t y = 0; y + 1 < PlaneSide; ++y)
  {
    for (std::uint32_t x = 0; x + 1 < PlaneSide; ++x)
    {
      const auto a = y * PlaneSide + x;
      mesh.Add(5, { a, a + 1, a + PlaneSide + 1 });
      mesh.Add(5, { a, a + PlaneSide + 1, a + PlaneSide });
    }
  }
  return mesh;
}

EncodedCells Encode(const TestCells& mesh, ScalarType type = ScalarType::Float32)
{
  return ExpectRoundTrip(MakeCellCase(mesh, { .Type = type }), {});
}

bool IsOnPlanes(const EncodedCells& encoded)
{
  return (encoded.Geometry[0] & 4) != 0;
}

TEST(PlaneCoder, PredictsTheThirdCoordinateOfSlopes)
{
  const auto noise = [](double, double, std::mt19937& random)
  { return std::uniform_real_distribution<double>(-1, 1)(random); };
  const auto slope = [](double u, double v, std::mt19937&) { return 0.7 * u - 0.4 * v; };
  const auto hill = [](double u, double v, std::mt19937&)
  { return 3 * std::sin(u / 10) * std::cos(v / 10); };
  for (const auto type : { ScalarType::Float32, ScalarType::Float64 })
  {
    const auto rough = Encode(MakeSheet(noise), type);
    const auto flat = Encode(MakeSheet(slope), type);
    const auto smooth = Encode(MakeSheet(hill), type);
    EXPECT_TRUE(IsOnPlanes(flat));
    EXPECT_TRUE(IsOnPlanes(smooth));
    // Two coordinates are random. The third one is exact but for its rounding.
    EXPECT_LT(
      static_cast<double>(flat.Geometry.size()), 0.76 * static_cast<double>(rough.Geometry.size()));
    EXPECT_LT(static_cast<double>(smooth.Geometry.size()),
      0.95 * static_cast<double>(rough.Geometry.size()));
  }
}

TEST(PlaneCoder, RepeatsCoordinatesOfCorners)
{
  const auto step = [](double u, double v, std::mt19937&)
  { return std::fmod(std::floor(u / 7) * 0.317 + std::floor(v / 9) * 0.211, 1.0); };
  const auto encoded = Encode(MakeSheet(step));
  EXPECT_EQ(encoded.Geometry[0] >> 2, 3);
  const auto flat = Encode(MakeSheet([](double, double, std::mt19937&) { return 0.1; }));
  EXPECT_LT(
    static_cast<double>(encoded.Geometry.size()), 1.2 * static_cast<double>(flat.Geometry.size()));
}

TEST(PlaneCoder, KeepsWhatIsNoNumber)
{
  auto mesh = MakeSheet([](double u, double v, std::mt19937&) { return 0.3 * u + 0.2 * v; });
  constexpr double infinity = std::numeric_limits<double>::infinity();
  mesh.Points[500][2] = std::numeric_limits<double>::quiet_NaN();
  mesh.Points[620] = { infinity, -infinity, 3 };
  mesh.Points[700][0] = -0.0;
  mesh.Points[820] = mesh.Points[821]; // no area
  mesh.Points[822] = mesh.Points[821];
  EXPECT_TRUE(IsOnPlanes(Encode(mesh)));
}

TEST(PlaneCoder, RejectsUnknownModes)
{
  const auto chunk =
    MakeCellCase(MakeSheet([](double u, double, std::mt19937&) { return 0.3 * u; }));
  auto encoded = EncodeCells(chunk.Frame, chunk.Cells, {}, chunk.OwnKeys, false);
  const auto decode = [&] { DecodeCells(chunk.Frame, {}, encoded.Connectivity, encoded.Geometry); };
  EXPECT_NO_THROW(decode());
  for (const auto mode : { 3, 7, 8, 16, 20, 255 })
  {
    encoded.Geometry[0] = static_cast<std::uint8_t>(mode);
    EXPECT_THROW(decode(), Error) << mode;
  }
}
}
