// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileReader: merge tree and base meshes.

#include "gatunDependencyCodec.h"
#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunMergeCodec.h"
#include "gatunMergeDependencies.h"

namespace gatun
{
namespace
{
constexpr const char* TreeName = "the table of merges";
constexpr const char* TreeStepName = "the ranges after merges";
constexpr const char* MergesName = "the stream of merges";
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
  if (!this->File.FindSections(SectionDependencies).empty())
  {
    this->Dependencies = this->File.FindSection(SectionDependencies, DependenciesName);
  }
  this->Levels = this->File.FindSections(SectionLevel);
  if (this->Levels.size() != this->Tree->Levels.size())
  {
    fail("there are not as many base meshes as the file says");
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
    this->IsSurface == whole.IsSurface && this->Tree->Merges == whole.Tree->Merges - merges;
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

//------------------------------------------------------------------------------
MergeTree FileReader::GetMergeTree() const
{
  const auto points = static_cast<std::uint32_t>(this->GetNumberOfPoints());
  if (this->GetNumberOfMerges() == 0)
  {
    return { points, {} };
  }
  const auto& where = this->Self->Tree->Stream;
  return this->Self->File.Guarded(MergesName, where,
    [&]
    {
      // Unused points come last and are never merged, but those of surfaces.
      const bool isSurface = this->IsSurface();
      const auto used = CountMergeablePoints(this->Self->Meta, isSurface);
      auto tree = DecodeMerges(this->Self->File.Read(where, MergesName), used,
        this->Self->Tree->Merges, isSurface ? MergeKind::Surface : MergeKind::Tetrahedra);
      return used == points ? tree : MergeTree(points, tree.GetMerges());
    });
}

//------------------------------------------------------------------------------
bool FileReader::HasDependencies() const
{
  return this->Self->Dependencies.has_value();
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
  const StreamRef& where = *this->Self->Dependencies;
  return this->Self->File.Guarded(DependenciesName, where,
    [&] { return DecodeDependencies(this->Self->File.Read(where, DependenciesName), tree); });
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
    new FileReader(std::make_unique<Internals>(*this->Self, level)));
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
