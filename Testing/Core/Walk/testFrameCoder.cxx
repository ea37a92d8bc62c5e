// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Coordinates that are predicted in the frames of gates.

#include "gatunTestChunks.h"

#include "gatunError.h"
#include "gatunGateFrame.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr std::int64_t Side = 14;
constexpr std::uint8_t FlagFrame = 0x80;

/** Equal tetrahedra over the corners and centers of cubes: an edge of a cube, and the centers on
 * both sides of a face at it. Points are moved at random, and the whole is turned, so that no
 * coordinates repeat. */
TestMesh MakeEqualTets(double jitter, std::int64_t n = Side)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  TestMesh mesh;
  const auto add = [&](double x, double y, double z)
  {
    x += move(random);
    y += move(random);
    z += move(random);
    const std::array first{ 0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z };
    mesh.Coordinates.insert(mesh.Coordinates.end(),
      { first[0], 0.28 * first[1] - 0.96 * first[2], 0.96 * first[1] + 0.28 * first[2] });
  };
  using Place = std::array<std::int64_t, 3>;
  const auto corner = [&](const Place& p) { return (p[2] * (n + 1) + p[1]) * (n + 1) + p[0]; };
  const auto center = [&](const Place& p)
  { return (n + 1) * (n + 1) * (n + 1) + (p[2] * n + p[1]) * n + p[0]; };
  for (const auto& [count, offset] : { std::pair{ n + 1, 0.0 }, std::pair{ n, 0.5 } })
  {
    for (std::int64_t i = 0; i < count * count * count; ++i)
    {
      add(static_cast<double>(i % count) + offset, static_cast<double>(i / count % count) + offset,
        static_cast<double>(i / count / count) + offset);
    }
  }
  for (std::int64_t i = 0; i < n * n * n; ++i)
  {
    const Place cube{ i % n, i / n % n, i / n / n };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Place next = cube;
      if (++next[axis] == n)
      {
        continue;
      }
      // The corners of the face between the two, all around.
      std::array<Place, 4> around{ next, next, next, next };
      ++around[1][(axis + 1) % 3];
      ++around[2][(axis + 1) % 3];
      ++around[2][(axis + 2) % 3];
      ++around[3][(axis + 2) % 3];
      for (std::size_t k = 0; k < 4; ++k)
      {
        mesh.Ids.insert(mesh.Ids.end(),
          { corner(around[k]), corner(around[(k + 1) % 4]), center(cube), center(next) });
      }
    }
  }
  return mesh;
}

bool HasFrames(const EncodedChunk& chunk)
{
  return (chunk.Geometry[0] & FlagFrame) != 0;
}

double GetBitsPerPoint(const EncodedChunk& chunk)
{
  return 8.0 * static_cast<double>(chunk.Geometry.size()) /
    static_cast<double>(chunk.OwnOrder.size());
}

/** Seven known vertices on a gate. */
GateFrame MakeFrame(const std::array<std::array<double, 4>, 7>& places)
{
  GateRecord record;
  for (Vertex k = 0; k < GateRecord::Size; ++k)
  {
    record.Known[k] = k;
  }
  return { record, places };
}

//------------------------------------------------------------------------------
TEST(GateFrame, KnowsTheShapeOfAGate)
{
  // A right triangle, whose circle has its center in the middle of the longest side.
  const auto frame = MakeFrame({ { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 6, 0 }, { 1, 1, -2 }, { 3, 6, 2 },
    { 0, 0, -1 }, { 3, 0, -4 } } });
  EXPECT_EQ(frame.Middle, (FrameVector{ 1, 2, 0 }));
  EXPECT_EQ(frame.Normal, (FrameVector{ 0, 0, 1 }));
  EXPECT_NEAR(frame.Center[0], 0.5, 1e-12);
  EXPECT_NEAR(frame.Center[1], 1, 1e-12);
  EXPECT_EQ(frame.Center[2], 0);
  // Only the first far corner is above the gate, by 2: the vertex is drawn to the corner (0, 0, 0).
  EXPECT_EQ(frame.Far, (FrameVector{ -2, -4, 0 }));
  // 6 / size^2 is the sum of the inverse squares of the edges from the far corners.
  const double sum = 1 / 40.0 + 1 / 13.0 + 1 / 37.0 + 1 / 1.0 + 1 / 25.0 + 1 / 16.0;
  EXPECT_NEAR(6 / (frame.Size * frame.Size), sum, 1e-12);
}

TEST(GateFrame, PointsAwayFromTheApex)
{
  const auto frame = MakeFrame({ { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 6, 0 }, { 1, 1, 2 }, { 3, 6, 2 },
    { 0, 0, -1 }, { 3, 0, -4 } } });
  EXPECT_EQ(frame.Normal, (FrameVector{ 0, 0, -1 }));
}

TEST(GateFrame, HasNoNormalWithoutArea)
{
  const auto frame = MakeFrame({ { { 0, 0, 0 }, { 3, 0, 0 }, { 6, 0, 0 }, { 1, 1, 2 }, { 3, 6, 2 },
    { 0, 0, -1 }, { 3, 0, -4 } } });
  EXPECT_EQ(frame.Normal, FrameVector{});
  EXPECT_EQ(frame.Center, FrameVector{});
}

//------------------------------------------------------------------------------
TEST(FrameCoder, IsForWellShapedTetrahedra)
{
  for (const auto type : { ScalarType::Float32, ScalarType::Float64 })
  {
    EXPECT_TRUE(HasFrames(ExpectRoundTrip(MakeCase(MakeEqualTets(0.1), { .Type = type }))));
    EXPECT_FALSE(HasFrames(ExpectRoundTrip(MakeCase(MakeCubes(12, 0), { .Type = type }))));
  }
}

TEST(FrameCoder, TakesBitsForWhatIsRandom)
{
  // A coordinate that is off by up to 1/2^k takes one bit less for each k.
  const CaseOptions options{ .Type = ScalarType::Float64 };
  const auto far = ExpectRoundTrip(MakeCase(MakeEqualTets(0.16), options));
  const auto near = ExpectRoundTrip(MakeCase(MakeEqualTets(0.01), options));
  ASSERT_TRUE(HasFrames(far));
  EXPECT_NEAR(GetBitsPerPoint(far) - GetBitsPerPoint(near), 3 * 4, 3);
}

TEST(FrameCoder, KeepsSharedVertices)
{
  const CaseOptions options{ .Type = ScalarType::Float32,
    .IsShared = [](const double* point) { return point[0] < 2; } };
  EXPECT_TRUE(HasFrames(ExpectRoundTrip(MakeCase(MakeEqualTets(0.1), options))));
}

TEST(FrameCoder, KeepsWhatHasNoShape)
{
  auto mesh = MakeEqualTets(0.1);
  const auto set = [&](std::size_t point, double x, double y, double z)
  {
    mesh.Coordinates[3 * point] = x;
    mesh.Coordinates[3 * point + 1] = y;
    mesh.Coordinates[3 * point + 2] = z;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  set(500, std::numeric_limits<double>::quiet_NaN(), 1, -0.0);
  set(720, infinity, -infinity, 3);
  set(1100, 1e300, -1e300, 1e-320);
  for (std::size_t point = 1500; point < 1510; ++point)
  {
    set(point, 1, 2, 3); // edges without length, gates without area
  }
  EXPECT_TRUE(HasFrames(ExpectRoundTrip(MakeCase(mesh))));
}

TEST(FrameCoder, IsOneRuleAmongOthers)
{
  // Half of the mesh is a grid, the other half is not.
  auto mesh = MakeCubes(12, 0);
  auto other = MakeEqualTets(0.1);
  const auto first = static_cast<std::int64_t>(mesh.GetPoints());
  for (auto& id : other.Ids)
  {
    id += first;
  }
  mesh.Ids.insert(mesh.Ids.end(), other.Ids.begin(), other.Ids.end());
  mesh.Coordinates.insert(
    mesh.Coordinates.end(), other.Coordinates.begin(), other.Coordinates.end());
  const auto encoded = ExpectRoundTrip(MakeCase(mesh, { .Type = ScalarType::Float32 }));
  EXPECT_TRUE(HasFrames(encoded));
  const auto rules = static_cast<std::uint8_t>(GetGridRules().size() + 1);
  EXPECT_EQ(encoded.Geometry[0], FlagFrame | rules);
  std::vector<std::size_t> used(rules, 0);
  for (const auto rule : encoded.Mesh.UsedRules)
  {
    ++used[rule];
  }
  EXPECT_GT(used.back(), 1000U);
  EXPECT_GT(encoded.Mesh.UsedRules.size() - used.back(), 1000U);
}

TEST(FrameCoder, RejectsUnknownRules)
{
  const auto chunk = MakeCase(MakeEqualTets(0.1, 6), { .Type = ScalarType::Float32 });
  auto encoded = EncodeChunk(chunk.Frame, chunk.Elements, chunk.OwnKeys);
  ASSERT_EQ(encoded.Geometry[0], FlagFrame | 1);
  const auto decode = [&] { DecodeChunk(chunk.Frame, encoded.Connectivity, encoded.Geometry); };
  EXPECT_NO_THROW(decode());
  for (const auto head : { 0, 17, 128, 145, 255 })
  {
    encoded.Geometry[0] = static_cast<std::uint8_t>(head);
    EXPECT_THROW(decode(), Error) << head;
  }
  encoded.Geometry[0] = FlagFrame | 1;
  // The two deviations are the last of five numbers behind one rule of seven.
  for (const std::size_t at : { 1U + 2 * 7 + 2 * 3, 1U + 2 * 7 + 2 * 4 })
  {
    const std::array kept{ encoded.Geometry[at], encoded.Geometry[at + 1] };
    for (const int deviation : { 0, -1, -32768 })
    {
      encoded.Geometry[at] = static_cast<std::uint8_t>(deviation);
      encoded.Geometry[at + 1] = static_cast<std::uint8_t>(deviation >> 8);
      EXPECT_THROW(decode(), Error) << at << ' ' << deviation;
    }
    encoded.Geometry[at] = kept[0];
    encoded.Geometry[at + 1] = kept[1];
  }
}
}
