// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCellShapes.h"
#include "gatunTestCells.h"

#include "gatunError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

Ids Count(std::uint32_t count, std::uint32_t first = 0)
{
  Ids ids(count);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

bool IsInLeftPart(const std::array<double, 3>& point)
{
  return point[0] < 0.3;
}

/** Decodes damaged streams. They must give a mesh or Error(Corrupt). */
void ExpectNoCrash(
  const CellCase& chunk, const Bytes& connectivity, const Bytes& geometry, const Bytes& corners)
{
  try
  {
    auto mesh = DecodeCells(chunk.Frame, {}, connectivity, geometry);
    EXPECT_EQ(mesh.Cells.GetNumber(), chunk.Frame.Cells.Cells);
    for (const auto v : mesh.Cells.Corners)
    {
      EXPECT_LT(v, mesh.Keys.size());
    }
    ArrayContext(mesh, mesh.Walk.HasTree() ? ContextFits::None : ContextFits::All);
    RestoreCorners(mesh.Cells, corners);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Corrupt);
  }
}

void ExpectSafeCellsOf(const CellCase& chunk, Profile profile)
{
  const auto encoded = ExpectRoundTripOf(chunk, {}, profile);
  std::mt19937 random(4);
  const auto damage = [&](Bytes& stream)
  {
    if (random() % 3 == 0)
    {
      stream.resize(random() % (stream.size() + 1));
    }
    for (auto flips = random() % 4; flips > 0 && !stream.empty(); --flips)
    {
      stream[random() % stream.size()] ^= static_cast<std::uint8_t>(1 + random() % 255);
    }
  };
  for (unsigned i = 0; i < 300; ++i)
  {
    auto connectivity = encoded.Connectivity;
    auto geometry = encoded.Geometry;
    auto corners = encoded.Corners;
    damage(i % 3 == 0 ? connectivity : i % 3 == 1 ? geometry : corners);
    ExpectNoCrash(chunk, connectivity, geometry, corners);
    auto other = chunk;
    auto& counts = other.Frame.Cells;
    for (auto* count :
      { &counts.Cells, &counts.Corners, &counts.FaceValues, &other.Frame.OwnPoints })
    {
      *count = random() % 4 == 0 ? *count + random() % 5 - 2 : *count;
    }
    ExpectNoCrash(other, encoded.Connectivity, encoded.Geometry, encoded.Corners);
  }
}

void ExpectSafeCells(const CellCase& chunk)
{
  ExpectSafeCellsOf(chunk, Profile::Small);
  ExpectSafeCellsOf(chunk, Profile::Fast);
}
}

//------------------------------------------------------------------------------
TEST(CellCodec, KeepsEveryType)
{
  for (int type = 0; type < 256; ++type)
  {
    auto mesh = MakePoints(40);
    const auto usual = GetCellKind(type).Points;
    for (const std::uint32_t size : { 0u, 1u, 2u, 3u, 4u, 5u, 8u, 20u, 27u, unsigned{ usual } })
    {
      if (type == 42)
      {
        mesh.AddPolyhedron(Count(size), { Count(size), Count(3), Count(4, 2) });
      }
      else
      {
        mesh.Add(type, Count(size));
        mesh.Add(type, Count(size, 40 - size));
      }
    }
    ExpectRoundTrip(MakeCellCase(mesh));
  }
}

TEST(CellCodec, KeepsSoups)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    ExpectRoundTrip(MakeCellCase(MakeZoo(40 + 400 * seed, 500, seed)));
    ExpectRoundTrip(MakeCellCase(
      MakeZoo(200, 300, seed), { .Type = ScalarType::Float32, .IsShared = IsInLeftPart }));
  }
}

TEST(CellCodec, KeepsHexahedra)
{
  for (const double jitter : { 0.0, 0.2 })
  {
    auto mesh = MakeHexes(8, jitter);
    ExpectRoundTrip(MakeCellCase(mesh));
    ExpectRoundTrip(MakeCellCase(mesh, { .Type = ScalarType::Float32, .IsShared = IsInLeftPart }));
    ExpectRoundTrip(
      MakeCellCase(mesh, { .IsShared = [](const std::array<double, 3>&) { return true; } }));
    ShuffleCells(mesh);
    ExpectRoundTrip(MakeCellCase(mesh));
  }
  ExpectRoundTrip(MakeCellCase(MakeHexes(8, 0), { .Palettes = true, .IsShared = IsInLeftPart }));
}

TEST(CellCodec, KeepsTheSmallestChunks)
{
  ExpectRoundTrip(MakeCellCase({}));
  auto mesh = MakePoints(8);
  mesh.Add(0, {});
  ExpectRoundTrip(MakeCellCase(mesh));
  mesh.Add(1, { 3 });
  ExpectRoundTrip(MakeCellCase(mesh));
  mesh.AddPolyhedron({}, {});
  ExpectRoundTrip(MakeCellCase(mesh));
  mesh.AddPolyhedron({}, { {}, {}, { 4 }, {} });
  ExpectRoundTrip(MakeCellCase(mesh));
  mesh.Add(12, { 7, 7, 7, 7, 7, 7, 7, 7 });
  ExpectRoundTrip(MakeCellCase(mesh));
}

TEST(CellCodec, KeepsLongCells)
{
  auto mesh = MakePoints(3000);
  mesh.Add(4, Count(3000));
  mesh.Add(6, Count(2000, 500));
  mesh.Add(7, Count(100, 500));
  mesh.AddPolyhedron(Count(1000), { Count(300), Count(300, 300), Count(400, 600) });
  ExpectRoundTrip(MakeCellCase(mesh));
}

TEST(CellCodec, KeepsStrangeCoordinates)
{
  auto mesh = MakeHexes(3, 0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  mesh.Points[5] = { infinity, -infinity, -0.0 };
  mesh.Points[20] = { 1e308, -1e308, 1e-310 };
  ExpectRoundTrip(MakeCellCase(mesh));
  auto chunk = MakeCellCase(mesh);
  chunk.OwnKeys[30] = { ~Key{ 0 }, 0, 1 }; // not numbers
  ExpectRoundTrip(chunk);
}

TEST(CellCodec, KeepsFacesOfPolyhedraInAnyOrder)
{
  const Faces cube{ { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
    { 3, 0, 4, 7 } };
  std::mt19937 random(6);
  auto mesh = MakePoints(8);
  for (int i = 0; i < 50; ++i)
  {
    auto faces = cube;
    std::shuffle(faces.begin(), faces.end(), random);
    for (auto& face : faces)
    {
      std::rotate(face.begin(), face.begin() + random() % 4, face.end());
    }
    faces.resize(i % 7 == 0 ? 5 : 6); // some are open
    auto corners = Count(8);
    std::shuffle(corners.begin(), corners.end(), random);
    mesh.AddPolyhedron(corners, faces);
  }
  ExpectRoundTrip(MakeCellCase(mesh));
}

TEST(CellCodec, OrdersCellsInSpace)
{
  auto mesh = MakeHexes(16, 0);
  const auto given = ExpectRoundTrip(MakeCellCase(mesh));
  ShuffleCells(mesh);
  const auto shuffled = ExpectRoundTrip(MakeCellCase(mesh));
  // The numbers of the corners alone would take 8 * 13 bits.
  EXPECT_LT(GetBits(given.Connectivity, given), 104.0 / 10);
  EXPECT_LT(GetBits(shuffled.Connectivity, shuffled), 104.0 / 2);
}

TEST(CellCodec, RejectsDamagedStreams)
{
  ExpectSafeCells(MakeCellCase(MakeHexes(4, 0.1), { .IsShared = IsInLeftPart }));
  ExpectSafeCells(MakeCellCase(MakeHexes(4, 0), { .Palettes = true }));
  ExpectSafeCells(MakeCellCase(MakeZoo(60, 120, 1), { .IsShared = IsInLeftPart }));
}

TEST(CellCodec, CopiesCornersInTheFastProfile)
{
  auto mesh = MakeHexes(20, 0.1);
  ShuffleCells(mesh);
  const auto hexes = ExpectRoundTripOf(MakeCellCase(mesh), {}, Profile::Fast);
  EXPECT_LT(GetBits(hexes.Connectivity, hexes), 4);
  // Only the first cell has nothing to copy from.
  const auto& parents = hexes.Mesh.Walk.Parents;
  EXPECT_EQ(std::count(parents.begin(), parents.end(), Topology::NoTet), 1);
}

TEST(CellCodec, TurnsTrianglesInTheFastProfile)
{
  constexpr std::uint32_t side = 40;
  auto mesh = MakePoints(side * side);
  std::mt19937 random(8);
  const auto add = [&](Ids corners)
  {
    std::rotate(corners.begin(), corners.begin() + random() % 3, corners.end());
    mesh.Add(TriangleType, corners);
  };
  for (std::uint32_t v = 0; v + side < side * side; ++v)
  {
    if (v % side + 1 < side)
    {
      add({ v, v + 1, v + side });
      add({ v + 1, v + side + 1, v + side });
    }
  }
  const auto chunk = MakeCellCase(mesh);
  const auto kept = ExpectRoundTripOf(chunk, {}, Profile::Fast);
  const auto turned =
    EncodeCells(chunk.Frame, chunk.Cells, {}, chunk.OwnKeys, false, Profile::Fast);
  EXPECT_LT(3 * turned.Connectivity.size(), kept.Connectivity.size());
}

TEST(CellCodec, HasWalksWhereVerticesAreTooManyForTheFastProfile)
{
  const auto many = MakePoints(TetTree::MaxVertices + 1);
  auto mesh = many;
  mesh.Add(2, Count(TetTree::MaxVertices));
  EXPECT_TRUE(ExpectRoundTripOf(MakeCellCase(mesh), {}, Profile::Fast).Mesh.Walk.HasTree());
  mesh = many;
  mesh.Add(2, Count(TetTree::MaxVertices + 1));
  EXPECT_FALSE(ExpectRoundTripOf(MakeCellCase(mesh), {}, Profile::Fast).Mesh.Walk.HasTree());
}

TEST(CellCodec, HandlesLargeDegenerateMeshes)
{
  // An algorithm of quadratic cost would take hours and exceed the time limit of the test.
  auto fan = MakePoints(40000);
  auto dust = MakePoints(40000);
  auto same = MakePoints(40000);
  auto strips = MakePoints(40000);
  for (std::uint32_t i = 0; i + 16 < 40000; ++i)
  {
    fan.Add(5, { 0, i + 1, i + 2 });
    if (i % 8 == 0)
    {
      dust.Add(12, Count(8, i));
    }
    same.Add(12, Count(8));
    strips.Add(6, Count(9 + i % 7, i));
  }
  for (const auto* mesh : { &fan, &dust, &same, &strips })
  {
    ExpectRoundTripOf(MakeCellCase(*mesh), {}, Profile::Fast);
  }
}

TEST(CellCodec, SurvivesEveryDamagedByteInTheFastProfile)
{
  auto hexes = MakeHexes(4, 0.1);
  ShuffleCells(hexes);
  for (const auto& mesh : { hexes, MakeZoo(60, 60, 3) })
  {
    const auto chunk = MakeCellCase(mesh, { .IsShared = IsInLeftPart });
    const auto encoded = ExpectRoundTripOf(chunk, {}, Profile::Fast);
    for (std::size_t at = 0; at < encoded.Connectivity.size(); ++at)
    {
      auto damaged = encoded.Connectivity;
      for (const std::uint8_t change : { 1, 2, 128, 255 })
      {
        damaged[at] = encoded.Connectivity[at] ^ change;
        ExpectNoCrash(chunk, damaged, encoded.Geometry, encoded.Corners);
      }
    }
  }
}

TEST(CellCodec, BoundsMemoryByTheLengthOfTheStream)
{
  auto chunk = MakeCellCase(MakeHexes(2, 0));
  const auto encoded = ExpectRoundTrip(chunk);
  const auto expectCorrupt = [&](const ChunkFrame& frame)
  { EXPECT_THROW(DecodeCells(frame, {}, encoded.Connectivity, encoded.Geometry), Error); };
  auto frame = chunk.Frame;
  frame.Cells.Cells = 1u << 20;
  expectCorrupt(frame);
  frame = chunk.Frame;
  frame.Cells.Corners = 1u << 24;
  expectCorrupt(frame);
  frame = chunk.Frame;
  frame.Cells.FaceValues = 0xffffffffu;
  expectCorrupt(frame);
  frame = chunk.Frame;
  frame.OwnPoints = 0xffffffffu;
  expectCorrupt(frame);
}
