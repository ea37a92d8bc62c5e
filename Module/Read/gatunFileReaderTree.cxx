// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileReader: merge tree and base meshes.

#include "gatunDependencyCodec.h"
#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunMergeCodec.h"
#include "gatunMergeDependencies.h"

#include <algorithm>
#include <cstddef>

namespace gatun
{
namespace
{
constexpr const char* TreeName = "the table of merges";
constexpr const char* TreeStepName = "the ranges after merges";
constexpr const char* MergesName = "the stream of merges";
constexpr const char* MapName = "the numbers of points in a base mesh";
constexpr const char* DependenciesName = "the dependencies of merges";

/** The merge count of a number of merges. Throws if the file has fewer merges. */
std::size_t FindMergeCount(const FileReader::Internals& file, std::size_t merges)
{
  if (merges > file.Tree->Merges)
  {
    ThrowInvalid("the file has fewer merges than that", file.File.GetPath());
  }
  return file.Tree->FindMergeCount(merges);
}

void CheckLevelNumber(const FileReader& file, std::size_t level)
{
  if (level >= file.GetLevels().size())
  {
    ThrowInvalid("there is no such base mesh", file.GetPath());
  }
}
}

//------------------------------------------------------------------------------
void FileReader::Internals::ReadTree()
{
  const auto fail = [&](const char* what) { this->File.Fail(ErrorCode::Corrupt, what); };
  const auto trees = this->File.FindSections(SectionTree);
  if (trees.empty())
  {
    return;
  }
  const auto tree = this->File.FindSection(SectionTree, TreeName);
  this->Tree = this->File.Guarded(TreeName, tree,
    [&]
    {
      return TreeTable::Read(this->File.Read(tree, TreeName), this->Meta,
        this->GetTables().GetChunks().size(), this->IsSurface);
    });
  for (const auto& step : this->File.FindSections(SectionTreeStep))
  {
    if (this->TreeSteps.size() == this->GetSteps().size())
    {
      fail("there are ranges after merges of more time steps than there are");
    }
    this->TreeSteps.push_back(this->File.Guarded(TreeStepName, step,
      [&]
      {
        const auto bytes = this->File.Read(step, TreeStepName);
        auto table =
          TreeStepTable::Read(bytes, this->Meta, this->GetTables().GetChunks().size(), *this->Tree);
        this->AddStepBytes(bytes);
        return table;
      }));
  }
  if (this->TreeSteps.size() != this->GetSteps().size())
  {
    fail("the ranges after merges of some time steps are missing");
  }
  this->Levels = this->File.FindSections(SectionLevel);
  if (this->Levels.size() != this->Tree->Levels.size())
  {
    fail("there are not as many base meshes as the file says");
  }
}

//------------------------------------------------------------------------------
/** Throws if there is a tree without merges, as base meshes have it. */
void FileReader::Internals::RequireMerges() const
{
  if (this->Tree && this->Tree->Parts.empty())
  {
    this->File.Fail(ErrorCode::Corrupt, "the merges of its tree are missing");
  }
}

//------------------------------------------------------------------------------
/** Throws unless this can be a base mesh of the whole. */
void FileReader::Internals::CheckLevel(const Internals& whole, std::size_t level) const
{
  const auto merges = whole.Tree->Levels[level];
  const bool fits = this->Meta.Points == whole.Meta.Points - merges &&
    this->Meta.UnusedPoints >= whole.Meta.UnusedPoints && this->Meta.Tets <= whole.Meta.Tets &&
    this->Meta.CoordinateType == whole.Meta.CoordinateType &&
    this->Meta.Arrays == whole.Meta.Arrays && this->Meta.HasTime == whole.Meta.HasTime &&
    this->Times == whole.Times && this->Levels.empty() && !this->Boundary && this->Tree &&
    this->IsSurface == whole.IsSurface && this->Tree->Merges == whole.Tree->Merges - merges &&
    this->Tree->Parts.empty() &&
    CountMergeablePoints(this->Meta, this->IsSurface) == whole.Tree->Parts[level + 1].Points;
  if (!fits)
  {
    this->File.Fail(ErrorCode::Corrupt, "it is not what is left of the mesh after its merges");
  }
}

//------------------------------------------------------------------------------
bool FileReader::HasMergeTree() const
{
  return this->Self->Tree.has_value();
}

//------------------------------------------------------------------------------
std::size_t FileReader::GetNumberOfMerges() const
{
  return this->HasMergeTree() ? this->Self->Tree->Merges : 0;
}

/** The merges of a mesh and all that follow, in the numbers of the mesh. */
MergeTree FileReader::Internals::ReadMerges(std::size_t part) const
{
  const auto points =
    static_cast<std::uint32_t>(this->Meta.Points - this->Tree->GetFirstMerge(part));
  const TreePart& where = this->Tree->Parts[part];
  MergeTree tree(points, {});
  if (where.Merges.Length > 0)
  {
    tree = this->File.Guarded(MergesName, where.Merges,
      [&]
      {
        return DecodeMerges(this->File.Read(where.Merges, MergesName), where.Points,
          this->Tree->GetMergesOfPart(part),
          this->IsSurface ? MergeKind::Surface : MergeKind::Tetrahedra);
      });
    if (where.Points != points) // others come last and are never merged
    {
      tree = MergeTree(points, tree.GetMerges(), {}, tree.GetRounds());
    }
  }
  if (where.Map.Length == 0)
  {
    return tree;
  }
  const MergeTree rest = this->ReadMerges(part + 1);
  return this->File.Guarded(MapName, where.Map,
    [&]
    {
      const auto map =
        DecodePointMap(this->File.Read(where.Map, MapName), rest.GetNumberOfPoints());
      return JoinMerges(tree, rest, map);
    });
}

//------------------------------------------------------------------------------
/** The dependencies of these merges. tree: ReadMerges(part). */
MergeDependencies FileReader::Internals::ReadDependencies(
  std::size_t part, const MergeTree& tree) const
{
  const StreamRef& where = this->Tree->Parts[part].Dependencies;
  if (where.Length == 0) // no merges
  {
    return {};
  }
  auto dependencies = this->File.Guarded(DependenciesName, where,
    [&] { return DecodeDependencies(this->File.Read(where, DependenciesName), tree); });
  if (part + 1 == this->Tree->Parts.size())
  {
    return dependencies;
  }
  return JoinDependencies(dependencies, this->Tree->GetMergesOfPart(part),
    this->ReadDependencies(part + 1, this->ReadMerges(part + 1)));
}

//------------------------------------------------------------------------------
MergeTree FileReader::GetMergeTree() const
{
  if (this->GetNumberOfMerges() == 0)
  {
    return { static_cast<std::uint32_t>(this->GetNumberOfPoints()), {} };
  }
  const Internals& owner = this->Self->GetOwnerOfMerges();
  std::vector<StreamRef> streams;
  for (auto part = this->Self->Part; part < owner.Tree->Parts.size(); ++part)
  {
    streams.push_back(owner.Tree->Parts[part].Merges);
    streams.push_back(owner.Tree->Parts[part].Map);
  }
  std::erase_if(streams, [](const StreamRef& stream) { return stream.Length == 0; });
  MergeTree tree;
  owner.File.ReadTogether(streams, [&] { tree = owner.ReadMerges(this->Self->Part); });
  return tree;
}

//------------------------------------------------------------------------------
bool FileReader::HasDependencies() const
{
  const auto& tree = this->Self->GetOwnerOfMerges().Tree;
  return tree && this->GetNumberOfMerges() > 0 &&
    std::all_of(tree->Parts.begin() + static_cast<std::ptrdiff_t>(this->Self->Part),
      tree->Parts.end(),
      [](const TreePart& part) { return part.Merges.Length == 0 || part.Dependencies.Length > 0; });
}

//------------------------------------------------------------------------------
MergeDependencies FileReader::ReadDependencies(const MergeTree& tree) const
{
  if (!this->HasDependencies())
  {
    ThrowInvalid("the file has no dependencies of merges", this->GetPath());
  }
  if (tree.GetMerges().size() != this->GetNumberOfMerges() ||
    tree.GetNumberOfPoints() != this->GetNumberOfPoints())
  {
    ThrowInvalid("the tree of merges is not that of the file", this->GetPath());
  }
  return this->Self->GetOwnerOfMerges().ReadDependencies(this->Self->Part, tree);
}

//------------------------------------------------------------------------------
const std::vector<std::uint32_t>& FileReader::GetLevels() const
{
  static const std::vector<std::uint32_t> none;
  return this->HasMergeTree() ? this->Self->Tree->Levels : none;
}

//------------------------------------------------------------------------------
std::shared_ptr<const FileReader> FileReader::OpenLevel(std::size_t level) const
{
  CheckLevelNumber(*this, level);
  return std::shared_ptr<const FileReader>(
    new FileReader(std::make_unique<Internals>(this->Self, level)));
}

//------------------------------------------------------------------------------
MeshCounts FileReader::CountLevel(std::size_t level) const
{
  CheckLevelNumber(*this, level);
  return Internals::Count(*this->Self, this->Self->Levels[level], Internals::GetLevelName(level));
}

//------------------------------------------------------------------------------
const Bounds& FileReader::GetChunkBounds(std::size_t chunk, std::size_t merges) const
{
  if (merges == 0 || !this->HasMergeTree())
  {
    return this->GetChunks().at(chunk).Box;
  }
  return this->Self->Tree->Boxes.at(chunk)[FindMergeCount(*this->Self, merges)];
}

//------------------------------------------------------------------------------
ArrayRanges FileReader::GetChunkRanges(
  std::size_t array, std::size_t step, std::size_t chunk, std::size_t merges) const
{
  return this->GetRangesAfter(static_cast<std::uint32_t>(array), step, chunk, merges);
}

//------------------------------------------------------------------------------
ArrayRanges FileReader::GetRangesAfter(
  std::uint32_t array, std::size_t step, std::size_t chunk, std::size_t merges) const
{
  const bool ofPoints = this->Self->Meta.Arrays.at(array).Where == Association::Point;
  if (merges == 0 || !this->HasMergeTree() || !ofPoints)
  {
    return this->Self->GetTables().GetChunkRanges(chunk, array, step);
  }
  const auto& mergeCounts = this->Self->TreeSteps.at(step).Ranges.at(array).at(chunk);
  return mergeCounts[FindMergeCount(*this->Self, merges)];
}
}
