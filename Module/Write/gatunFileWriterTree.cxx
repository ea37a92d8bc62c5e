// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileWriter: the merges of a mesh and of its base meshes. Each merge is stored once, in the
// numbers of the last base mesh before it.

#include "gatunDependencyCodec.h"
#include "gatunFileWriterInternals.h"
#include "gatunMergeOrder.h"
#include "gatunMeshDependencies.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/** The merges from a first one on with other numbers of the points. */
MergeTree RenumberRest(const MergeTree& tree, std::uint32_t first,
  const std::vector<std::uint32_t>& numbers, std::uint64_t points)
{
  std::vector<Merge> rest(tree.GetMerges().begin() + first, tree.GetMerges().end());
  for (Merge& merge : rest)
  {
    merge.Point = numbers[merge.Point];
    merge.Into = numbers[merge.Into];
  }
  const auto& bonds = tree.GetBonds();
  const auto skipped = std::min<std::size_t>(first, bonds.size());
  return { static_cast<std::uint32_t>(points), std::move(rest),
    std::vector<bool>(bonds.begin() + static_cast<std::ptrdiff_t>(skipped), bonds.end()) };
}

/** The new numbers of points that have one, in the order of their old numbers. */
std::vector<std::uint32_t> MapPoints(
  const std::vector<std::uint32_t>& before, const std::vector<std::uint32_t>& after)
{
  std::vector<std::uint32_t> map(before.size(), None);
  for (std::size_t point = 0; point < before.size(); ++point)
  {
    if (after[point] != None)
    {
      map[before[point]] = after[point];
    }
  }
  std::erase(map, None);
  return map;
}
}

//------------------------------------------------------------------------------
/** Finds the number in the file of each point, when the mesh has been written. */
std::vector<std::uint32_t> FileWriter::Internals::NumberPoints()
{
  auto numbers = FindFileNumbers(this->State, this->Part, this->State.Table.GetSharedPoints());
  auto next = static_cast<std::uint32_t>(this->State.Meta.Points - this->State.Meta.UnusedPoints);
  for (const auto point : this->Part.Layout.UnusedPoints)
  {
    numbers[point] = next++;
  }
  this->PointOrder = InvertOrder(numbers);
  return numbers;
}

//------------------------------------------------------------------------------
/** The number of each point in the file and in each base mesh; None if it has been merged. */
std::vector<std::vector<std::uint32_t>> FileWriter::Internals::NumberPointsOfAll()
{
  std::vector<std::vector<std::uint32_t>> all;
  all.push_back(this->NumberPoints());
  for (const auto& level : this->Levels)
  {
    const auto numbers = level->File->NumberPoints();
    auto& ofAll = all.emplace_back(all.front().size(), None);
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      ofAll[level->Mesh.GetPoints()[i]] = numbers[i];
    }
  }
  return all;
}

//------------------------------------------------------------------------------
/** tree: in the numbers of the file. */
void FileWriter::Internals::BeginTree(MergeTree tree)
{
  this->Tree.emplace(this->State, std::move(tree),
    [this](unsigned axis)
    {
      return [this, axis](std::uint32_t point)
      { return ArrayInput::Finite(this->Part.Mesh.GetCoordinate(this->PointOrder[point], axis)); };
    });
}

//------------------------------------------------------------------------------
/** Writes the merges, when the mesh and all base meshes have been written. */
void FileWriter::Internals::BeginTrees(const Progress& progress)
{
  const auto numbers = this->NumberPointsOfAll();
  auto numbersOfMerges = numbers.front(); // where each merge is stored
  for (const auto& ofLevel : numbers)
  {
    for (std::size_t point = 0; point < ofLevel.size(); ++point)
    {
      numbersOfMerges[point] = ofLevel[point] != None ? ofLevel[point] : numbersOfMerges[point];
    }
  }
  const MergeTree tree = SortRounds(*this->State.Options.Tree, numbersOfMerges, this->Merges);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    Internals& mesh = this->GetMeshOfTree(i);
    mesh.BeginTree(RenumberRest(tree, this->GetFirstMerge(i), numbers[i], mesh.State.Meta.Points));
    const bool isLast = i + 1 == numbers.size();
    const auto end =
      isLast ? static_cast<std::uint32_t>(tree.GetMerges().size()) : this->GetFirstMerge(i + 1);
    this->Tree->AddPart(*mesh.Tree, end - this->GetFirstMerge(i),
      isLast ? std::vector<std::uint32_t>() : MapPoints(numbers[i], numbers[i + 1]));
  }
  if (this->State.Options.Dependencies && !tree.GetMerges().empty())
  {
    this->WriteDependencies(tree, progress);
  }
}

//------------------------------------------------------------------------------
/** Writes the dependencies between the merges. tree: in the numbers of the given mesh. */
void FileWriter::Internals::WriteDependencies(const MergeTree& tree, const Progress& progress)
{
  const auto merges = static_cast<std::uint32_t>(tree.GetMerges().size());
  const Progress proceed = [&](double) { return !progress || progress(1); };
  const auto found =
    FindDependencies(this->Part.Mesh, tree, this->State.Options.IsSurface, proceed);
  if (!found)
  {
    return; // merges that would take long, which no builder makes
  }
  // From the coarsest mesh on, as all finer ones need its dependencies.
  const std::size_t meshes = this->Levels.size() + 1;
  for (std::size_t i = meshes; i-- > 0;)
  {
    const auto first = this->GetFirstMerge(i);
    const auto end = i + 1 < meshes ? this->GetFirstMerge(i + 1) : merges;
    if (first == end)
    {
      continue;
    }
    const auto stream = EncodeDependencies(
      this->GetMeshOfTree(i).Tree->GetTree(), SelectDependencies(*found, first, end), proceed);
    if (stream.empty())
    {
      return; // there are too many
    }
    this->Tree->AddDependencies(i, stream);
  }
}
}
