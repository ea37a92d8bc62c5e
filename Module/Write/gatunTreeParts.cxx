// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTreeParts.h"

#include "gatunDependencyCodec.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/** The number in a mesh of each point of the tree; None if it is not in the mesh. */
std::vector<std::uint32_t> NumberPoints(const MeshOfTree& mesh, std::size_t points)
{
  std::vector<std::uint32_t> numbers(points, None);
  for (std::uint32_t i = 0; i < mesh.Points.size(); ++i)
  {
    numbers[mesh.Points[i]] = i;
  }
  return numbers;
}

/** The merges from the first one of a mesh on, in its numbers. */
MergeTree TakeRest(const MergeTree& tree, const MeshOfTree& mesh)
{
  const auto numbers = NumberPoints(mesh, tree.GetNumberOfPoints());
  std::vector<Merge> rest(tree.GetMerges().begin() + mesh.FirstMerge, tree.GetMerges().end());
  for (Merge& merge : rest)
  {
    merge.Point = numbers[merge.Point];
    merge.Into = numbers[merge.Into];
  }
  const auto& bonds = tree.GetBonds();
  const auto skipped = std::min<std::size_t>(mesh.FirstMerge, bonds.size());
  std::vector<std::uint32_t> rounds;
  for (const auto round : tree.GetRounds())
  {
    if (round >= mesh.FirstMerge)
    {
      rounds.push_back(round - mesh.FirstMerge);
    }
  }
  const bool isWhole = !rounds.empty() && rounds.front() == 0;
  return { static_cast<std::uint32_t>(mesh.Points.size()), std::move(rest),
    std::vector<bool>(bonds.begin() + static_cast<std::ptrdiff_t>(skipped), bonds.end()),
    isWhole ? std::move(rounds) : std::vector<std::uint32_t>() };
}

/** The numbers in a base mesh of those points of the mesh before that it has, in their order. */
std::vector<std::uint32_t> MapPoints(
  const MeshOfTree& before, const MeshOfTree& after, std::size_t points)
{
  const auto numbers = NumberPoints(after, points);
  std::vector<std::uint32_t> map;
  map.reserve(after.Points.size());
  for (const auto point : before.Points)
  {
    if (numbers[point] != None)
    {
      map.push_back(numbers[point]);
    }
  }
  return map;
}
}

//------------------------------------------------------------------------------
TreeParts::TreeParts(MergeTree tree, std::vector<MeshOfTree> meshes)
  : Meshes(std::move(meshes))
  , Tree(this->Sort(std::move(tree)))
{
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    const MeshOfTree& mesh = this->Meshes[i];
    this->Sections.push_back(&mesh.Begin(TakeRest(this->Tree, mesh)));
    this->Sections.front()->AddPart(*this->Sections.back(), this->GetEnd(i) - mesh.FirstMerge,
      i + 1 < this->Meshes.size()
        ? MapPoints(mesh, this->Meshes[i + 1], this->Tree.GetNumberOfPoints())
        : std::vector<std::uint32_t>());
  }
}

//------------------------------------------------------------------------------
/** Sorts the merges of each round by the numbers of their points in the mesh of the merges. */
MergeTree TreeParts::Sort(MergeTree tree) const
{
  if (tree.GetRounds().empty())
  {
    return tree;
  }
  std::vector<std::uint32_t> numbers(tree.GetNumberOfPoints());
  std::vector<std::uint32_t> ends;
  for (const MeshOfTree& mesh : this->Meshes) // coarser ones have the points that are merged later
  {
    for (std::uint32_t i = 0; i < mesh.Points.size(); ++i)
    {
      numbers[mesh.Points[i]] = i;
    }
    ends.push_back(mesh.FirstMerge);
  }
  return SortRounds(tree, numbers, ends);
}

//------------------------------------------------------------------------------
/** The first merge that is stored with the next mesh. */
std::uint32_t TreeParts::GetEnd(std::size_t mesh) const
{
  return mesh + 1 < this->Meshes.size() ? this->Meshes[mesh + 1].FirstMerge
                                        : static_cast<std::uint32_t>(this->Tree.GetMerges().size());
}

//------------------------------------------------------------------------------
void TreeParts::WriteDependencies(const MergeDependencies& dependencies, const Progress& progress)
{
  // From the coarsest mesh on, as all finer ones need its dependencies.
  for (std::size_t i = this->Meshes.size(); i-- > 0;)
  {
    const auto first = this->Meshes[i].FirstMerge;
    if (first == this->GetEnd(i))
    {
      continue;
    }
    const auto stream = EncodeDependencies(this->Sections[i]->GetTree(),
      SelectDependencies(dependencies, first, this->GetEnd(i)), progress);
    if (stream.empty())
    {
      return; // there are too many
    }
    this->Sections.front()->AddDependencies(i, stream);
  }
}
}
