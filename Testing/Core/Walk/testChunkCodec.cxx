// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunChunkCodec.h"

#include "gatunError.h"
#include "gatunTestChunks.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

double GetBitsPerTet(const EncodedChunk& chunk)
{
  return 8.0 * static_cast<double>(chunk.Connectivity.size()) /
    static_cast<double>(chunk.TetOrder.size());
}

/** Whether the corners of a tetrahedron are in the order that VTK wants. */
bool IsPositive(const TestMesh& mesh, const std::int64_t* tet)
{
  std::array<std::array<double, 3>, 3> e{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      e[i][c] = mesh.Coordinates[3 * static_cast<std::size_t>(tet[i + 1]) + c] -
        mesh.Coordinates[3 * static_cast<std::size_t>(tet[0]) + c];
    }
  }
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
    e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]) >
    0;
}

/** n * n * n cubes of five tetrahedra each, mirrored from one to the next. */
TestMesh MakeFives(std::int64_t n)
{
  auto mesh = MakeCubes(n, 0);
  mesh.Ids.clear();
  constexpr int parts[5][4] = { { 0, 3, 5, 6 }, { 0, 1, 3, 5 }, { 0, 3, 2, 6 }, { 0, 5, 6, 4 },
    { 3, 5, 7, 6 } };
  for (std::int64_t cube = 0; cube < n * n * n; ++cube)
  {
    const std::array at{ cube % n, cube / n % n, cube / n / n };
    const int mirror = (at[0] + at[1] + at[2]) % 2 ? 1 : 0;
    for (const auto& part : parts)
    {
      std::array<std::int64_t, 4> tet{};
      for (std::size_t i = 0; i < 4; ++i)
      {
        const int bits = part[i] ^ mirror;
        const auto y = at[1] + (bits >> 1 & 1);
        const auto z = at[2] + (bits >> 2 & 1);
        tet[i] = (z * (n + 1) + y) * (n + 1) + at[0] + (bits & 1);
      }
      if (!IsPositive(mesh, tet.data()))
      {
        std::swap(tet[2], tet[3]);
      }
      mesh.Ids.insert(mesh.Ids.end(), tet.begin(), tet.end());
    }
  }
  return mesh;
}

/** So many tetrahedra around one edge. */
TestMesh MakeFan(std::int64_t count)
{
  TestMesh mesh;
  mesh.Coordinates = { 0, 0, -1, 0, 0, 1 };
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    mesh.Coordinates.insert(mesh.Coordinates.end(), { std::cos(angle), std::sin(angle), 0 });
    mesh.Ids.insert(mesh.Ids.end(), { 0, 1, 2 + i, 2 + (i + 1) % count });
  }
  return mesh;
}

/** So many tetrahedra on one triangle. */
TestMesh MakeBook(std::int64_t count)
{
  TestMesh mesh;
  mesh.Coordinates = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
  for (std::int64_t i = 0; i < count; ++i)
  {
    mesh.Coordinates.insert(mesh.Coordinates.end(), { 0.3, 0.3, 1.0 + static_cast<double>(i) });
    mesh.Ids.insert(mesh.Ids.end(), { 0, 1, 2, 3 + i });
  }
  return mesh;
}

/** Tetrahedra that touch one another nowhere. */
TestMesh MakeDust(std::int64_t count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  TestMesh mesh;
  for (std::int64_t i = 0; i < 4 * count; ++i)
  {
    mesh.Coordinates.insert(
      mesh.Coordinates.end(), { place(random), place(random), place(random) });
    mesh.Ids.push_back(i);
  }
  return mesh;
}

bool IsLeftPoint(const double* point)
{
  return point[0] < 1.5;
}
}

//------------------------------------------------------------------------------
TEST(ChunkCodec, KeepsGridsOfFiveTetrahedra)
{
  const auto encoded = ExpectRoundTrip(MakeCase(MakeFives(12)));
  EXPECT_LT(GetBitsPerTet(encoded), 0.5);
}

TEST(ChunkCodec, KeepsGridsOfSixTetrahedra)
{
  const auto encoded = ExpectRoundTrip(MakeCase(MakeCubes(12, 0)));
  EXPECT_LT(GetBitsPerTet(encoded), 0.5);
}

TEST(ChunkCodec, KeepsUnstructuredMeshes)
{
  ExpectRoundTrip(MakeCase(MakeCubes(12, 0.3)));
  ExpectRoundTrip(MakeCase(MakeCubes(10, 0.3), { .Type = ScalarType::Float32 }));
}

TEST(ChunkCodec, KeepsSharedVertices)
{
  for (const double jitter : { 0.0, 0.3 })
  {
    CaseOptions options;
    options.IsShared = IsLeftPoint;
    ExpectRoundTrip(MakeCase(MakeCubes(10, jitter), options));
    options.IsShared = [](const double*) { return true; };
    ExpectRoundTrip(MakeCase(MakeCubes(6, jitter), options));
  }
}

TEST(ChunkCodec, KeepsPalettes)
{
  ExpectRoundTrip(MakeCase(MakeCubes(10, 0), { .Palettes = true }));
  ExpectRoundTrip(MakeCase(
    MakeCubes(8, 0.3), { .Type = ScalarType::Float32, .Palettes = true, .IsShared = IsLeftPoint }));
}

TEST(ChunkCodec, KeepsTheSmallestChunks)
{
  TestMesh mesh;
  mesh.Coordinates = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  mesh.Ids = { 0, 1, 2, 3 };
  ExpectRoundTrip(MakeCase(mesh));
  ExpectRoundTrip(MakeCase(mesh, { .IsShared = IsLeftPoint }));
  mesh.Ids = { 2, 2, 2, 2, 3, 1, 1, 0, 1, 0, 2, 3 }; // corners named twice
  ExpectRoundTrip(MakeCase(mesh));
}

TEST(ChunkCodec, KeepsEveryOrderOfCorners)
{
  auto mesh = MakeCubes(6, 0.2);
  std::mt19937 random(3);
  for (std::size_t t = 0; t < mesh.GetTets(); ++t) // half of them inverted
  {
    std::shuffle(mesh.Ids.begin() + static_cast<std::ptrdiff_t>(4 * t),
      mesh.Ids.begin() + static_cast<std::ptrdiff_t>(4 * t + 4), random);
  }
  ExpectRoundTrip(MakeCase(mesh));
}

TEST(ChunkCodec, KeepsMeshesThatAreNotManifold)
{
  ExpectRoundTrip(MakeCase(MakeSoup(50, 2000)));
  ExpectRoundTrip(MakeCase(MakeSoup(3000, 2000)));
  ExpectRoundTrip(MakeCase(MakeBook(300)));
  auto twice = MakeCubes(5, 0.2);
  const auto once = twice.Ids;
  twice.Ids.insert(twice.Ids.end(), once.begin(), once.end());
  twice.Ids.insert(twice.Ids.end(), once.begin(), once.end());
  ExpectRoundTrip(MakeCase(twice));
}

TEST(ChunkCodec, KeepsFlatMeshes)
{
  auto flat = MakeCubes(8, 0.2);
  for (std::size_t i = 2; i < flat.Coordinates.size(); i += 3)
  {
    flat.Coordinates[i] = 5;
  }
  ExpectRoundTrip(MakeCase(flat, { .IsShared = IsLeftPoint }));
  std::fill(flat.Coordinates.begin(), flat.Coordinates.end(), -0.0);
  ExpectRoundTrip(MakeCase(flat));
}

TEST(ChunkCodec, KeepsExtremeCoordinates)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto type : { ScalarType::Float32, ScalarType::Float64 })
  {
    auto mesh = MakeCubes(6, 0.2);
    std::size_t at = 0;
    for (const double odd : { nan, -nan, infinity, -infinity, -0.0, 1e-310, 3e38, -3e38 })
    {
      mesh.Coordinates[at += 41] = odd;
    }
    ExpectRoundTrip(MakeCase(mesh, { .Type = type, .IsShared = IsLeftPoint }));
    std::fill(mesh.Coordinates.begin(), mesh.Coordinates.end(), nan);
    ExpectRoundTrip(MakeCase(mesh, { .Type = type }));
  }
  auto far = MakeCubes(6, 0.2);
  for (auto& x : far.Coordinates)
  {
    x = 1e15 + x;
  }
  ExpectRoundTrip(MakeCase(far));
  for (auto& x : far.Coordinates)
  {
    x = (x - 1e15) * 1e307; // the extent overflows
  }
  ExpectRoundTrip(MakeCase(far));
}

TEST(ChunkCodec, HandlesLargeDegenerateMeshes)
{
  // An algorithm of quadratic cost would take hours and exceed the time limit of the test.
  auto point = MakeCubes(20, 0.2); // all in one place
  std::fill(point.Coordinates.begin(), point.Coordinates.end(), 1.0);
  const auto all = [](const double*) { return true; };
  for (const auto& mesh :
    { MakeFan(50000), MakeBook(50000), MakeDust(20000), MakeSoup(100, 30000), point })
  {
    ExpectRoundTrip(MakeCase(mesh));
    ExpectRoundTrip(MakeCase(mesh, { .IsShared = all }));
  }
}

//------------------------------------------------------------------------------
namespace
{
/** Decodes what may be damaged: a mesh that fits its frame, or an Error, nothing else. */
void ExpectNoHarm(const ChunkFrame& frame, const Bytes& connectivity, const Bytes& geometry)
{
  try
  {
    const auto mesh = DecodeChunk(frame, connectivity, geometry);
    const auto tets = mesh.Walk.CopyTets();
    ASSERT_EQ(tets.size(), frame.Tets);
    ASSERT_EQ(mesh.Keys.size(), frame.OwnPoints + frame.SharedKeys.size());
    for (const auto& tet : tets)
    {
      for (const auto v : tet)
      {
        ASSERT_LT(v, mesh.Keys.size());
      }
    }
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Corrupt);
  }
}
}

TEST(ChunkCodec, SurvivesDamage)
{
  CaseOptions palettes{ .Palettes = true, .IsShared = IsLeftPoint };
  for (const auto& chunk : { MakeCase(MakeCubes(5, 0)), MakeCase(MakeCubes(5, 0.3), palettes),
         MakeCase(MakeSoup(40, 200)) })
  {
    for (const int variant : { 0, 1, 2, 3 })
    {
      const bool inGeometry = variant % 2 != 0;
      const auto profile = variant < 2 ? Profile::Small : Profile::Fast;
      const auto encoded = EncodeChunk(chunk.Frame, chunk.Elements, chunk.OwnKeys, profile);
      const auto& whole = inGeometry ? encoded.Geometry : encoded.Connectivity;
      const auto expectNoHarm = [&](const Bytes& damaged)
      {
        ExpectNoHarm(chunk.Frame, inGeometry ? encoded.Connectivity : damaged,
          inGeometry ? damaged : encoded.Geometry);
      };
      for (std::size_t at = 0; at < whole.size(); ++at)
      {
        auto damaged = whole;
        damaged[at] ^= static_cast<std::uint8_t>(1u << at % 8);
        expectNoHarm(damaged);
        damaged.resize(at);
        expectNoHarm(damaged);
      }
    }
  }
}

TEST(ChunkCodec, SurvivesNoise)
{
  std::mt19937 random(5);
  auto chunk = MakeCase(MakeCubes(5, 0.3), { .IsShared = IsLeftPoint });
  for (int i = 0; i < 300; ++i)
  {
    Bytes connectivity(400);
    Bytes geometry(4000);
    std::generate(connectivity.begin(), connectivity.end(), std::ref(random));
    std::generate(geometry.begin(), geometry.end(), std::ref(random));
    connectivity[0] &= 7;
    connectivity[1] = static_cast<std::uint8_t>(8 + random() % 100);
    geometry[0] = 1;
    geometry[15] = 120;
    ExpectNoHarm(chunk.Frame, connectivity, geometry);
    // A tree whose symbols are not packed.
    connectivity[0] = 8;
    connectivity[1] &= 1;
    connectivity[2] = 1;
    connectivity[3] = static_cast<std::uint8_t>(chunk.Frame.Tets / 2 + chunk.Frame.Tets % 2);
    ExpectNoHarm(chunk.Frame, connectivity, geometry);
  }
}
