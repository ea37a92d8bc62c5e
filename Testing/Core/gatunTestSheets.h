// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTestSheets_h
#define gatunTestSheets_h

// Surfaces for tests, and their topology after merges.

#include "gatunSurfaceMergeBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gatun::test
{
using SheetTriangle = std::array<std::uint32_t, 3>;
using SheetPoint = std::array<double, 3>;

struct Sheet
{
  std::vector<SheetPoint> Points;
  std::vector<SheetTriangle> Triangles;
  std::vector<double> Values;

  SurfaceMergeInput GetInput() const
  {
    return { this->Points, this->Triangles, { { this->Values, 1 } } };
  }
};

/** A lattice of squares, two triangles each. Columns and rows can be closed to a loop, by the same
 * points or, with a seam, by points at the same place. */
inline Sheet MakeSheet(std::uint32_t columns, std::uint32_t rows, bool isRing, bool isTube,
  const std::function<SheetPoint(double, double)>& place, bool hasSeams = false)
{
  Sheet sheet;
  const std::uint32_t width = columns + (isRing && !hasSeams ? 0 : 1);
  const std::uint32_t height = rows + (isTube && !hasSeams ? 0 : 1);
  for (std::uint32_t y = 0; y < height; ++y)
  {
    for (std::uint32_t x = 0; x < width; ++x)
    {
      const double u = static_cast<double>(isRing ? x % columns : x) / columns;
      const double v = static_cast<double>(isTube ? y % rows : y) / rows;
      sheet.Points.push_back(place(u, v));
      // On the two sides of a seam, the values differ.
      sheet.Values.push_back(static_cast<double>(x) / columns + 0.3 * std::sin(5 * v));
    }
  }
  for (std::uint32_t y = 0; y < rows; ++y)
  {
    for (std::uint32_t x = 0; x < columns; ++x)
    {
      const auto at = [&](std::uint32_t i, std::uint32_t j)
      { return (y + j) % height * width + (x + i) % width; };
      sheet.Triangles.push_back({ at(0, 0), at(1, 0), at(1, 1) });
      sheet.Triangles.push_back({ at(0, 0), at(1, 1), at(0, 1) });
    }
  }
  return sheet;
}

inline SheetPoint PlaceOnTorus(double u, double v)
{
  const double a = 2 * std::numbers::pi * u;
  const double b = 2 * std::numbers::pi * v;
  const double r = 1 + 0.4 * std::cos(b) + 0.03 * std::sin(7 * a);
  return { r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b) };
}

inline SheetPoint PlaceOnHill(double u, double v)
{
  return { u, v, u * (1 - u) * v * (1 - v) * std::sin(9 * u) * std::cos(7 * v + u) };
}

inline SheetPoint PlaceOnPlane(double u, double v)
{
  return { 2 * u - 1, 2 * v - 1, 0.5 };
}

/** The surface of a cube of n squares a side, with the points of its faces joined or not. */
inline Sheet MakeCube(std::uint32_t n, bool hasSeams)
{
  Sheet cube;
  std::map<SheetPoint, std::uint32_t> known;
  for (unsigned face = 0; face < 6; ++face)
  {
    known = hasSeams ? std::map<SheetPoint, std::uint32_t>() : known;
    const auto at = [&](std::uint32_t i, std::uint32_t j)
    {
      SheetPoint p{};
      p[face % 3] = face < 3 ? 0 : n;
      p[(face + 1) % 3] = face < 3 ? j : i;
      p[(face + 2) % 3] = face < 3 ? i : j;
      const auto [found, isNew] = known.emplace(p, static_cast<std::uint32_t>(cube.Points.size()));
      if (isNew)
      {
        cube.Points.push_back(p);
        cube.Values.push_back(hasSeams ? face : p[0]);
      }
      return found->second;
    };
    for (std::uint32_t j = 0; j < n; ++j)
    {
      for (std::uint32_t i = 0; i < n; ++i)
      {
        cube.Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
        cube.Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
  }
  return cube;
}

inline Sheet MakeSphere(std::uint32_t n)
{
  Sheet sphere = MakeCube(n, false);
  for (std::size_t i = 0; i < sphere.Points.size(); ++i)
  {
    SheetPoint& p = sphere.Points[i];
    double square = 0;
    for (double& x : p)
    {
      x = 2 * x / n - 1;
      square += x * x;
    }
    for (double& x : p)
    {
      x /= std::sqrt(square);
    }
    sphere.Values[i] = std::sin(3 * p[0]) * p[1];
  }
  return sphere;
}

inline std::vector<SheetTriangle> Simplify(
  const std::vector<SheetTriangle>& triangles, const MergeTree& tree, std::size_t merges)
{
  const auto ancestors = tree.FindAncestors(merges);
  std::vector<SheetTriangle> left;
  for (const SheetTriangle& t : triangles)
  {
    const SheetTriangle now{ ancestors[t[0]], ancestors[t[1]], ancestors[t[2]] };
    if (now[0] != now[1] && now[1] != now[2] && now[2] != now[0])
    {
      left.push_back(now);
    }
  }
  return left;
}

/** MergeTree::CountWholeMerges, found by the coordinates. */
inline std::size_t CountWhole(
  const MergeTree& tree, std::size_t merges, const std::vector<SheetPoint>& points)
{
  const auto& all = tree.GetMerges();
  std::size_t whole = std::min(merges, all.size());
  while (
    whole > 0 && whole < all.size() && points[all[whole - 1].Point] == points[all[whole].Point])
  {
    --whole;
  }
  return whole;
}

inline SheetPoint GetNormal(const std::vector<SheetPoint>& points, const SheetTriangle& t)
{
  SheetPoint a{};
  SheetPoint b{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    a[i] = points[t[1]][i] - points[t[0]][i];
    b[i] = points[t[2]][i] - points[t[0]][i];
  }
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/** The topology of triangles whose corners are the numbers of places. */
struct Topology
{
  int EulerCharacteristic = 0;
  std::set<std::pair<SheetPoint, SheetPoint>> Border;
  bool IsManifold = true; // no edge of three triangles, and only fans around points

  Topology(const std::vector<SheetPoint>& points, const std::vector<SheetTriangle>& triangles)
  {
    std::map<std::pair<SheetPoint, SheetPoint>, int> edges;
    std::map<SheetPoint, std::multimap<SheetPoint, SheetPoint>> fans;
    for (const SheetTriangle& t : triangles)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const SheetPoint& a = points[t[i]];
        const SheetPoint& b = points[t[(i + 1) % 3]];
        const SheetPoint& c = points[t[(i + 2) % 3]];
        ++edges[std::minmax(a, b)];
        fans[a].emplace(b, c);
        fans[a].emplace(c, b);
      }
    }
    for (const auto& [edge, count] : edges)
    {
      this->IsManifold = this->IsManifold && count <= 2;
      if (count == 1)
      {
        this->Border.insert(edge);
      }
    }
    for (const auto& [point, links] : fans)
    {
      std::set<SheetPoint> seen{ links.begin()->first };
      std::vector<SheetPoint> todo{ links.begin()->first };
      while (!todo.empty())
      {
        const SheetPoint at = todo.back();
        todo.pop_back();
        for (auto [i, last] = links.equal_range(at); i != last; ++i)
        {
          if (seen.insert(i->second).second)
          {
            todo.push_back(i->second);
          }
        }
      }
      std::set<SheetPoint> all;
      for (const auto& link : links)
      {
        all.insert(link.first);
      }
      this->IsManifold = this->IsManifold && seen == all;
    }
    this->EulerCharacteristic = static_cast<int>(fans.size()) - static_cast<int>(edges.size()) +
      static_cast<int>(triangles.size());
  }
};

inline Sheet MakeSheet(const std::string& name)
{
  if (name == "Sphere")
  {
    return MakeSphere(8);
  }
  if (name == "Torus" || name == "SeamedTorus")
  {
    return MakeSheet(24, 12, true, true, PlaceOnTorus, name == "SeamedTorus");
  }
  if (name == "SeamedCube")
  {
    return MakeCube(6, true);
  }
  if (name == "Tube")
  {
    return MakeSheet(16, 9, true, false,
      [](double u, double v)
      {
        return SheetPoint{ std::cos(2 * std::numbers::pi * u), std::sin(2 * std::numbers::pi * u),
          3 * v };
      });
  }
  if (name == "Moebius")
  {
    Sheet sheet = MakeSheet(20, 4, false, false,
      [](double u, double v)
      {
        const double a = 2 * std::numbers::pi * u;
        const double w = v - 0.5;
        const double r = 1 + w * std::cos(a / 2);
        return SheetPoint{ r * std::cos(a), r * std::sin(a), w * std::sin(a / 2) };
      });
    // The last column is the first one upside down.
    for (SheetTriangle& t : sheet.Triangles)
    {
      for (auto& corner : t)
      {
        corner = corner % 21 == 20 ? (4 - corner / 21) * 21 : corner;
      }
    }
    return sheet;
  }
  return MakeSheet(14, 14, false, false, PlaceOnHill);
}
}

#endif
