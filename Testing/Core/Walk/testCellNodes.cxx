// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The nodes of nonlinear cells.

#include "gatunWalkSamples.h"

#include "gatunCellNodes.h"
#include "gatunEntropy.h"
#include "gatunNumberModel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace
{
using namespace gatun;
using namespace gatun::test;

using Point = std::array<double, 3>;

/** Where a node of a cell of any order is if the cell is straight: its corners' shape functions. */
Point Interpolate(const TestCells& mesh, std::span<const std::uint32_t> corners, int linearType,
  const CellNode& node, double order)
{
  const double i = node.Place[0] / order, j = node.Place[1] / order, k = node.Place[2] / order;
  std::vector<double> weights;
  switch (linearType)
  {
    case 5:
      weights = { 1 - i - j, i, j };
      break;
    case 9:
      weights = { (1 - i) * (1 - j), i * (1 - j), i * j, (1 - i) * j };
      break;
    case 10:
      weights = { 1 - i - j - k, i, j, k };
      break;
    case 12:
      weights = { (1 - i) * (1 - j) * (1 - k), i * (1 - j) * (1 - k), i * j * (1 - k),
        (1 - i) * j * (1 - k), (1 - i) * (1 - j) * k, i * (1 - j) * k, i * j * k, (1 - i) * j * k };
      break;
    default:
      weights = { (1 - i - j) * (1 - k), i * (1 - k), j * (1 - k), (1 - i - j) * k, i * k, j * k };
  }
  Point sum{ 0, 0, 0 };
  for (std::size_t c = 0; c < weights.size(); ++c)
  {
    for (unsigned a = 0; a < 3; ++a)
    {
      sum[a] += weights[c] * mesh.Points[corners[c]][a];
    }
  }
  return sum;
}

/** A type, and the order of its cells if it has any. */
struct Kind
{
  int Type;
  unsigned Order = 0;
};

/**
 * Replaces linear cells by nonlinear ones, with nodes that are moved by up to jitter. getKind(type,
 * number) tells which one a cell becomes. Cells have nodes in common that lie between the same
 * corners.
 */
template <typename GetKind>
TestCells AddNodes(const TestCells& linear, GetKind&& getKind, double jitter)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  TestCells mesh;
  mesh.Points = linear.Points;
  std::map<std::set<std::pair<std::uint32_t, unsigned>>, std::uint32_t> found;
  for (std::size_t c = 0; c < linear.Cells.GetNumber(); ++c)
  {
    const auto corners = linear.Cells.GetCorners(c);
    const Kind kind = getKind(int{ linear.Cells.Types[c] }, c);
    const auto& nodes =
      kind.Order > 0 ? GetNodesOfOrder(kind.Type, kind.Order) : GetCellNodes(kind.Type);
    Ids points(corners.begin(), corners.end());
    points.resize(std::max(points.size(), nodes.Points));
    for (const auto& node : nodes.Nodes)
    {
      std::set<std::pair<std::uint32_t, unsigned>> host;
      Point mean{ 0, 0, 0 };
      double sum = 0;
      for (unsigned i = 0; i < 4 && node.Host[i] != CellNode::None; ++i)
      {
        host.insert({ corners[node.Host[i]], node.Weights[i] });
        sum += node.Weights[i];
        for (unsigned a = 0; a < 3; ++a)
        {
          mean[a] += node.Weights[i] * mesh.Points[corners[node.Host[i]]][a];
        }
      }
      for (auto& x : mean)
      {
        x /= sum;
      }
      if (host.empty())
      {
        mean = Interpolate(mesh, corners, linear.Cells.Types[c], node, kind.Order);
      }
      if (host.empty() || found.count(host) == 0)
      {
        const double x = move(random), y = move(random), z = move(random);
        points[node.Point] = mesh.AddPoint(mean[0] + x, mean[1] + y, mean[2] + z);
        found[host] = points[node.Point];
      }
      else
      {
        points[node.Point] = found[host];
      }
    }
    mesh.Add(kind.Type, points);
  }
  return mesh;
}

TestCells AddNodesOf(const TestCells& linear, const Kind& kind, double jitter)
{
  return AddNodes(
    linear, [&](int, std::size_t) { return kind; }, jitter);
}

/** Moves points by a smooth function. */
void Bend(TestCells& mesh)
{
  for (auto& p : mesh.Points)
  {
    p = { p[0] + 0.2 * std::sin(p[1]), p[1] + 0.2 * std::sin(p[2]), p[2] + 0.2 * std::sin(p[0]) };
  }
}

/** The bits for each vertex that one mesh has more than another one. */
double GetNodeBits(const EncodedCells& nonlinear, const EncodedCells& linear)
{
  const auto bits = [](const EncodedCells& mesh)
  { return 8.0 * static_cast<double>(mesh.Geometry.size() + mesh.Connectivity.size()); };
  return (bits(nonlinear) - bits(linear)) /
    static_cast<double>(nonlinear.OwnOrder.size() - linear.OwnOrder.size());
}

/** The linear cells that have the corners of Lagrange and Bezier cells. */
TestCells MakeLinear(int type, int n, double jitter)
{
  switch (type)
  {
    case 71:
    case 78:
      return SplitHexes(n, jitter, AddTets);
    case 73:
    case 80:
      return SplitHexes(n, jitter, AddWedges);
    default:
      return MakeHexes(n, jitter);
  }
}
}

//------------------------------------------------------------------------------
TEST(CellNodes, AreKeptOfQuadraticCells)
{
  const auto hexes = MakeHexes(6, 0.1);
  const auto wedges = SplitHexes(6, 0.1, AddWedges);
  const auto tets = SplitHexes(6, 0.1, AddTets);
  const auto pyramids = SplitHexes(4, 0.1, AddPyramids);
  for (const double jitter : { 0.0, 0.03 })
  {
    for (const auto& [linear, type] : std::vector<std::pair<const TestCells*, int>>{ { &hexes, 25 },
           { &hexes, 29 }, { &hexes, 33 }, { &wedges, 26 }, { &wedges, 31 }, { &wedges, 32 },
           { &tets, 24 }, { &pyramids, 27 }, { &pyramids, 37 } })
    {
      SCOPED_TRACE(type);
      const auto mesh = AddNodesOf(*linear, { type }, jitter);
      ExpectWalk(mesh);
      ExpectWalk(mesh, { .Palettes = true, .IsShared = IsLeft });
    }
  }
}

TEST(CellNodes, AreFoundByTheirCorners)
{
  // Nodes in the middle of edges take next to nothing, neither for their numbers nor their places.
  const auto linear = MakeHexes(12, 0.2);
  const auto plain = ExpectWalk(linear);
  const auto curved = ExpectWalk(AddNodesOf(linear, { 29 }, 0));
  EXPECT_LT(GetBits(curved.Connectivity, curved), GetBits(plain.Connectivity, plain) + 0.5);
  EXPECT_LT(GetNodeBits(curved, plain), 8);
}

TEST(CellNodes, AreKeptOfEveryOrder)
{
  for (const int type : { 71, 72, 73, 78, 79, 80 })
  {
    const auto linear = MakeLinear(type, 3, 0.1);
    for (const unsigned order : { 1u, 2u, 3u, 5u })
    {
      SCOPED_TRACE(std::to_string(type) + " of order " + std::to_string(order));
      for (const double jitter : { 0.0, 0.01 })
      {
        auto mesh = AddNodesOf(linear, { type, order }, jitter);
        ExpectWalk(mesh, { .IsShared = IsLeft });
        ShuffleCells(mesh);
        ExpectWalk(mesh, { .Type = ScalarType::Float32 });
      }
    }
  }
}

TEST(CellNodes, AreKeptOfTheHighestOrder)
{
  for (const int type : { 71, 72, 73 })
  {
    auto mesh = AddNodesOf(MakeLinear(type, 1, 0.1), { type, MaxNodeOrder }, 0);
    const auto more = AddNodesOf(MakeLinear(type, 2, 0.1), { type, 1 }, 0);
    const auto first = static_cast<std::uint32_t>(mesh.Points.size());
    mesh.Points.insert(mesh.Points.end(), more.Points.begin(), more.Points.end());
    for (std::size_t c = 0; c < more.Cells.GetNumber(); ++c)
    {
      Ids corners;
      for (const auto v : more.Cells.GetCorners(c))
      {
        corners.push_back(first + v);
      }
      mesh.Add(type, corners);
    }
    ExpectWalk(mesh);
  }
}

TEST(CellNodes, AreKeptOfOrdersThatDiffer)
{
  std::mt19937 random(2);
  const auto hexes = AddNodes(
    MakeHexes(5, 0.1),
    [&](int, std::size_t)
    {
      const std::vector<Kind> kinds{ { 72, 1 }, { 72, 2 }, { 79, 2 }, { 72, 3 }, { 79, 4 }, { 29 },
        { 25 }, { 12 } };
      return kinds[random() % kinds.size()];
    },
    0.01);
  ExpectWalk(hexes, { .IsShared = IsLeft });
  const auto linear = SplitHexes(6, 0.1,
    [](TestCells& mesh, std::span<const std::uint32_t> c, std::size_t number) {
      number / 36 % 2 == 0 ? AddWedges(mesh, c, number) : mesh.Add(12, { c.begin(), c.end() });
    });
  const auto mixed = AddNodes(
    linear,
    [](int type, std::size_t) {
      return type == 13 ? Kind{ 73, 3 } : Kind{ 72, 3 };
    },
    0);
  const auto plain = ExpectWalk(linear);
  const auto encoded = ExpectWalk(mixed);
  // Hexahedra and wedges have the nodes of common faces in common.
  std::set<std::uint32_t> used(mixed.Cells.Corners.begin(), mixed.Cells.Corners.end());
  EXPECT_EQ(used.size(), mixed.Points.size());
  EXPECT_LT(GetBits(encoded.Connectivity, encoded), GetBits(plain.Connectivity, plain) + 4);
}

TEST(CellNodes, OfStraightCellsTakeNothing)
{
  for (const int type : { 71, 72, 73 })
  {
    // Corners from which all nodes of these orders are computed without rounding.
    auto linear = MakeLinear(type, 6, 0.15);
    for (auto& point : linear.Points)
    {
      for (auto& x : point)
      {
        x = std::floor(1024 * x) / 1024;
      }
    }
    const auto plain = ExpectWalk(linear);
    for (const unsigned order : { 2u, 4u })
    {
      SCOPED_TRACE(std::to_string(type) + " of order " + std::to_string(order));
      const auto nodes = ExpectWalk(AddNodesOf(linear, { type, order }, 0));
      EXPECT_LT(GetBits(nodes.Connectivity, nodes), GetBits(plain.Connectivity, plain) + order);
      EXPECT_LT(GetNodeBits(nodes, plain), 1.5);
    }
  }
}

TEST(CellNodes, OfCurvedCellsTakeLessThanThoseOfCells)
{
  for (const unsigned order : { 2u, 3u, 4u })
  {
    // The list has no nodes of cells whose number of points no order has.
    auto mesh = AddNodesOf(MakeHexes(6, 0), { 72, order }, 0);
    Bend(mesh);
    auto other = mesh;
    std::fill(other.Cells.Types.begin(), other.Cells.Types.end(), std::uint8_t{ 67 });
    const auto encoded = ExpectWalk(mesh);
    const auto listed = ExpectRoundTrip(MakeCellCase(other));
    EXPECT_LT(10 * encoded.Connectivity.size(), listed.Connectivity.size());
    EXPECT_LT(encoded.Geometry.size(), listed.Geometry.size());
  }
}

TEST(CellNodes, OfNoOrderAreKept)
{
  // Among others: of different orders in different directions, VTK's wedge of 21 points, orders
  // above the highest one, and pyramids.
  auto mesh = MakePoints(400);
  std::mt19937 random(5);
  for (const int type : { 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81 })
  {
    const auto least = GetCellKind(type).Shape ? GetCellKind(type).Shape->Corners : 2u;
    for (const unsigned size :
      { 2u, 3u, 4u, 5u, 8u, 9u, 12u, 17u, 18u, 19u, 21u, 153u, 171u, 289u, 324u })
    {
      for (int i = 0; i < 3 && size >= least; ++i)
      {
        Ids ids(400);
        std::iota(ids.begin(), ids.end(), 0u);
        std::shuffle(ids.begin(), ids.end(), random);
        ids.resize(size);
        mesh.Add(type, ids);
      }
    }
  }
  const auto chunk = MakeCellCase(mesh, { .IsShared = [](const auto& p) { return p[1] < 0; } });
  ExpectRoundTrip(chunk, MakeShapes(chunk.Cells));
  ExpectRoundTrip(chunk);
  ExpectSafe(mesh);
}

TEST(CellNodes, AreThoseOfFacesThatAreCells)
{
  // The bottom of a grid, whose nodes are in its cells.
  for (const unsigned order : { 2u, 3u })
  {
    auto linear = MakeHexes(6, 0.1);
    const auto solids = linear.Cells.GetNumber();
    for (std::size_t c = 0; c < 36; ++c)
    {
      const auto corners = linear.Cells.GetCorners(c);
      Ids face{ corners[0], corners[3], corners[2], corners[1] };
      std::rotate(face.begin(), face.begin() + c % 4, face.end());
      linear.Add(9, face);
    }
    // The nodes of faces that are not symmetric are between corners with other weights.
    const auto mesh = AddNodes(
      linear,
      [&](int type, std::size_t) {
        return type == 12 ? Kind{ 72, order } : Kind{ 70, order };
      },
      0.01);
    const auto encoded = ExpectWalk(mesh, { .IsShared = IsLeft });
    EXPECT_EQ(encoded.Connectivity[0] & 3, 3);
    auto bare = mesh;
    bare.Cells.Types.resize(solids);
    bare.Cells.Corners.resize(bare.Cells.Starts[solids]);
    bare.Cells.Starts.resize(solids + 1);
    const auto count = ExpectWalk(bare, { .IsShared = IsLeft }).Connectivity.size();
    EXPECT_LT(encoded.Connectivity.size(), count + 60);
    ExpectSafe(mesh);
  }
}

TEST(CellNodes, AreKeptOnSurfaces)
{
  for (const int type : { 69, 70, 76, 77 })
  {
    const bool isTriangle = type == 69 || type == 76;
    TestCells linear;
    constexpr std::uint32_t n = 12;
    for (std::uint32_t p = 0; p < (n + 1) * (n + 1); ++p)
    {
      linear.AddPoint(p % (n + 1), p / (n + 1), 0.1 * std::sin(p));
    }
    for (std::uint32_t c = 0; c < n * n; ++c)
    {
      const auto a = c / n * (n + 1) + c % n;
      const Ids quad{ a, a + 1, a + n + 2, a + n + 1 };
      if (isTriangle)
      {
        linear.Add(5, { quad[0], quad[1], quad[2] });
        linear.Add(5, { quad[2], quad[3], quad[0] });
      }
      else
      {
        linear.Add(9, quad);
      }
    }
    for (const unsigned order : { 1u, 2u, 3u, 5u })
    {
      const auto chunk =
        MakeCellCase(AddNodesOf(linear, { type, order }, 0.01), { .IsShared = IsLeft });
      const auto encoded = ExpectRoundTrip(chunk);
      EXPECT_EQ(encoded.Connectivity[0], 4);
    }
    ExpectSafe(AddNodesOf(linear, { type, 3 }, 0.01));
  }
}

TEST(CellNodes, OfDamagedStreamsAreRejected)
{
  for (const int type : { 71, 72, 73 })
  {
    std::mt19937 random(3);
    ExpectSafe(AddNodes(
      MakeLinear(type, 3, 0.1),
      [&](int, std::size_t) {
        return Kind{ type, 1 + static_cast<unsigned>(random() % 4) };
      },
      0.01));
  }
}

TEST(CellNodes, HaveAnOrderWithinLimits)
{
  // A hexahedron by a stream that is written by hand.
  auto mesh = MakeHexes(1, 0, {}, 12);
  mesh.Cells.Types[0] = 72;
  const auto shapes = MakeShapes(MakeHexes(3, 0).Cells);
  const auto chunk = MakeCellCase(mesh);
  const auto geometry =
    EncodeCells(chunk.Frame, chunk.Cells, shapes, chunk.OwnKeys, false).Geometry;
  const auto decode = [&](unsigned order)
  {
    EntropyEncoder coder;
    BitModel more, isNew, isShared, sameOrder;
    coder.Bit(more, true);
    for (int corner = 0; corner < 8; ++corner)
    {
      coder.Bit(isNew, true);
      coder.Bit(isShared, false);
    }
    BitTree<8>().Code(coder, 72);
    BitTree<8>().Code(coder, 0); // the frame
    coder.Bit(sameOrder, false);
    NumberModel().Code(coder, order);
    Bytes stream{ 9 };
    const auto rest = coder.Finish();
    stream.insert(stream.end(), rest.begin(), rest.end());
    stream.resize(stream.size() + 20, 0);
    return DecodeCells(chunk.Frame, shapes, stream, geometry);
  };
  EXPECT_EQ(decode(1).Cells.Corners.size(), 8u);
  for (const unsigned order : { 0u, 2u, 16u, 17u, 255u, 256u, 257u, ~0u })
  {
    EXPECT_THROW(decode(order), Error) << order; // an impossible order, or too many points
  }
}

TEST(CellNodes, AreNamedInTheOrderOfTheirNeighbors)
{
  for (int type = 68; type <= 80; ++type)
  {
    for (unsigned order = 1; HasNodeOrder(type) && order <= MaxNodeOrder; ++order)
    {
      const auto& nodes = GetNodesOfOrder(type, order);
      EXPECT_EQ(FindNodeOrder(type, nodes.Points), order);
      std::vector<char> known(nodes.Points, 0);
      std::fill_n(known.begin(), nodes.Corners, char{ 1 });
      for (const auto& node : nodes.Nodes)
      {
        for (const auto near : node.Near)
        {
          EXPECT_TRUE(near == CellNode::None || known.at(near) != 0);
        }
        EXPECT_EQ(known.at(node.Point)++, 0);
      }
      EXPECT_EQ(std::count(known.begin(), known.end(), char{ 1 }),
        static_cast<std::ptrdiff_t>(nodes.Points));
    }
  }
  EXPECT_EQ(FindNodeOrder(74, 5), 0u);
  EXPECT_EQ(FindNodeOrder(72, 18 * 18 * 18), 0u);
  EXPECT_EQ(FindNodeOrder(73, 21), 0u);
}
