// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Tetrahedra of cells: their faces fit, and their volumes are those of the cells.

#include "gatunSimplices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>

namespace gatun::test
{
namespace
{
using Tet = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;
using Place = std::array<double, 3>;
using Places = std::vector<Place>;
using Faces = std::vector<std::vector<std::uint32_t>>;

constexpr int Hexahedron = 12;
constexpr int Wedge = 13;
constexpr int Pyramid = 14;
constexpr int SplitTypes[] = { 10, 11, Hexahedron, Wedge, Pyramid, 15, 16 };

double GetVolume(const Places& points, const Tet& tet)
{
  std::array<Place, 3> edges{};
  for (unsigned i = 0; i < 3; ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      edges[i][axis] = points[tet[i + 1]][axis] - points[tet[0]][axis];
    }
  }
  const auto& [a, b, c] = edges;
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0])) /
    6;
}

Faces GetFaces(int type, const std::vector<std::uint32_t>& corners)
{
  CellFaces<std::uint32_t> faces;
  faces.Set(*GetCellKind(type).Shape, corners.data());
  Faces found;
  for (std::size_t i = 0; i < faces.GetNumber(); ++i)
  {
    const auto face = faces.Get(i);
    found.emplace_back(face.begin(), face.end());
  }
  return found;
}

/** isPolyhedron: whether the faces may have any direction. */
std::vector<Tet> Split(const Faces& cell, const Places& points, bool isPolyhedron = false)
{
  CellFaces<std::uint32_t> faces;
  for (const auto& face : cell)
  {
    faces.Add(face, [](std::uint32_t id) { return id; });
  }
  if (isPolyhedron)
  {
    faces.Align();
  }
  std::vector<Tet> tets;
  SplitSpace<std::uint32_t> space;
  SplitCell(faces, PointOrder<double>(points.front().data()), space,
    [&](const Tet& tet) { tets.push_back(tet); });
  return tets;
}

/** A triangle with its least corner first, in the same sense. */
Triangle Turn(Triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/** The triangles that are not met from both sides, and how often each is met. */
std::map<Triangle, int> FindBoundary(const std::vector<Tet>& tets)
{
  std::map<Triangle, int> met;
  for (const auto& t : tets)
  {
    for (const Triangle& face : { Triangle{ t[1], t[2], t[3] }, Triangle{ t[0], t[3], t[2] },
           Triangle{ t[0], t[1], t[3] }, Triangle{ t[0], t[2], t[1] } })
    {
      const auto other = met.find(Turn({ face[0], face[2], face[1] }));
      if (other != met.end() && other->second > 0)
      {
        other->second -= 1;
        if (other->second == 0)
        {
          met.erase(other);
        }
      }
      else
      {
        ++met[Turn(face)];
      }
    }
  }
  return met;
}

/** Cells that fill a box, of all kinds, with points inside that are moved at random. */
struct Mixture
{
  Places Points;
  std::vector<Faces> Cells;

  Mixture(std::uint32_t n, double jitter, unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> move(-jitter, jitter);
    const auto isInside = [n](std::uint32_t i) { return i > 0 && i < n; };
    for (std::uint32_t z = 0; z <= n; ++z)
    {
      for (std::uint32_t y = 0; y <= n; ++y)
      {
        for (std::uint32_t x = 0; x <= n; ++x)
        {
          this->Points.push_back({ x + (isInside(x) ? move(random) : 0),
            y + (isInside(y) ? move(random) : 0), z + (isInside(z) ? move(random) : 0) });
        }
      }
    }
    for (std::uint32_t i = 0; i < n * n * n; ++i)
    {
      // The triangles of wedges only fit those of other wedges, so that there are columns of them.
      constexpr unsigned others[] = { 0, 2, 3 };
      const Triangle at{ i % n, i / n % n, i / n / n };
      this->AddCube(at, n + 1, (at[0] + 2 * at[1]) % 4 == 1 ? 1 : others[random() % 3]);
    }
  }

  void AddCube(const Triangle& at, std::uint32_t row, unsigned kind)
  {
    std::vector<std::uint32_t> c;
    for (const auto& [x, y, z] :
      { Triangle{ 0, 0, 0 }, Triangle{ 1, 0, 0 }, Triangle{ 1, 1, 0 }, Triangle{ 0, 1, 0 },
        Triangle{ 0, 0, 1 }, Triangle{ 1, 0, 1 }, Triangle{ 1, 1, 1 }, Triangle{ 0, 1, 1 } })
    {
      c.push_back(((at[2] + z) * row + at[1] + y) * row + at[0] + x);
    }
    const Faces hexahedron = GetFaces(Hexahedron, c);
    if (kind == 0)
    {
      this->Cells.push_back(hexahedron);
    }
    else if (kind == 1)
    {
      // The faces of a wedge have the other sense.
      this->Cells.push_back(GetFaces(Wedge, { c[0], c[3], c[1], c[4], c[7], c[5] }));
      this->Cells.push_back(GetFaces(Wedge, { c[1], c[3], c[2], c[5], c[7], c[6] }));
    }
    else if (kind == 2)
    {
      const auto middle = static_cast<std::uint32_t>(this->Points.size());
      Place sum{};
      for (const auto corner : c)
      {
        for (unsigned axis = 0; axis < 3; ++axis)
        {
          sum[axis] += this->Points[corner][axis] / 8;
        }
      }
      this->Points.push_back(sum);
      for (const auto& f : hexahedron)
      {
        this->Cells.push_back(GetFaces(Pyramid, { f[0], f[3], f[2], f[1], middle }));
      }
    }
    else
    {
      // A polyhedron, whose faces begin anywhere.
      Faces turned = hexahedron;
      for (std::size_t i = 0; i < turned.size(); ++i)
      {
        std::rotate(
          turned[i].begin(), turned[i].begin() + static_cast<int>(i % 4), turned[i].end());
      }
      std::reverse(turned.begin(), turned.end());
      this->Cells.push_back(turned);
    }
  }

  std::vector<Tet> Split() const
  {
    std::vector<Tet> tets;
    for (const auto& cell : this->Cells)
    {
      const auto some = test::Split(cell, this->Points);
      tets.insert(tets.end(), some.begin(), some.end());
    }
    return tets;
  }
};
}

//------------------------------------------------------------------------------
TEST(CellShapes, AreClosedSurfaces)
{
  for (const int type : SplitTypes)
  {
    const CellKind kind = GetCellKind(type);
    ASSERT_TRUE(kind.Shape && kind.IsLinear()) << type;
    EXPECT_EQ(kind.Dimension, 3);
    std::vector<std::uint32_t> corners(kind.Shape->Corners);
    std::iota(corners.begin(), corners.end(), 0u);
    const Faces faces = GetFaces(type, corners);
    std::set<std::array<std::uint32_t, 2>> edges;
    for (const auto& face : faces)
    {
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        EXPECT_TRUE(edges.insert({ face[i], face[(i + 1) % face.size()] }).second) << type;
      }
    }
    for (const auto& [a, b] : edges)
    {
      EXPECT_EQ(edges.count({ b, a }), 1u) << type;
    }
    // Euler's formula.
    EXPECT_EQ(corners.size() + faces.size(), edges.size() / 2 + 2) << type;
  }
}

//------------------------------------------------------------------------------
TEST(Simplices, HaveTheVolumesOfPrisms)
{
  for (const std::uint32_t sides : { 3u, 4u, 5u, 6u })
  {
    // The upper end is turned around the axis of a wedge, whose first end looks outward.
    Places points;
    for (const double z : { 0.0, 2.0 })
    {
      for (std::uint32_t i = 0; i < sides; ++i)
      {
        const double angle = 0.3 + 2 * M_PI * i / sides * (sides == 3 ? -1 : 1);
        points.push_back({ std::cos(angle), std::sin(angle), z });
      }
    }
    std::vector<std::uint32_t> corners(points.size());
    std::iota(corners.begin(), corners.end(), 0u);
    const int type = sides == 3 ? Wedge : sides == 4 ? Hexahedron : sides == 5 ? 15 : 16;
    const auto tets = Split(GetFaces(type, corners), points);
    EXPECT_EQ(tets.size(), 3 * (sides - 2));
    double volume = 0;
    for (const auto& tet : tets)
    {
      EXPECT_GT(GetVolume(points, tet), 0);
      volume += GetVolume(points, tet);
    }
    EXPECT_NEAR(volume, sides * std::sin(2 * M_PI / sides), 1e-12);
  }
}

//------------------------------------------------------------------------------
TEST(Simplices, OfTheGridAreAllAlike)
{
  const Mixture grid(1, 0, 1);
  const Faces cube = GetFaces(Hexahedron, { 0, 1, 3, 2, 4, 5, 7, 6 });
  const auto tets = Split(cube, grid.Points);
  ASSERT_EQ(tets.size(), 6u);
  for (const auto& tet : tets)
  {
    EXPECT_NEAR(GetVolume(grid.Points, tet), 1.0 / 6, 1e-15);
    // All have the long diagonal.
    EXPECT_EQ(std::count(tet.begin(), tet.end(), 0u) + std::count(tet.begin(), tet.end(), 7u), 2);
  }
}

//------------------------------------------------------------------------------
TEST(Simplices, OfAllKindsOfCellsFit)
{
  constexpr std::uint32_t n = 5;
  const Mixture mixture(n, 0.2, 3);
  const auto tets = mixture.Split();
  double volume = 0;
  for (const auto& tet : tets)
  {
    EXPECT_GT(GetVolume(mixture.Points, tet), 0);
    volume += GetVolume(mixture.Points, tet);
  }
  EXPECT_NEAR(volume, n * n * n, 1e-9);
  const auto boundary = FindBoundary(tets);
  EXPECT_EQ(boundary.size(), 6 * 2 * n * n);
  for (const auto& side : boundary)
  {
    const auto& triangle = side.first;
    EXPECT_EQ(side.second, 1);
    const auto isOnSide = [&](unsigned axis, double where)
    {
      return std::all_of(triangle.begin(), triangle.end(),
        [&](std::uint32_t point) { return mixture.Points[point][axis] == where; });
    };
    EXPECT_TRUE(isOnSide(0, 0) || isOnSide(0, n) || isOnSide(1, 0) || isOnSide(1, n) ||
      isOnSide(2, 0) || isOnSide(2, n));
  }
}

//------------------------------------------------------------------------------
// As in another piece or file: other numbers of points, other first corners of faces.
TEST(Simplices, DependOnPlacesOnly)
{
  const Mixture mixture(3, 0.2, 5);
  std::vector<std::uint32_t> numbers(mixture.Points.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::shuffle(numbers.begin(), numbers.end(), std::mt19937(7));
  Mixture other = mixture;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    other.Points[numbers[i]] = mixture.Points[i];
  }
  for (auto& cell : other.Cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      for (auto& point : cell[i])
      {
        point = numbers[point];
      }
      std::rotate(cell[i].begin(), cell[i].begin() + static_cast<int>(i % 3), cell[i].end());
    }
  }
  const auto sorted = [](std::vector<Tet> tets)
  {
    for (auto& tet : tets)
    {
      std::sort(tet.begin(), tet.end());
    }
    std::sort(tets.begin(), tets.end());
    return tets;
  };
  auto expected = mixture.Split();
  for (auto& tet : expected)
  {
    for (auto& point : tet)
    {
      point = numbers[point];
    }
  }
  EXPECT_EQ(sorted(other.Split()), sorted(expected));
}

//------------------------------------------------------------------------------
TEST(Simplices, OfDegenerateCellsHaveFourCorners)
{
  // A hexahedron whose upper face is a point, as a pyramid; and one that is a wedge.
  const Places points{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 1 },
    { 0.5, 0, 1 }, { 0.5, 1, 1 } };
  for (const auto& [corners, volume] : std::vector<std::pair<std::vector<std::uint32_t>, double>>{
         { { 0, 1, 2, 3, 4, 4, 4, 4 }, 1.0 / 3 }, { { 0, 1, 2, 3, 5, 5, 6, 6 }, 0.5 },
         { { 0, 1, 2, 3, 0, 1, 2, 3 }, 0 }, { { 4, 4, 4, 4, 4, 4, 4, 4 }, 0 } })
  {
    double sum = 0;
    for (const auto& tet : Split(GetFaces(Hexahedron, corners), points))
    {
      EXPECT_EQ(std::set<std::uint32_t>(tet.begin(), tet.end()).size(), 4u);
      sum += GetVolume(points, tet);
    }
    EXPECT_NEAR(sum, volume, 1e-15);
  }
  // Faces that are none, and points at the same place.
  EXPECT_TRUE(Split({}, points).empty());
  EXPECT_TRUE(Split({ {}, { 1 }, { 2, 3 } }, points).empty());
  const Places same(8, { 1, 2, 3 });
  EXPECT_EQ(Split(GetFaces(Hexahedron, { 0, 1, 2, 3, 4, 5, 6, 7 }), same).size(), 6u);
}

//------------------------------------------------------------------------------
TEST(Simplices, HavePositiveVolumesForAnyDirectionOfFaces)
{
  const Mixture grid(1, 0, 1);
  const std::vector<std::uint32_t> corners{ 0, 1, 3, 2, 4, 5, 7, 6 };
  const Faces cube = GetFaces(Hexahedron, corners);
  // Two cubes, of which only the second one is inside out, without a common point, as one cell.
  Places points(grid.Points.begin(), grid.Points.begin() + 8);
  for (unsigned i = 0; i < 8; ++i)
  {
    points.push_back({ points[i][0] + 2, points[i][1], points[i][2] });
  }
  for (unsigned turned = 0; turned < 64; ++turned)
  {
    Faces faces = cube;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (turned >> i & 1u)
      {
        std::reverse(faces[i].begin(), faces[i].end());
      }
    }
    Faces two = faces;
    for (auto face : cube)
    {
      std::reverse(face.begin(), face.end());
      std::transform(face.begin(), face.end(), face.begin(), [](auto point) { return point + 8; });
      two.push_back(face);
    }
    for (const auto& [cell, expected] : { std::pair(faces, 1.0), std::pair(two, 2.0) })
    {
      double volume = 0;
      for (const auto& tet : Split(cell, points, true))
      {
        EXPECT_TRUE(GetVolume(points, tet) > 0 || cell.size() > 6) << turned;
        volume += GetVolume(points, tet);
      }
      EXPECT_NEAR(volume, expected, 1e-12) << turned;
    }
  }
  // Wedges in both conventions, and a hexahedron inside out.
  for (const auto& [type, cell, expected] :
    { std::tuple(Wedge, std::vector<std::uint32_t>{ 0, 1, 2, 4, 5, 6 }, 0.5),
      std::tuple(Wedge, std::vector<std::uint32_t>{ 0, 2, 1, 4, 6, 5 }, 0.5),
      std::tuple(Hexahedron, std::vector<std::uint32_t>{ 0, 2, 3, 1, 4, 6, 7, 5 }, 1.0) })
  {
    double volume = 0;
    for (const auto& tet : Split(GetFaces(type, cell), grid.Points))
    {
      EXPECT_GT(GetVolume(grid.Points, tet), 0) << type;
      volume += GetVolume(grid.Points, tet);
    }
    EXPECT_NEAR(volume, expected, 1e-12) << type;
  }
}

//------------------------------------------------------------------------------
// An L, whose volume is right only if some of its tetrahedra count as negative, and a surface with
// an edge of many faces, which must not take long.
TEST(Simplices, OfPolyhedraThatAreNotConvexAddUp)
{
  const Places points{ { 2, 0, 0 }, { 0, 0, 0 }, { 0, 2, 0 }, { 1, 2, 0 }, { 1, 1, 0 }, { 2, 1, 0 },
    { 2, 0, 1 }, { 0, 0, 1 }, { 0, 2, 1 }, { 1, 2, 1 }, { 1, 1, 1 }, { 2, 1, 1 } };
  Faces faces{ { 0, 1, 2, 3, 4, 5 }, { 6, 7, 8, 9, 10, 11 } }; // in opposite directions
  for (std::uint32_t i = 0; i < 6; ++i)
  {
    const std::uint32_t next = (i + 1) % 6;
    faces.push_back({ i, next, next + 6, i + 6 });
  }
  double volume = 0;
  for (const auto& tet : Split(faces, points, true))
  {
    volume += GetVolume(points, tet);
  }
  EXPECT_NEAR(volume, 3, 1e-12);
  EXPECT_FALSE(Split(Faces(100000, { 0, 1, 2 }), points, true).size() > 0);
}

//------------------------------------------------------------------------------
TEST(Simplices, AreOrderedByEveryNumber)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> ascending{ -nan, -infinity, -1e300, -2, -5e-324, -0.0, 0, 5e-324, 1.5,
    infinity, nan };
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    Places points(ascending.size(), { 4, 4, 4 });
    for (std::size_t i = 0; i < ascending.size(); ++i)
    {
      points[i][axis] = ascending[i];
    }
    const PointOrder<double> order(points.front().data());
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
      for (std::uint32_t j = 0; j < points.size(); ++j)
      {
        EXPECT_EQ(order(i, j), i < j) << ascending[i] << " and " << ascending[j];
      }
    }
  }
  const std::array<float, 6> floats{ 1, -2, 3, 1, -2.5f, 3 };
  EXPECT_TRUE(PointOrder<float>(floats.data())(1, 0));
  EXPECT_FALSE(PointOrder<float>(floats.data())(0, 1));
}
}
