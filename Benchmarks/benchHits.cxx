// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchHits.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bench
{
namespace
{
struct Place
{
  double X, Y; // pixels; those with whole numbers are centers
};

/** On which side of the line from a to b. */
double Side(const Place& a, const Place& b, const Place& p)
{
  return (b.X - a.X) * (p.Y - a.Y) - (b.Y - a.Y) * (p.X - a.X);
}

bool IsInside(const Place& a, const Place& b, const Place& c, const Place& p)
{
  const double sides[3] = { Side(a, b, p), Side(b, c, p), Side(c, a, p) };
  return std::all_of(sides, sides + 3, [](double side) { return side > 0; }) ||
    std::all_of(sides, sides + 3, [](double side) { return side < 0; });
}

std::uint64_t CountPixels(const std::array<Place, 4>& corners, int size)
{
  const auto [left, right] =
    std::minmax({ corners[0].X, corners[1].X, corners[2].X, corners[3].X });
  const auto [bottom, top] =
    std::minmax({ corners[0].Y, corners[1].Y, corners[2].Y, corners[3].Y });
  const auto first = [](double place) { return std::max(0, static_cast<int>(std::ceil(place))); };
  const auto last = [size](double place)
  { return std::min(size - 1, static_cast<int>(std::floor(place))); };
  std::uint64_t count = 0;
  for (int y = first(bottom); y <= last(top); ++y)
  {
    for (int x = first(left); x <= last(right); ++x)
    {
      const Place p{ static_cast<double>(x), static_cast<double>(y) };
      // The outline of four points is made of the triangles between them.
      count += IsInside(corners[0], corners[1], corners[2], p) ||
          IsInside(corners[0], corners[1], corners[3], p) ||
          IsInside(corners[0], corners[2], corners[3], p) ||
          IsInside(corners[1], corners[2], corners[3], p)
        ? 1
        : 0;
    }
  }
  return count;
}
}

//------------------------------------------------------------------------------
std::uint64_t CountHits(vtkUnstructuredGrid* grid, vtkCamera* camera, int size)
{
  // Centers are missed by a little, as lines of a lattice go through them exactly.
  constexpr double shift = 1e-4;
  vtkMatrix4x4* const matrix = camera->GetCompositeProjectionTransformMatrix(1, -1, 1);
  std::vector<Place> places(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double point[4] = { 0, 0, 0, 1 };
    grid->GetPoint(static_cast<vtkIdType>(i), point);
    matrix->MultiplyPoint(point, point);
    const auto toPixel = [size](double place) { return (place + 1) / 2 * size - 0.5 + shift; };
    places[i] = { toPixel(point[0] / point[3]), toPixel(point[1] / point[3]) };
  }
  std::uint64_t hits = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(cell, count, ids);
    std::array<Place, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
    {
      corners[i] = places[static_cast<std::size_t>(ids[i])];
    }
    hits += CountPixels(corners, size);
  }
  return hits;
}
}
