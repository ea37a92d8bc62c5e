// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunWalkSamples.h"

#include "gatunCellShapes.h"
#include "gatunError.h"
#include "gatunFillRecord.h"
#include "gatunHexForm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

Faces GetHexFaces(std::span<const std::uint32_t> c)
{
  return { { c[0], c[4], c[7], c[3] }, { c[1], c[2], c[6], c[5] }, { c[0], c[1], c[5], c[4] },
    { c[3], c[7], c[6], c[2] }, { c[0], c[3], c[2], c[1] }, { c[4], c[5], c[6], c[7] } };
}

void AddPolyhedra(TestCells& mesh, std::span<const std::uint32_t> c, std::size_t)
{
  mesh.AddPolyhedron({ c.begin(), c.end() }, GetHexFaces(c));
}

/** Different cells in layers, as in meshes for fluids. Faces between layers do not always fit. */
void AddMixed(TestCells& mesh, std::span<const std::uint32_t> c, std::size_t number)
{
  switch (number / 36 % 6)
  {
    case 0:
      AddWedges(mesh, c, number);
      break;
    case 1:
      AddTets(mesh, c, number);
      break;
    case 2:
      AddPyramids(mesh, c, number);
      break;
    case 3:
      AddPolyhedra(mesh, c, number);
      break;
    case 4:
      mesh.Add(11, { c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6] });
      break;
    default:
      mesh.Add(12, { c.begin(), c.end() });
  }
}

/** Hexagonal prisms in a honeycomb. */
TestCells MakeHoneycomb(int n, bool polyhedra)
{
  TestCells mesh;
  std::map<std::array<int, 3>, std::uint32_t> ids;
  const auto id = [&](int x, int y, int z)
  {
    const auto found = ids.find({ x, y, z });
    return found != ids.end() ? found->second
                              : ids[{ x, y, z }] = mesh.AddPoint(x * 0.866, y * 0.5, z);
  };
  for (int z = 0; z < n; ++z)
  {
    for (int row = 0; row < n; ++row)
    {
      for (int column = 0; column < n; ++column)
      {
        const int x = 2 * column + row % 2;
        const int y = 3 * row;
        Ids c;
        for (const int level : { z, z + 1 })
        {
          for (const auto& at :
            { std::array{ 0, 2 }, { -1, 1 }, { -1, -1 }, { 0, -2 }, { 1, -1 }, { 1, 1 } })
          {
            c.push_back(id(x + at[0], y + at[1], level));
          }
        }
        if (!polyhedra)
        {
          mesh.Add(16, c);
          continue;
        }
        Faces faces{ { c[5], c[4], c[3], c[2], c[1], c[0] },
          { c[6], c[7], c[8], c[9], c[10], c[11] } };
        for (unsigned i = 0; i < 6; ++i)
        {
          const auto next = (i + 1) % 6;
          faces.push_back({ c[i], c[next], c[6 + next], c[6 + i] });
        }
        mesh.AddPolyhedron(c, faces);
      }
    }
  }
  return mesh;
}

}

//------------------------------------------------------------------------------
TEST(PolygonWalk, KeepsGridsOfHexahedra)
{
  for (const int type : { 11, 12 })
  {
    const auto encoded = ExpectWalk(MakeHexes(16, 0, {}, type));
    EXPECT_LT(GetBits(encoded.Connectivity, encoded), 0.25);
  }
  ExpectWalk(MakeHexes(8, 0), { .Palettes = true, .IsShared = IsLeft });
}

TEST(PolygonWalk, KeepsUnstructuredHexahedra)
{
  auto mesh = MakeHexes(16, 0.2);
  ShuffleCells(mesh);
  const auto encoded = ExpectWalk(mesh);
  EXPECT_LT(GetBits(encoded.Connectivity, encoded), 0.5);
  ExpectWalk(mesh, { .Type = ScalarType::Float32, .IsShared = IsLeft });
  ExpectWalk(MakeHexes(6, 0.2), { .IsShared = [](const std::array<double, 3>&) { return true; } });
}

TEST(PolygonWalk, KeepsOtherCells)
{
  for (const double jitter : { 0.0, 0.15 })
  {
    for (auto* split : { AddWedges, AddPyramids, AddTets, AddPolyhedra, AddMixed })
    {
      auto mesh = SplitHexes(6, jitter, split);
      ExpectWalk(mesh);
      ShuffleCells(mesh);
      ExpectWalk(mesh, { .Type = ScalarType::Float32, .IsShared = IsLeft });
    }
  }
  ExpectWalk(MakeHoneycomb(6, false));
  ExpectWalk(MakeHoneycomb(6, true));
}

TEST(PolygonWalk, KnowsTheFormOfHexahedra)
{
  const std::vector<std::uint8_t> code{ 4, 4, 4, 5, 4, 6, 4, 4, 7, 6, 4, 5, 7, 4, 6, 7 };
  const CellForm form(code);
  EXPECT_EQ(form.Family, HexForm::Family);
  ASSERT_EQ(form.Corner.size(), HexForm::Sides);
  ASSERT_EQ(form.Edges.size(), HexForm::Edges.size());
  for (unsigned side = 0; side < HexForm::Sides; ++side)
  {
    EXPECT_EQ(form.Corner[side], HexForm::Corner[side]);
    EXPECT_EQ(form.Face[side], HexForm::Face[side]);
    EXPECT_EQ(form.Twin[side], HexForm::Twin[side]);
    EXPECT_EQ(form.Below[side], HexForm::Below[side]);
  }
  for (std::size_t e = 0; e < form.Edges.size(); ++e)
  {
    EXPECT_EQ(form.Edges[e][0], HexForm::Edges[e][0]);
    EXPECT_EQ(form.Edges[e][1], HexForm::Edges[e][1]);
  }
  // Records of all corners, whichever of the others are known.
  for (unsigned corner = 0; corner < HexForm::Corners; ++corner)
  {
    for (unsigned known = 0; known < 256; ++known)
    {
      const auto getVertex = [&](unsigned local)
      { return local != corner && (known >> local & 1) != 0 ? Vertex{ local } : NoVertex; };
      CellRecord plain, hexahedral;
      const auto near = FillRecord(plain, form.Graph, corner, getVertex);
      EXPECT_EQ(near, FillHexRecord(hexahedral, corner, getVertex));
      EXPECT_EQ(plain.Known, hexahedral.Known);
    }
  }
}

TEST(PolygonWalk, TellsWhereAllCellsAreHexahedra)
{
  EXPECT_EQ(ExpectWalk(MakeHexes(4, 0.1)).Connectivity[0], 9);
  const auto addSome = [](TestCells& mesh, std::span<const std::uint32_t> c, std::size_t number) {
    number % 5 == 0 ? AddWedges(mesh, c, number) : mesh.Add(12, { c.begin(), c.end() });
  };
  EXPECT_EQ(ExpectWalk(SplitHexes(4, 0.1, addSome)).Connectivity[0], 1);

  // A table without their form.
  const auto chunk = MakeCellCase(MakeHexes(2, 0));
  const auto encoded = ExpectRoundTrip(chunk, MakeShapes(chunk.Cells));
  ASSERT_EQ(encoded.Connectivity[0], 9);
  EXPECT_THROW(
    DecodeCells(chunk.Frame, MakeShapes({}), encoded.Connectivity, encoded.Geometry), Error);
}

TEST(PolygonWalk, FindsCellsThatAreFacesOfOthers)
{
  // The sides of a grid as cells of different types, in different directions, some of them twice.
  const auto bare = MakeHexes(10, 0.1);
  const auto count = ExpectWalk(bare).Connectivity.size();
  for (const auto& types : { Ids{ 9 }, { 8, 9, 7 } })
  {
    auto mesh = bare;
    std::size_t faces = 0;
    const auto id = [](int x, int y, int z)
    { return static_cast<std::uint32_t>((z * 11 + y) * 11 + x); };
    for (int a = 0; a < 10; ++a)
    {
      for (int b = 0; b < 10; ++b, faces += 2)
      {
        const auto type = types[static_cast<std::size_t>(a + b) % types.size()];
        Ids low{ id(a, b, 0), id(a + 1, b, 0), id(a + 1, b + 1, 0), id(a, b + 1, 0) };
        Ids high{ id(10, a, b), id(10, a + 1, b), id(10, a + 1, b + 1), id(10, a, b + 1) };
        if (types.size() > 1)
        {
          std::rotate(low.begin(), low.begin() + (a + 2 * b) % 4, low.end());
          std::reverse(high.begin(), high.begin() + (b % 2) * 4);
        }
        for (auto* face : { &low, &high })
        {
          if (type == 8)
          {
            std::swap((*face)[2], (*face)[3]);
          }
          mesh.Add(static_cast<int>(type), *face);
        }
      }
    }
    mesh.Add(9, { 0, 1, 12, 11 });
    mesh.Add(9, { 500, 501, 512, 511 }); // not at the border
    mesh.Add(5, { 0, 1, 12 });
    const auto chunk = MakeCellCase(mesh);
    const auto encoded = ExpectRoundTrip(chunk, MakeShapes(chunk.Cells));
    EXPECT_EQ(encoded.Connectivity[0] & 11, 11); // over hexahedra, with marks
    const auto bits = 8.0 * static_cast<double>(encoded.Connectivity.size() - count);
    EXPECT_LT(bits, (types.size() > 1 ? 8.0 : 2.0) * static_cast<double>(faces) + 3 * 30);
    ExpectRoundTrip(MakeCellCase(mesh, { .IsShared = IsLeft }), MakeShapes(mesh.Cells));
    ExpectSafe(mesh);
  }
}

TEST(PolygonWalk, TakesNoLessThanTheInformation)
{
  // Which cells of a grid are missing takes so many bits at least.
  std::mt19937 random(9);
  std::bernoulli_distribution missing(0.1);
  const auto mesh = MakeHexes(24, 0, [&](int, int, int) { return !missing(random); });
  const auto encoded = ExpectWalk(mesh);
  const double bits = -(0.1 * std::log2(0.1) + 0.9 * std::log2(0.9)) / 0.9;
  EXPECT_GT(GetBits(encoded.Connectivity, encoded), bits);
  EXPECT_LT(GetBits(encoded.Connectivity, encoded), 8 * bits);
}

TEST(PolygonWalk, KeepsHangingNodes)
{
  // Small hexahedra beside large ones.
  auto mesh = MakeHexes(8, 0, [](int x, int, int) { return x < 4; });
  const auto small = MakeHexes(16, 0, [](int x, int, int) { return x >= 8; });
  std::vector<std::uint32_t> ids;
  for (const auto& point : small.Points)
  {
    const std::array place{ point[0] / 2, point[1] / 2, point[2] / 2 };
    const auto found = std::find(mesh.Points.begin(), mesh.Points.end(), place);
    ids.push_back(found != mesh.Points.end()
        ? static_cast<std::uint32_t>(found - mesh.Points.begin())
        : mesh.AddPoint(place[0], place[1], place[2]));
  }
  for (std::size_t c = 0; c < small.Cells.GetNumber(); ++c)
  {
    Ids corners;
    for (const auto corner : small.Cells.GetCorners(c))
    {
      corners.push_back(ids[corner]);
    }
    mesh.Add(12, corners);
  }
  ExpectWalk(mesh);
}

TEST(PolygonWalk, KeepsEveryOrderOfCorners)
{
  // All ways to number a hexahedron, half of which turn it inside out.
  std::vector<Ids> orders;
  Ids order{ 0, 1, 2, 3, 4, 5, 6, 7 };
  for (const bool mirrored : { false, true })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int turn = 0; turn < 4; ++turn)
      {
        orders.push_back(order);
        order = { order[1], order[2], order[3], order[0], order[5], order[6], order[7], order[4] };
      }
      order = { order[0], order[4], order[5], order[1], order[3], order[7], order[6], order[2] };
    }
    order = { 4, 5, 6, 7, 0, 1, 2, 3 };
    orders.push_back(mirrored ? Ids{ 0, 1, 2, 3, 4, 5, 6, 7 } : order);
  }
  std::mt19937 random(3);
  ExpectWalk(SplitHexes(6, 0.1,
    [&](TestCells& mesh, std::span<const std::uint32_t> c, std::size_t)
    {
      const auto& turned = orders[random() % orders.size()];
      Ids corners;
      for (const auto corner : turned)
      {
        corners.push_back(c[corner]);
      }
      mesh.Add(12, corners);
    }));
}

TEST(PolygonWalk, KeepsPolyhedraTurnedInsideOut)
{
  std::mt19937 random(3);
  for (const bool whole : { true, false })
  {
    // Either all faces of some cells are turned, or any: such cells are not closed.
    const auto mesh = SplitHexes(5, 0.1,
      [&](TestCells& out, std::span<const std::uint32_t> c, std::size_t)
      {
        auto faces = GetHexFaces(c);
        const bool turned = random() % 2 != 0;
        for (auto& face : faces)
        {
          if (whole ? turned : random() % 9 == 0)
          {
            std::reverse(face.begin(), face.end());
          }
        }
        out.AddPolyhedron({ c.begin(), c.end() }, faces);
      });
    ExpectWalk(mesh);
  }
}

TEST(PolygonWalk, KeepsPolyhedraOfManyShapes)
{
  // Hexahedra whose faces may be cut along either diagonal, as the neighbor's are.
  const auto cut = [](TestCells& mesh, std::span<const std::uint32_t> c, std::size_t number)
  {
    Faces faces;
    for (const auto& face : GetHexFaces(c))
    {
      auto sorted = face;
      std::sort(sorted.begin(), sorted.end());
      const auto way = std::mt19937(sorted[0] * 7919 + sorted[3] * 31 + sorted[1])() % 3;
      const auto first =
        static_cast<std::size_t>(std::find(face.begin(), face.end(), sorted[0]) - face.begin());
      const auto at = [&](std::size_t i) { return face[(first + i) % 4]; };
      if (way == 0)
      {
        faces.push_back(face);
      }
      else
      {
        const auto one = way - 1;
        faces.push_back({ at(one), at(one + 1), at(one + 2) });
        faces.push_back({ at(one + 2), at(one + 3), at(one) });
      }
    }
    std::shuffle(faces.begin(), faces.end(), std::mt19937(static_cast<unsigned>(number)));
    mesh.AddPolyhedron({ c.begin(), c.end() }, faces);
  };
  auto mesh = SplitHexes(10, 0.1, cut);
  const auto encoded = ExpectWalk(mesh);
  // Which way each of three faces a cell is cut takes log2(3) bits at least.
  EXPECT_GT(GetBits(encoded.Connectivity, encoded), 3 * std::log2(3.0) - 0.5);
  EXPECT_LT(GetBits(encoded.Connectivity, encoded), 60);
  ShuffleCells(mesh);
  ExpectWalk(mesh, { .Type = ScalarType::Float32, .IsShared = IsLeft });
  ExpectSafe(SplitHexes(5, 0.1, cut));
}

TEST(PolygonWalk, KeepsCellsThatAreThereTwice)
{
  auto mesh = MakeHexes(5, 0.1);
  for (std::size_t c = 0; c < 125; c += 3)
  {
    const auto corners = mesh.Cells.GetCorners(c);
    const Ids again(corners.begin(), corners.end());
    mesh.Add(12, again);
    mesh.Add(static_cast<int>(c % 20), again);
    mesh.Add(
      12, { again[0], again[1], again[1], again[3], again[4], again[5], again[5], again[7] });
  }
  ExpectWalk(mesh);
  ShuffleCells(mesh);
  ExpectWalk(mesh, { .IsShared = IsLeft });
}

TEST(PolygonWalk, KeepsCellsWithAnyCornersInCommon)
{
  std::mt19937 random(8);
  for (const std::uint32_t points : { 9u, 12u, 40u, 3000u })
  {
    auto mesh = MakePoints(points);
    Ids ids(points);
    for (std::uint32_t i = 0; i < points; ++i)
    {
      ids[i] = i;
    }
    for (int i = 0; i < 400; ++i)
    {
      std::shuffle(ids.begin(), ids.end(), random);
      const int type = 10 + static_cast<int>(random() % 5);
      mesh.Add(type, { ids.begin(), ids.begin() + GetCellKind(type).Points });
    }
    const auto chunk = MakeCellCase(mesh, { .IsShared = [](const auto& p) { return p[1] < 0; } });
    ExpectRoundTrip(chunk, MakeShapes(chunk.Cells));
  }
}

TEST(PolygonWalk, RejectsDamagedStreams)
{
  ExpectSafe(MakeHexes(6, 0.1));
  ExpectSafe(SplitHexes(6, 0.1, AddMixed));
  auto zoo = MakeZoo(60, 120, 1);
  for (std::uint32_t i = 0; i + 8 < 60; ++i)
  {
    zoo.Add(12, { i, i + 1, i + 2, i + 3, i + 4, i + 5, i + 6, i + 7 });
  }
  ExpectSafe(zoo);
}

//------------------------------------------------------------------------------
TEST(ShapeTable, DoesNotDependOnParts)
{
  const auto mesh = SplitHexes(6, 0, AddMixed);
  const auto comb = MakeHoneycomb(4, true);
  ShapeTable all;
  all.Add(mesh.Cells);
  all.Add(comb.Cells);
  ShapeTable one;
  one.Add(comb.Cells);
  ShapeTable other;
  other.Add(mesh.Cells);
  one.Merge(other);
  EXPECT_EQ(one.Write(), all.Write());
  EXPECT_GT(all.Write().size(), 30u);
}

TEST(ShapeTable, FindsAllForms)
{
  const auto countForms = [](int type)
  {
    TestCells mesh = MakePoints(12);
    for (int i = 0; i < 9; ++i)
    {
      mesh.Add(type, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 });
    }
    return MakeShapes(mesh.Cells).GetForms()->GetSize();
  };
  EXPECT_EQ(countForms(10), 1u); // a tetrahedron looks the same from everywhere
  EXPECT_EQ(countForms(12), 1u); // as a hexahedron does
  EXPECT_EQ(countForms(14), 4u); // the base, and three starts of a triangle
  EXPECT_EQ(countForms(13), 3u); // a triangle, and two starts of a quadrilateral
  EXPECT_EQ(countForms(16), 3u);
}

TEST(ShapeTable, LeavesOutRareShapes)
{
  EXPECT_EQ(ShapeTable().GetForms()->GetSize(), 0u);
  auto mesh = MakePoints(8);
  mesh.Add(12, { 0, 1, 2, 3, 4, 5, 6, 7 });
  EXPECT_EQ(MakeShapes(mesh.Cells).GetForms()->GetSize(), 0u);
}

TEST(ShapeTable, RejectsDamagedBytes)
{
  ShapeTable table;
  table.Add(SplitHexes(6, 0, AddMixed).Cells);
  table.Add(MakeHoneycomb(4, true).Cells);
  const auto bytes = table.Write();
  EXPECT_EQ(ShapeTable::Read(bytes).GetForms()->GetSize(), table.GetForms()->GetSize());
  std::mt19937 random(1);
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    for (int value = 0; value < 20; ++value)
    {
      auto damaged = bytes;
      damaged[i] = static_cast<std::uint8_t>(value < 12 ? value : random() % 256);
      ExpectCorrupt([&] { ShapeTable::Read(damaged); });
    }
    EXPECT_THROW(ShapeTable::Read(std::span(bytes).first(i)), Error);
  }
  auto twice = bytes;
  ByteWriter out;
  out.PutVarint(2);
  for (int i = 0; i < 2; ++i)
  {
    out.PutBytes(std::span(bytes).subspan(1, 1u + bytes[1]));
  }
  EXPECT_THROW(ShapeTable::Read(out.Data), Error);
}
