// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSimplifiedFile.h"

#include "gatunError.h"
#include "gatunMeshDependencies.h"

#include <algorithm>

namespace gatun
{
namespace
{
// Cells of a mesh that is decoded to find the dependencies of its merges.
constexpr std::uint64_t MostDecoded = 4'000'000;
}

//------------------------------------------------------------------------------
SimplifiedFile::SimplifiedFile(std::shared_ptr<const FileReader> file)
{
  if (!file->HasMergeTree())
  {
    ThrowInvalid(
      "there is no hierarchy in the file; make one with gtn pack --hierarchy", file->GetPath());
  }
  this->Levels.push_back({ 0, file, nullptr, nullptr });
  for (const auto merges : file->GetLevels())
  {
    this->Levels.push_back({ merges, nullptr, nullptr, nullptr });
  }
}

//------------------------------------------------------------------------------
void SimplifiedFile::Open(std::size_t level)
{
  if (!this->Levels[level].File)
  {
    this->Levels[level].File = this->GetFile()->OpenLevel(level - 1);
  }
}

//------------------------------------------------------------------------------
const std::shared_ptr<const MergeTree>& SimplifiedFile::GetTree(Level& level)
{
  if (!level.Tree)
  {
    level.Tree = std::make_shared<const MergeTree>(level.File->GetMergeTree());
  }
  return level.Tree;
}

//------------------------------------------------------------------------------
const MergeTree& SimplifiedFile::GetTree()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return *this->GetTree(this->Levels.front());
}

//------------------------------------------------------------------------------
/** The level whose file it is. Only with the lock on the files. */
std::size_t SimplifiedFile::FindLevel(const FileReader& file) const
{
  const auto level = std::find_if(this->Levels.begin(), this->Levels.end(),
    [&](const Level& one) { return one.File.get() == &file; });
  if (level == this->Levels.end())
  {
    ThrowInvalid("the mesh is none of this file", file.GetPath());
  }
  return static_cast<std::size_t>(level - this->Levels.begin());
}

//------------------------------------------------------------------------------
std::shared_ptr<const MergeTree> SimplifiedFile::GetTree(const FileReader& file)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->GetTree(this->Levels[this->FindLevel(file)]);
}

//------------------------------------------------------------------------------
std::shared_ptr<const MergeDependencies> SimplifiedFile::GetDependencies(
  const FileReader& file, const std::function<bool(double)>& progress)
{
  const std::lock_guard<std::mutex> lock(this->DependencyGuard);
  std::shared_ptr<const FileReader> reader;
  std::shared_ptr<const MergeTree> tree;
  std::size_t level = 0;
  {
    const std::lock_guard<std::mutex> lockFiles(this->Guard);
    level = this->FindLevel(file);
    reader = this->Levels[level].File;
    tree = this->GetTree(this->Levels[level]);
  }
  auto& dependencies = this->Levels[level].Dependencies;
  const auto cells = reader->IsSurface() ? reader->GetNumberOfCells() : reader->GetNumberOfTets();
  if (!dependencies && reader->HasDependencies())
  {
    dependencies = std::make_shared<const MergeDependencies>(reader->ReadDependencies(*tree));
  }
  else if (!dependencies && cells <= MostDecoded)
  {
    if (auto found = FindDependencies(reader, *tree, progress))
    {
      dependencies = std::make_shared<const MergeDependencies>(*std::move(found));
    }
  }
  return dependencies;
}

//------------------------------------------------------------------------------
SimplifiedFile::Place SimplifiedFile::Find(std::size_t merges, bool withBaseMeshes)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  std::size_t found = 0;
  for (std::size_t i = 0; withBaseMeshes && i < this->Levels.size(); ++i)
  {
    found = this->Levels[i].Merges <= merges ? i : found;
  }
  this->Open(found);
  Level& level = this->Levels[found];
  const auto more = merges - level.Merges;
  if (more == 0)
  {
    return { level.File, nullptr, 0 };
  }
  const auto& tree = this->GetTree(level);
  const auto whole = more < tree->GetMerges().size() ? tree->CountWholeMerges(more) : more;
  return { level.File, whole > 0 ? tree : nullptr, whole };
}

//------------------------------------------------------------------------------
SimplifiedFile::Place SimplifiedFile::GetLevel(std::size_t level)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Open(level);
  return { this->Levels[level].File, this->GetTree(this->Levels[level]), 0 };
}

//------------------------------------------------------------------------------
std::uint64_t SimplifiedFile::EstimateCells(std::size_t merges) const
{
  // Assumes that cells and points decrease in proportion.
  const FileReader& file = *this->GetFile();
  const auto used = static_cast<double>(file.GetNumberOfPoints() - file.GetNumberOfUnusedPoints());
  const double left = used > 0 ? std::max(0.0, used - static_cast<double>(merges)) / used : 1;
  const auto cells = file.IsSurface() ? file.GetNumberOfCells() : file.GetNumberOfTets();
  return static_cast<std::uint64_t>(left * static_cast<double>(cells));
}

//------------------------------------------------------------------------------
std::uint64_t SimplifiedFile::GetBytesRead() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  std::uint64_t bytes = 0;
  for (const Level& level : this->Levels)
  {
    bytes += level.File ? level.File->GetBytesRead() : 0;
  }
  return bytes;
}
}
