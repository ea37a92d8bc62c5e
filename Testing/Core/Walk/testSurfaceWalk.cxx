// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunTestCells.h"
#include "gatunWalkSamples.h"

#include "gatunError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr std::uint8_t SurfaceFlag = 4;

EncodedCells ExpectSurfaceWalk(const TestCells& mesh, const CellCaseOptions& options = {})
{
  const auto chunk = MakeCellCase(mesh, options);
  auto encoded = ExpectRoundTrip(chunk, MakeShapes(chunk.Cells));
  EXPECT_EQ(encoded.Connectivity[0] & SurfaceFlag, SurfaceFlag);
  return encoded;
}

double GetConnectivityBits(const TestCells& mesh)
{
  const auto encoded = ExpectSurfaceWalk(mesh);
  return GetBits(encoded.Connectivity, encoded);
}

/** Adds the cells of a quadrilateral of four points in a cycle. */
using AddQuad = std::function<void(TestCells&, const Ids&)>;

void AddPixel(TestCells& mesh, const Ids& c)
{
  mesh.Add(8, { c[0], c[1], c[3], c[2] });
}

void AddTriangles(TestCells& mesh, const Ids& c)
{
  mesh.Add(5, { c[0], c[1], c[2] });
  mesh.Add(5, { c[0], c[2], c[3] });
}

AddQuad AddType(int type)
{
  return [type](TestCells& mesh, const Ids& c) { mesh.Add(type, c); };
}

/** Quads, pixels, triangles and polygons, split along either diagonal. */
AddQuad AddAny(unsigned seed)
{
  return [random = std::mt19937(seed)](TestCells& mesh, Ids c) mutable
  {
    std::rotate(c.begin(), c.begin() + random() % 4, c.end());
    switch (random() % 4)
    {
      case 0:
        AddPixel(mesh, c);
        break;
      case 1:
        mesh.Add(7, c);
        break;
      case 2:
        mesh.Add(9, c);
        break;
      default:
        AddTriangles(mesh, c);
    }
  };
}

/** Two triangles that begin with any of their corners. */
AddQuad AddAtRandom(unsigned seed)
{
  return [random = std::mt19937(seed)](TestCells& mesh, const Ids& c) mutable
  {
    for (Ids triangle : { Ids{ c[0], c[1], c[2] }, Ids{ c[0], c[2], c[3] } })
    {
      std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
      mesh.Add(5, triangle);
    }
  };
}

struct GridOptions
{
  double Jitter = 0;
  bool Closed = false;  // around the first axis
  bool Twisted = false; // a Moebius strip, if it is closed
  double Height = 0;    // of waves
};

/** A grid of n * m quadrilaterals. */
TestCells MakeGrid(int n, int m, const AddQuad& add, const GridOptions& options = {})
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-options.Jitter, options.Jitter);
  TestCells mesh;
  for (int y = 0; y <= m; ++y)
  {
    for (int x = 0; x < n + !options.Closed; ++x)
    {
      const double dx = move(random), dy = move(random);
      const double z = options.Height * std::sin(x * 0.5) * std::cos(y * 0.4);
      if (!options.Closed)
      {
        mesh.AddPoint(x + dx, y + dy, z);
        continue;
      }
      const double turn = 2 * 3.14159265358979 * (x + dx) / n;
      const double tilt = options.Twisted ? turn / 2 : 0;
      const double radius = n + (y - m / 2.0 + dy) * std::cos(tilt);
      mesh.AddPoint(radius * std::cos(turn), radius * std::sin(turn),
        (y - m / 2.0) * std::sin(tilt) + (options.Twisted ? 0 : y + z));
    }
  }
  const auto id = [&](int x, int y)
  {
    const bool around = options.Closed && x == n;
    return static_cast<std::uint32_t>(
      (around && options.Twisted ? m - y : y) * (n + !options.Closed) + (around ? 0 : x));
  };
  for (int y = 0; y < m; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      add(mesh, { id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1) });
    }
  }
  return mesh;
}

/** Triangles whose points have very different numbers of neighbors: random edges of a grid are
 * turned to the other diagonal. */
TestCells MakeIrregular(int n, unsigned flips)
{
  auto grid = MakeGrid(n, n, AddTriangles, { .Jitter = 0.2 });
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t c = 0; c < grid.Cells.GetNumber(); ++c)
  {
    const auto t = grid.Cells.GetCorners(c);
    triangles.push_back({ t[0], t[1], t[2] });
  }
  std::mt19937 random(7);
  const auto area = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const auto &p = grid.Points[a], &q = grid.Points[b], &r = grid.Points[c];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  std::map<std::array<std::uint32_t, 2>, std::size_t> sides;
  const auto addSides = [&](std::size_t t)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      sides[{ triangles[t][i], triangles[t][(i + 1) % 3] }] = t;
    }
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    addSides(t);
  }
  for (unsigned i = 0; i < flips; ++i)
  {
    const auto t = random() % triangles.size();
    const auto turn = random() % 3;
    const auto a = triangles[t][turn], b = triangles[t][(turn + 1) % 3];
    const auto c = triangles[t][(turn + 2) % 3];
    const auto twin = sides.find({ b, a });
    if (twin == sides.end())
    {
      continue;
    }
    const auto u = twin->second;
    const auto d = triangles[u][0] + triangles[u][1] + triangles[u][2] - a - b;
    if (area(a, d, c) > 0.05 && area(d, b, c) > 0.05)
    {
      sides.erase({ a, b });
      sides.erase({ b, a });
      triangles[t] = { a, d, c };
      triangles[u] = { d, b, c };
      addSides(t);
      addSides(u);
    }
  }
  TestCells mesh;
  mesh.Points = grid.Points;
  for (const auto& t : triangles)
  {
    mesh.Add(5, { t[0], t[1], t[2] });
  }
  ShuffleCells(mesh);
  return mesh;
}

/** Decodes damaged streams. They must give a mesh or Error(Corrupt). */
void ExpectSafeSurface(const TestCells& mesh)
{
  const auto chunk = MakeCellCase(mesh, { .IsShared = IsLeft });
  const auto shapes = MakeShapes(chunk.Cells);
  const auto encoded = ExpectRoundTrip(chunk, shapes);
  EXPECT_EQ(encoded.Connectivity[0] & SurfaceFlag, SurfaceFlag);
  std::mt19937 random(4);
  for (unsigned i = 0; i < 400; ++i)
  {
    auto connectivity = encoded.Connectivity;
    for (auto flips = random() % 3; flips > 0; --flips)
    {
      connectivity[random() % connectivity.size()] ^= static_cast<std::uint8_t>(1 + random() % 255);
    }
    if (random() % 4 == 0)
    {
      connectivity.resize(random() % connectivity.size());
    }
    try
    {
      const auto decoded = DecodeCells(chunk.Frame, shapes, connectivity, encoded.Geometry);
      EXPECT_EQ(decoded.Cells.GetNumber(), chunk.Cells.GetNumber());
      ArrayContext(decoded, ContextFits::All);
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Corrupt);
    }
  }
}
}

//------------------------------------------------------------------------------
TEST(SurfaceWalk, KeepsGrids)
{
  for (const auto& add : { AddType(9), AddType(7), AddQuad(AddPixel), AddQuad(AddTriangles) })
  {
    auto mesh = MakeGrid(100, 100, add);
    ShuffleCells(mesh);
    EXPECT_LT(GetConnectivityBits(mesh), 0.1);
    ExpectSurfaceWalk(MakeGrid(20, 10, add), { .Palettes = true, .IsShared = IsLeft });
  }
}

TEST(SurfaceWalk, KeepsClosedAndOneSidedSurfaces)
{
  for (const bool twisted : { false, true })
  {
    for (const auto& add : { AddType(9), AddQuad(AddTriangles), AddAny(5) })
    {
      auto mesh = MakeGrid(60, 6, add, { .Jitter = 0.1, .Closed = true, .Twisted = twisted });
      ExpectSurfaceWalk(mesh);
      ShuffleCells(mesh);
      ExpectSurfaceWalk(mesh, { .Type = ScalarType::Float32, .IsShared = IsLeft });
    }
  }
}

TEST(SurfaceWalk, KeepsIrregularTriangles)
{
  const auto mesh = MakeIrregular(60, 40000);
  std::map<std::uint32_t, double> valences;
  for (const auto v : mesh.Cells.Corners)
  {
    ++valences[v];
  }
  std::map<double, double> counts;
  for (const auto& [vertex, valence] : valences)
  {
    ++counts[valence];
  }
  double entropy = 0;
  for (const auto& [valence, count] : counts)
  {
    entropy -= count * std::log2(count / static_cast<double>(valences.size()));
  }
  EXPECT_GT(entropy, 1.5 * static_cast<double>(valences.size())); // the mesh is irregular
  // The corners may begin at any of three points.
  const auto cells = static_cast<double>(mesh.Cells.GetNumber());
  EXPECT_LT(GetConnectivityBits(mesh), std::log2(3.0) + entropy / cells);
  ExpectSurfaceWalk(mesh, { .Type = ScalarType::Float32, .IsShared = IsLeft });
}

TEST(SurfaceWalk, TakesNoLessThanTheInformation)
{
  // Which triangles of a grid are turned over, and which quadrilaterals are missing.
  std::mt19937 random(9);
  const auto mesh = MakeGrid(80, 80,
    [&](TestCells& out, const Ids& c)
    {
      if (random() % 10 > 0)
      {
        const auto a = random() % 4;
        out.Add(9, { c[a], c[(a + 1) % 4], c[(a + 2) % 4], c[(a + 3) % 4] });
      }
    });
  const double bits = 2 - (0.1 * std::log2(0.1) + 0.9 * std::log2(0.9)) / 0.9;
  const auto found = GetConnectivityBits(mesh);
  EXPECT_GT(found, bits - 0.05); // quadrilaterals between missing ones cannot be seen
  EXPECT_LT(found, bits + 1.5);
}

TEST(SurfaceWalk, PredictsAsWellAsParallelograms)
{
  // On a plane that is sheared, all points but the first ones follow from three others.
  auto mesh = MakeGrid(50, 50, AddTriangles);
  for (auto& point : mesh.Points)
  {
    point = { 100 + point[0] + 0.5 * point[1], 200 + point[1], 300 + 2 * point[0] - point[1] };
  }
  ShuffleCells(mesh);
  const auto encoded = ExpectSurfaceWalk(mesh);
  EXPECT_LT(8.0 * static_cast<double>(encoded.Geometry.size()), 2.0 * 51 * 51);
}

TEST(SurfaceWalk, KeepsMixedCells)
{
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    auto mesh = MakeGrid(24, 17, AddAny(seed), { .Jitter = 0.3, .Height = 2 });
    ExpectSurfaceWalk(mesh);
    for (std::uint32_t i = 0; i < 40; ++i)
    {
      mesh.Add(3, { i, i + 30 });
      mesh.Add(1, { 3 * i });
      mesh.Add(6, { i, i + 1, i + 26, i + 27, i + 52 });
    }
    ShuffleCells(mesh);
    ExpectSurfaceWalk(mesh, { .Type = ScalarType::Float32, .IsShared = IsLeft });
  }
}

TEST(SurfaceWalk, KeepsShellsBesideAndInsideOfSolids)
{
  // Faces at the border are marked; a wall inside and a plate that stands off are walked over.
  auto mesh = MakeHexes(8, 0.1);
  const auto id = [](int x, int y, int z)
  { return static_cast<std::uint32_t>((z * 9 + y) * 9 + x); };
  std::size_t walls = 0;
  for (int a = 0; a < 8; ++a)
  {
    for (int b = 0; b < 8; ++b, ++walls)
    {
      mesh.Add(9, { id(a, b, 0), id(a + 1, b, 0), id(a + 1, b + 1, 0), id(a, b + 1, 0) });
      mesh.Add(9, { id(a, 4, b), id(a + 1, 4, b), id(a + 1, 4, b + 1), id(a, 4, b + 1) });
    }
  }
  const auto bare = ExpectSurfaceWalk(mesh).Connectivity;
  EXPECT_EQ(bare[0] & 7, 7);
  std::vector<std::uint32_t> last;
  for (int a = 0; a <= 8; ++a)
  {
    last.push_back(id(a, 8, 8));
  }
  for (int row = 0; row < 8; ++row)
  {
    for (int a = 0; a <= 8; ++a)
    {
      last.push_back(mesh.AddPoint(a, 9 + row, 8));
      if (a > 0)
      {
        const auto at = last.size() - 1;
        mesh.Add(9, { last[at - 10], last[at - 9], last[at], last[at - 1] });
      }
    }
  }
  ExpectSurfaceWalk(mesh);
  ExpectSurfaceWalk(mesh, { .IsShared = IsLeft });
  ExpectSurfaceWalk(mesh, { .IsShared = [](const std::array<double, 3>&) { return true; } });
  ExpectSafeSurface(mesh);
}

TEST(SurfaceWalk, KeepsEdgesOfManyCells)
{
  // Pages of a book: sheets that have one edge in common, and some of them twice.
  TestCells mesh;
  Ids spine;
  for (int i = 0; i <= 12; ++i)
  {
    spine.push_back(mesh.AddPoint(0, 0, i));
  }
  for (int page = 0; page < 9; ++page)
  {
    auto last = spine;
    for (int column = 1; column <= 5; ++column)
    {
      Ids next;
      for (int i = 0; i <= 12; ++i)
      {
        next.push_back(mesh.AddPoint(column * std::cos(page), column * std::sin(page), i));
      }
      for (std::size_t i = 0; i < 12; ++i)
      {
        Ids quad{ last[i], last[i + 1], next[i + 1], next[i] };
        std::rotate(quad.begin(), quad.begin() + page % 4, quad.end());
        mesh.Add(9, quad);
        if (page % 3 == 0 && i % 5 == 0)
        {
          std::reverse(quad.begin(), quad.end());
          mesh.Add(7, quad);
          mesh.Add(9, quad);
        }
      }
      last = next;
    }
  }
  ExpectSurfaceWalk(mesh);
  ShuffleCells(mesh);
  ExpectSurfaceWalk(mesh, { .IsShared = IsLeft });
  ExpectSafeSurface(mesh);
}

TEST(SurfaceWalk, KeepsCellsThatMeetInPoints)
{
  // A board of which every other square is missing, so that there are no common edges; and pairs.
  auto mesh = MakeGrid(16, 16,
    [n = 0](TestCells& out, const Ids& c) mutable
    {
      if ((n % 16 + n / 16) % 2 == 0)
      {
        n % 32 < 16 ? out.Add(9, c) : AddTriangles(out, c);
      }
      ++n;
    });
  ExpectSurfaceWalk(mesh);
  ExpectSurfaceWalk(mesh, { .IsShared = IsLeft });
}

TEST(SurfaceWalk, KeepsNodesOfNonlinearCells)
{
  const std::map<int, std::vector<std::array<std::size_t, 2>>> sides{
    { 22, { { 0, 1 }, { 1, 2 }, { 2, 0 } } }, { 23, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } } }
  };
  for (const bool centers : { false, true })
  {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> found;
    const auto mesh = MakeGrid(14, 10,
      [&](TestCells& out, const Ids& c)
      {
        const auto add = [&](int type, Ids points)
        {
          std::array<double, 3> sum{ 0, 0, 0 };
          const auto corners = points.size();
          for (const auto& [a, b] : sides.at(type))
          {
            const auto p = std::minmax(points[a], points[b]);
            auto& node = found[{ p.first, p.second }];
            if (node == 0)
            {
              const auto &u = out.Points[p.first], &v = out.Points[p.second];
              node = out.AddPoint((u[0] + v[0]) / 2, (u[1] + v[1]) / 2, (u[2] + v[2]) / 2);
            }
            points.push_back(node);
          }
          for (std::size_t i = 0; i < corners; ++i)
          {
            for (unsigned axis = 0; axis < 3; ++axis)
            {
              sum[axis] += out.Points[points[i]][axis] / static_cast<double>(corners);
            }
          }
          if (centers)
          {
            points.push_back(out.AddPoint(sum[0], sum[1], sum[2]));
          }
          out.Add(centers ? (type == 22 ? 34 : 28) : type, points);
        };
        if ((c[0] + c[0] / 15) % 2 == 0)
        {
          add(23, c);
        }
        else
        {
          add(22, { c[0], c[1], c[2] });
          add(22, { c[2], c[3], c[0] });
        }
      },
      { .Height = 1 });
    ExpectSurfaceWalk(mesh);
    ExpectSurfaceWalk(mesh, { .Palettes = true, .IsShared = IsLeft });
    ExpectSafeSurface(mesh);
  }
}

TEST(SurfaceWalk, KeepsLargePolygons)
{
  // Two polygons with a common chain, as large as the walk takes and larger, and small ones around.
  for (const std::uint32_t size : { 9u, 19u, 20u, 21u, 300u, 5000u, 33000u })
  {
    TestCells mesh;
    Ids ring;
    for (std::uint32_t i = 0; i < size; ++i)
    {
      const double turn = 6.283185307179586 * i / size;
      ring.push_back(mesh.AddPoint(std::cos(turn), std::sin(turn), 0));
    }
    mesh.Add(7, ring);
    Ids outer;
    for (std::uint32_t i = 0; i < size; ++i)
    {
      const auto& p = mesh.Points[ring[i]];
      outer.push_back(mesh.AddPoint(2 * p[0], 2 * p[1], 0));
    }
    for (std::uint32_t i = 0; i + 2 < size; i += 2)
    {
      mesh.Add(7, { ring[i], ring[i + 1], ring[i + 2], outer[i + 2], outer[i + 1], outer[i] });
    }
    std::reverse(outer.begin(), outer.end());
    mesh.Add(7, outer);
    const auto encoded = ExpectRoundTrip(MakeCellCase(mesh));
    EXPECT_EQ(encoded.Connectivity[0], size < 32768 ? SurfaceFlag : 0);
    ExpectRoundTrip(MakeCellCase(mesh, { .IsShared = [](const auto& p) { return p[0] < 0.3; } }));
  }
}

TEST(SurfaceWalk, LeavesOtherCellsToTheList)
{
  // Cells with a corner twice, of a wrong size, or without a neighbor.
  auto mesh = MakePoints(300);
  for (std::uint32_t i = 0; i + 9 < 300; i += 9)
  {
    mesh.Add(9, { i, i + 1, i + 1, i + 2 });
    mesh.Add(5, { i, i + 1, i + 2, i + 3 });
    mesh.Add(7, { i, i + 1 });
    mesh.Add(5, { i + 6, i + 7, i + 8 });
  }
  const auto encoded = ExpectRoundTrip(MakeCellCase(mesh));
  EXPECT_EQ(encoded.Connectivity[0], 0);
}

TEST(SurfaceWalk, KeepsCellsWithAnyCornersInCommon)
{
  std::mt19937 random(8);
  for (const std::uint32_t points : { 5u, 8u, 40u, 300u })
  {
    auto mesh = MakePoints(points);
    Ids ids(points);
    std::iota(ids.begin(), ids.end(), 0u);
    for (int i = 0; i < 600; ++i)
    {
      std::shuffle(ids.begin(), ids.end(), random);
      const std::array types{ 5, 7, 8, 9 };
      const auto type = types[random() % 4];
      const auto size = type == 5 ? 3u : type == 7 ? 3 + random() % 3 : 4u;
      mesh.Add(type, { ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(size) });
    }
    ExpectRoundTrip(MakeCellCase(mesh));
    ExpectRoundTrip(MakeCellCase(mesh, { .IsShared = [](const auto& p) { return p[1] < 0; } }));
  }
}

TEST(SurfaceWalk, KeepsStrangePlaces)
{
  auto mesh = MakeGrid(12, 12, AddAny(3));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  mesh.Points[30] = { infinity, -infinity, 0 };
  mesh.Points[60] = { 1e308, -1e308, 1e-310 };
  ExpectSurfaceWalk(mesh);
  for (auto& point : mesh.Points)
  {
    point = { 1, 1, 1 };
  }
  ExpectSurfaceWalk(mesh);
}

TEST(SurfaceWalk, RejectsDamagedStreams)
{
  ExpectSafeSurface(MakeGrid(20, 20, AddTriangles, { .Jitter = 0.1 }));
  ExpectSafeSurface(MakeGrid(20, 20, AddAny(1), { .Jitter = 0.1 }));
  ExpectSafeSurface(MakeGrid(40, 4, AddType(9), { .Closed = true, .Twisted = true }));
}

TEST(SurfaceWalk, FirstCornersOfTrianglesAreFree)
{
  const auto chunk = MakeCellCase(MakeGrid(40, 40, AddAtRandom(3), { 0.2 }), {});
  const auto bits = [&](bool keepCorners)
  {
    const auto encoded =
      EncodeCells(chunk.Frame, chunk.Cells, MakeShapes(chunk.Cells), chunk.OwnKeys, keepCorners);
    return GetBits(encoded.Connectivity, encoded);
  };
  EXPECT_GT(bits(true), bits(false) + 1.4); // of log2(3)
}
