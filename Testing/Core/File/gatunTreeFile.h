// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeFile_h
#define gatunTreeFile_h

// Meshes with merge trees, and what merging leaves of them.

#include "gatunTestFile.h"
#include "gatunTestMeshes.h"
#include "gatunTestTrees.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace gatun::test
{
/** What is left of a mesh and its values: the points in their order, then the tetrahedra. */
struct Left
{
  Left(const TestMesh& mesh, const Values& values, const MergeTree& tree, std::size_t merges)
  {
    const auto ancestors = tree.FindAncestors(merges);
    std::vector<std::int64_t> places(ancestors.size());
    for (std::size_t i = 0; i < ancestors.size(); ++i)
    {
      if (ancestors[i] == i)
      {
        places[i] = static_cast<std::int64_t>(this->PointIds.size());
        this->PointIds.push_back(static_cast<std::int64_t>(i));
        this->Mesh.Coordinates.insert(
          this->Mesh.Coordinates.end(), &mesh.Coordinates[3 * i], &mesh.Coordinates[3 * i] + 3);
        this->Field.push_back(values.Field[i]);
        this->Vector.insert(this->Vector.end(), &values.Vector[3 * i], &values.Vector[3 * i] + 3);
      }
    }
    for (std::size_t t = 0; t < mesh.GetTets(); ++t)
    {
      std::array<std::int64_t, 4> corners{};
      for (std::size_t c = 0; c < 4; ++c)
      {
        corners[c] = places[ancestors[static_cast<std::size_t>(mesh.Ids[4 * t + c])]];
      }
      if (std::set<std::int64_t>(corners.begin(), corners.end()).size() == 4)
      {
        this->CellIds.push_back(static_cast<std::int64_t>(t));
        this->Mesh.Ids.insert(this->Mesh.Ids.end(), corners.begin(), corners.end());
        this->Material.push_back(values.Material[t]);
      }
    }
  }

  TestMesh Mesh;
  std::vector<float> Field;
  std::vector<double> Vector;
  std::vector<std::int32_t> Material;
  std::vector<std::int64_t> PointIds, CellIds;
};

/** Cubes, and two points that no tetrahedron has. */
inline TestMesh MakeMesh(std::int64_t n)
{
  auto mesh = MakeCubes(n, 0.2);
  mesh.Coordinates.insert(mesh.Coordinates.begin(), { 50, 51, 52 });
  mesh.Coordinates.insert(mesh.Coordinates.end(), { 60, 61, 62 });
  for (auto& id : mesh.Ids)
  {
    ++id;
  }
  return mesh;
}
}

#endif
