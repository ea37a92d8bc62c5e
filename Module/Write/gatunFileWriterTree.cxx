// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileWriter: the merges of a mesh and of its base meshes.

#include "gatunFileWriterInternals.h"
#include "gatunMergeOrder.h"
#include "gatunMeshDependencies.h"
#include "gatunTreeParts.h"

#include <cstddef>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
/** Finds the points of the mesh in the order of the file, when the mesh has been written. */
void FileWriter::Internals::OrderPoints()
{
  auto numbers = FindFileNumbers(this->State, this->Part, this->State.Table.GetSharedPoints());
  auto next = static_cast<std::uint32_t>(this->State.Meta.Points - this->State.Meta.UnusedPoints);
  for (const auto point : this->Part.Layout.UnusedPoints)
  {
    numbers[point] = next++;
  }
  this->PointOrder = InvertOrder(numbers);
}

//------------------------------------------------------------------------------
/** tree: in the numbers of the file. */
TreeSection& FileWriter::Internals::BeginTree(MergeTree tree)
{
  return this->Tree.emplace(this->State, std::move(tree),
    [this](unsigned axis)
    {
      return [this, axis](std::uint32_t point)
      { return ArrayInput::Finite(this->Part.Mesh.GetCoordinate(this->PointOrder[point], axis)); };
    });
}

//------------------------------------------------------------------------------
/** Writes the merges, when the mesh and all base meshes have been written. */
void FileWriter::Internals::WriteTrees(const Progress& progress)
{
  this->OrderPoints();
  std::vector<MeshOfTree> meshes{ { 0, this->PointOrder,
    [this](MergeTree tree) -> TreeSection& { return this->BeginTree(std::move(tree)); } } };
  std::vector<std::vector<std::uint32_t>> points(this->Levels.size()); // of this mesh
  for (std::size_t i = 0; i < this->Levels.size(); ++i)
  {
    Internals& file = *this->Levels[i]->File;
    file.OrderPoints();
    for (const auto point : file.PointOrder)
    {
      points[i].push_back(this->Levels[i]->Mesh.GetPoints()[point]);
    }
    meshes.push_back({ this->Merges[i], points[i],
      [&file](MergeTree tree) -> TreeSection& { return file.BeginTree(std::move(tree)); } });
  }
  const WriterOptions& options = this->State.Options;
  TreeParts parts(*options.Tree, std::move(meshes));
  if (options.Dependencies && !options.Tree->GetMerges().empty())
  {
    const Progress proceed = [&](double) { return !progress || progress(1); };
    // No builder makes merges that would take long.
    if (const auto found =
          FindDependencies(this->Part.Mesh, parts.GetTree(), options.IsSurface, proceed))
    {
      parts.WriteDependencies(*found, proceed);
    }
  }
}
}
