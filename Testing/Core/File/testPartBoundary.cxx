// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The points that other parts may have, in meshes whose boundaries are known.

#include "gatunPartBoundary.h"

#include "gatunCellMixture.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <set>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr std::int64_t N = 6; // cubes along each axis
constexpr std::int64_t Row = N + 1;

std::array<std::int64_t, 3> GetPlace(std::size_t point)
{
  const auto p = static_cast<std::int64_t>(point);
  return { p % Row, p / Row % Row, p / (Row * Row) };
}

bool IsOnBoundary(std::int64_t x)
{
  return x == 0 || x == N;
}

/** Expects that exactly the points of a kind are marked, whatever the chunks are. */
void ExpectBoundary(const MeshInput& input, const std::function<bool(std::size_t)>& isSkin)
{
  const MeshAccess mesh(input);
  for (const std::uint32_t chunkCells : { 7u, 50u, 100000u })
  {
    const auto marks = FindPartBoundary(mesh, MakePartition(mesh, { chunkCells }, {}));
    ASSERT_EQ(marks.size(), input.Points);
    for (std::size_t p = 0; p < marks.size(); ++p)
    {
      EXPECT_EQ(marks[p] != 0, isSkin(p)) << "point " << p << ", chunks of " << chunkCells;
    }
  }
}

bool IsOnSurface(std::size_t point)
{
  const auto [x, y, z] = GetPlace(point);
  return IsOnBoundary(x) || IsOnBoundary(y) || IsOnBoundary(z);
}
}

TEST(PartBoundary, TetrahedraHaveTheirSurface)
{
  ExpectBoundary(MakeCubes(N, 0.2).GetInput(), IsOnSurface);
}

TEST(PartBoundary, SolidsOfSeveralTypesHaveTheirSurface)
{
  Mixture mesh(0);
  mesh.Coordinates.resize(3 * Row * Row * Row);
  for (std::size_t p = 0; p < mesh.Coordinates.size() / 3; ++p)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      mesh.Coordinates[3 * p + axis] = static_cast<double>(GetPlace(p)[axis]);
    }
  }
  for (std::int64_t i = 0; i < N * N * N; ++i)
  {
    // Hexahedra and polyhedra: wedges would divide faces otherwise than their neighbors.
    mesh.AddCube(N, { i % N, i / N % N, i / (N * N) }, 1 + static_cast<unsigned>(i % 2));
  }
  ExpectBoundary(mesh.GetInput(), IsOnSurface);
  // A line inside, and a quadrilateral: their ends and edges, and what they have with solids.
  const auto id = [](std::int64_t x, std::int64_t y, std::int64_t z)
  { return (z * Row + y) * Row + x; };
  mesh.AddCell(Line, { id(2, 2, 2), id(4, 4, 4) });
  mesh.AddCell(Quad, { id(1, 1, 1), id(2, 1, 1), id(2, 2, 1), id(1, 2, 1) });
  const std::set<std::int64_t> more{ id(2, 2, 2), id(4, 4, 4), id(1, 1, 1), id(2, 1, 1),
    id(2, 2, 1), id(1, 2, 1) };
  ExpectBoundary(mesh.GetInput(),
    [&](std::size_t p) { return IsOnSurface(p) || more.count(static_cast<std::int64_t>(p)) > 0; });
}

TEST(PartBoundary, SurfacesAndLinesHaveTheirEnds)
{
  Mixture surface(0);
  Mixture lines(0);
  surface.Coordinates.assign(3 * Row * Row * Row, 0.5);
  lines.Coordinates = surface.Coordinates;
  for (std::int64_t i = 0; i < Row * Row * Row; ++i)
  {
    const auto [x, y, z] = GetPlace(static_cast<std::size_t>(i));
    if (x < N && y < N)
    {
      surface.AddCell(Quad, { i, i + 1, i + 1 + Row, i + Row });
    }
    if (x < N)
    {
      lines.AddCell(Line, { i, i + 1 });
    }
  }
  ExpectBoundary(surface.GetInput(),
    [](std::size_t p)
    {
      const auto [x, y, z] = GetPlace(p);
      return IsOnBoundary(x) || IsOnBoundary(y);
    });
  ExpectBoundary(lines.GetInput(), [](std::size_t p) { return IsOnBoundary(GetPlace(p)[0]); });
}

TEST(PartBoundary, PointsOfVerticesAndOfNoCellAreAllFound)
{
  Mixture mesh(0);
  mesh.Coordinates.assign(30, 0.5);
  mesh.AddCell(1, { 3 });
  mesh.AddCell(2, { 4, 5, 6 });
  ExpectBoundary(mesh.GetInput(), [](std::size_t) { return true; });
}
