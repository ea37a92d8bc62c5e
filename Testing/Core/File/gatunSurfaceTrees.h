// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurfaceTrees_h
#define gatunSurfaceTrees_h

// Surfaces with a merge tree, seams and cells of all lists, for files.

#include "gatunTestSheets.h"
#include "gatunTreeSample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun::test
{
/** A sheet of triangles as a sample with a point and a cell array. Its tree is not built. */
inline TreeSample ToSample(const Sheet& sheet, std::size_t steps)
{
  TreeSample sample;
  for (const SheetPoint& point : sheet.Points)
  {
    sample.Coordinates.insert(sample.Coordinates.end(), point.begin(), point.end());
  }
  sample.Singles.assign(sample.Coordinates.begin(), sample.Coordinates.end());
  sample.Offsets = { 0 };
  for (const SheetTriangle& triangle : sheet.Triangles)
  {
    sample.Ids.insert(sample.Ids.end(), triangle.begin(), triangle.end());
    sample.Offsets.push_back(static_cast<std::int64_t>(sample.Ids.size()));
    sample.Types.push_back(5);
  }
  sample.AddArray<float>("wave", Association::Point, ScalarType::Float32, 2, steps,
    [&](std::size_t i, std::size_t c, std::size_t step)
    { return sheet.Values[i] + static_cast<double>(c) * 3 + 0.25 * static_cast<double>(step); });
  sample.AddArray<std::int16_t>("material", Association::Cell, ScalarType::Int16, 1, steps,
    [](std::size_t i, std::size_t, std::size_t step) { return i / 3 + step; });
  sample.HasTime = steps > 1;
  return sample;
}

/** The usual tree of the triangles of a sample; points of other cells are kept. */
inline void BuildSurfaceTree(TreeSample& sample, const std::vector<double>& field)
{
  std::vector<SheetPoint> points(sample.GetPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::copy_n(&sample.Coordinates[3 * i], 3, points[i].begin());
  }
  std::vector<SheetTriangle> triangles;
  std::vector<std::uint8_t> isKept(points.size(), 0);
  for (std::size_t cell = 0; cell < sample.Types.size(); ++cell)
  {
    const auto* const ids = &sample.Ids[static_cast<std::size_t>(sample.Offsets[cell])];
    const auto count = static_cast<std::size_t>(sample.Offsets[cell + 1] - sample.Offsets[cell]);
    if (sample.Types[cell] == 5)
    {
      std::copy_n(ids, 3, triangles.emplace_back().begin());
    }
    for (std::size_t i = 0; i < count && sample.Types[cell] != 5; ++i)
    {
      isKept[static_cast<std::size_t>(ids[i])] = 1;
    }
  }
  sample.Tree = BuildMergeTree({ points, triangles, { { field, 1 } }, isKept });
}

/** A torus with two seams; a vertex, a line, a quadrilateral and a strip on it; a triangle with a
 * corner twice; and a point of no cell. */
inline TreeSample MakeSurfaceSample(std::uint32_t columns, std::uint32_t rows, std::size_t steps)
{
  Sheet sheet = MakeSheet(columns, rows, true, true, PlaceOnTorus, true);
  sheet.Points.push_back({ 5, 5, 5 });
  sheet.Values.push_back(0);
  // All cells in the order of their lists: those before the triangles have two points at most.
  const auto last = static_cast<std::uint32_t>(sheet.Triangles.size());
  sheet.Triangles.push_back({ 40, 40, 41 });
  TreeSample sample = ToSample(sheet, steps);
  const auto insert = [&](std::size_t cell, std::uint8_t type, const std::vector<int>& ids)
  {
    const auto at = sample.Offsets[cell];
    sample.Ids.insert(sample.Ids.begin() + at, ids.begin(), ids.end());
    for (auto i = cell; i < sample.Offsets.size(); ++i)
    {
      sample.Offsets[i] += static_cast<std::int64_t>(ids.size());
    }
    sample.Offsets.insert(sample.Offsets.begin() + static_cast<std::ptrdiff_t>(cell), at);
    sample.Types.insert(sample.Types.begin() + static_cast<std::ptrdiff_t>(cell), type);
  };
  insert(0, 1, { 30 });
  insert(1, 3, { 32, 34 });
  insert(last + 3, 9, { 5, 6, 9, 8 });
  insert(last + 4, 6, { 10, 11, 12, 13, 14 });
  // The arrays were made for fewer cells.
  sample.Arrays.pop_back();
  for (auto& values : sample.Steps)
  {
    values.pop_back();
  }
  sample.AddArray<std::int16_t>("material", Association::Cell, ScalarType::Int16, 1, steps,
    [](std::size_t i, std::size_t, std::size_t step) { return i / 3 + step; });
  BuildSurfaceTree(sample, sheet.Values);
  return sample;
}
}

#endif
