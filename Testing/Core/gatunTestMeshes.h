// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTestMeshes_h
#define gatunTestMeshes_h

// Small meshes for tests of the core, made anew each time from a fixed seed.

#include "gatunFileWriter.h"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace gatun::test
{
/** A mesh with one float point array, and what a FileWriter needs of both. */
struct TestMesh
{
  std::vector<double> Coordinates;
  std::vector<std::int64_t> Ids;

  std::size_t GetPoints() const { return this->Coordinates.size() / 3; }
  std::size_t GetTets() const { return this->Ids.size() / 4; }

  MeshInput GetInput() const
  {
    MeshInput input;
    input.Points = this->GetPoints();
    input.CoordinateType = ScalarType::Float64;
    input.Coordinates = this->Coordinates.data();
    input.Cells = this->GetTets();
    input.Connectivity = this->Ids.data();
    return input;
  }
};

/** n * n * n cubes of six tetrahedra around a diagonal each, points moved by up to jitter. */
inline TestMesh MakeCubes(std::int64_t n, double jitter, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  TestMesh mesh;
  for (std::int64_t z = 0; z <= n; ++z)
  {
    for (std::int64_t y = 0; y <= n; ++y)
    {
      for (std::int64_t x = 0; x <= n; ++x)
      {
        for (const auto c : { x, y, z })
        {
          mesh.Coordinates.push_back(static_cast<double>(c) + move(random));
        }
      }
    }
  }
  const std::int64_t row = n + 1;
  const auto id = [&](std::int64_t x, std::int64_t y, std::int64_t z)
  { return (z * row + y) * row + x; };
  constexpr int paths[6][2] = { { 1, 3 }, { 3, 2 }, { 2, 6 }, { 6, 4 }, { 4, 5 }, { 5, 1 } };
  for (std::int64_t z = 0; z < n; ++z)
  {
    for (std::int64_t y = 0; y < n; ++y)
    {
      for (std::int64_t x = 0; x < n; ++x)
      {
        const auto corner = [&](int bits)
        { return id(x + (bits & 1), y + ((bits >> 1) & 1), z + ((bits >> 2) & 1)); };
        for (const auto& path : paths)
        {
          mesh.Ids.insert(
            mesh.Ids.end(), { corner(0), corner(path[0]), corner(path[1]), corner(7) });
        }
      }
    }
  }
  return mesh;
}

/** Tetrahedra with random corners: nothing is manifold, chunks share nearly everything. */
inline TestMesh MakeSoup(std::size_t points, std::size_t tets, unsigned seed = 2)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  std::uniform_int_distribution<std::int64_t> pick(0, static_cast<std::int64_t>(points) - 1);
  TestMesh mesh;
  for (std::size_t i = 0; i < 3 * points; ++i)
  {
    mesh.Coordinates.push_back(place(random));
  }
  for (std::size_t i = 0; i < 4 * tets; ++i)
  {
    mesh.Ids.push_back(pick(random));
  }
  return mesh;
}
}

#endif
