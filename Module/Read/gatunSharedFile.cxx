// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSharedFile.h"

#include "gatunError.h"
#include "gatunMeshDependencies.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
// Cells of a mesh that is decoded to find the dependencies of its merges.
constexpr std::uint64_t MostDecoded = 4'000'000;
}

//------------------------------------------------------------------------------
SharedFile::SharedFile(const std::string& path, std::uint64_t budget)
  : SharedFile(std::make_shared<const FileReader>(path), budget)
{
}

//------------------------------------------------------------------------------
SharedFile::SharedFile(std::shared_ptr<const FileReader> file, std::uint64_t budget)
  : SharedFile(std::move(file), std::make_shared<CacheBudget>(budget))
{
}

//------------------------------------------------------------------------------
SharedFile::SharedFile(std::shared_ptr<const FileReader> file, std::shared_ptr<CacheBudget> budget)
  : File(std::move(file))
  , Budget(std::move(budget))
{
  this->Levels.push_back({ 0, this->File, nullptr, nullptr });
  for (const auto merges : this->File->GetLevels())
  {
    this->Levels.push_back({ merges, nullptr, nullptr, nullptr });
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<SharedFile> SharedFile::GetMesh(std::size_t mesh)
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    const auto found = this->Meshes.find(mesh);
    if (found != this->Meshes.end())
    {
      return found->second;
    }
  }
  // A mesh with some of the cells of another one is decoded from the same parts.
  const auto parent =
    mesh < this->File->GetNumberOfMeshes() ? this->File->GetParentMesh(mesh) : mesh;
  const auto whole = parent == mesh || parent == 0 ? nullptr : this->GetMesh(parent);
  SharedFile& other = whole ? *whole : *this;
  std::shared_ptr<SharedFile> shared(new SharedFile(
    this->File->OpenMesh(mesh, parent == mesh ? nullptr : other.File), this->Budget));
  if (parent != mesh)
  {
    shared->Caches[shared->File.get()] =
      std::make_shared<ChunkCache>(*other.GetCache(other.File), shared->File);
    shared->IsPart = true;
  }
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Meshes.emplace(mesh, shared).first->second;
}

//------------------------------------------------------------------------------
std::shared_ptr<SharedFile> SharedFile::GetBoundary()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->Boundary)
  {
    this->Boundary.reset(new SharedFile(this->File->OpenBoundary(), this->Budget));
  }
  return this->Boundary;
}

//------------------------------------------------------------------------------
void SharedFile::RequireHierarchy() const
{
  if (!this->File->HasMergeTree())
  {
    ThrowInvalid("there is no hierarchy in the file; make one with gtn pack --hierarchy",
      this->File->GetPath());
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<ChunkCache> SharedFile::MakeView(
  const std::shared_ptr<const FileReader>& mesh, bool keepsChunks)
{
  return std::make_shared<ChunkCache>(this->GetCache(mesh), keepsChunks);
}

//------------------------------------------------------------------------------
std::shared_ptr<ChunkCache> SharedFile::GetCache(const std::shared_ptr<const FileReader>& mesh)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  auto& cache = this->Caches[mesh.get()];
  if (!cache)
  {
    cache = std::make_shared<ChunkCache>(mesh, this->Budget);
  }
  return cache;
}

//------------------------------------------------------------------------------
void SharedFile::Open(std::size_t level)
{
  if (!this->Levels[level].File)
  {
    this->Levels[level].File = this->File->OpenLevel(level - 1);
  }
}

//------------------------------------------------------------------------------
const std::shared_ptr<const MergeTree>& SharedFile::GetTree(Level& level)
{
  if (!level.Tree)
  {
    this->RequireHierarchy();
    level.Tree = std::make_shared<const MergeTree>(level.File->GetMergeTree());
  }
  return level.Tree;
}

//------------------------------------------------------------------------------
const MergeTree& SharedFile::GetTree()
{
  const std::lock_guard<std::mutex> lock(this->LevelGuard);
  return *this->GetTree(this->Levels.front());
}

//------------------------------------------------------------------------------
/** The level whose file it is. Only with the lock on the files. */
std::size_t SharedFile::FindLevel(const FileReader& file) const
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
std::shared_ptr<const MergeTree> SharedFile::GetTree(const FileReader& file)
{
  const std::lock_guard<std::mutex> lock(this->LevelGuard);
  return this->GetTree(this->Levels[this->FindLevel(file)]);
}

//------------------------------------------------------------------------------
std::shared_ptr<const MergeDependencies> SharedFile::GetDependencies(
  const FileReader& file, const std::function<bool(double)>& progress)
{
  const std::lock_guard<std::mutex> lock(this->DependencyGuard);
  std::shared_ptr<const FileReader> reader;
  std::shared_ptr<const MergeTree> tree;
  std::size_t level = 0;
  {
    const std::lock_guard<std::mutex> lockFiles(this->LevelGuard);
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
bool SharedFile::MayHaveDependencies(std::size_t level)
{
  const std::lock_guard<std::mutex> lock(this->LevelGuard);
  this->Open(level);
  const FileReader& file = *this->Levels[level].File;
  return file.HasDependencies() ||
    (file.IsSurface() ? file.GetNumberOfCells() : file.GetNumberOfTets()) <= MostDecoded;
}

//------------------------------------------------------------------------------
SharedFile::Place SharedFile::Find(std::size_t merges, bool withBaseMeshes)
{
  const std::lock_guard<std::mutex> lock(this->LevelGuard);
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
  const auto whole = more < tree->GetMerges().size() ? tree->CountMergesOfRounds(more) : more;
  return { level.File, whole > 0 ? tree : nullptr, whole };
}

//------------------------------------------------------------------------------
SharedFile::Place SharedFile::GetLevel(std::size_t level)
{
  const std::lock_guard<std::mutex> lock(this->LevelGuard);
  this->Open(level);
  return { this->Levels[level].File, this->GetTree(this->Levels[level]), 0 };
}

//------------------------------------------------------------------------------
std::uint64_t SharedFile::EstimateCells(std::size_t merges) const
{
  // Assumes that cells and points decrease in proportion.
  const FileReader& file = *this->File;
  const auto used = static_cast<double>(file.GetNumberOfPoints() - file.GetNumberOfUnusedPoints());
  const double left = used > 0 ? std::max(0.0, used - static_cast<double>(merges)) / used : 1;
  const auto cells = file.IsSurface() ? file.GetNumberOfCells() : file.GetNumberOfTets();
  return static_cast<std::uint64_t>(left * static_cast<double>(cells));
}

//------------------------------------------------------------------------------
ChunkCacheStatistics SharedFile::GetStatistics() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  ChunkCacheStatistics sum;
  const auto add = [&sum](const ChunkCacheStatistics& one)
  {
    sum.Bytes += one.Bytes;
    sum.PeakBytes = std::max(sum.PeakBytes, one.PeakBytes);
    sum.MeshesDecoded += one.MeshesDecoded;
    sum.MeshesFound += one.MeshesFound;
    sum.ArraysDecoded += one.ArraysDecoded;
    sum.ArraysFound += one.ArraysFound;
  };
  for (const auto& entry : this->Caches)
  {
    auto one = entry.second->GetStatistics();
    one.Bytes = this->IsPart ? 0 : one.Bytes; // of the mesh with all cells
    add(one);
  }
  for (const auto& entry : this->Meshes)
  {
    add(entry.second->GetStatistics());
  }
  return sum;
}

//------------------------------------------------------------------------------
std::uint64_t SharedFile::GetBytesRead() const
{
  std::uint64_t read = 0;
  {
    const std::lock_guard<std::mutex> lock(this->LevelGuard);
    for (const Level& level : this->Levels)
    {
      read += level.File ? level.File->GetBytesRead() : 0;
    }
  }
  const std::lock_guard<std::mutex> lock(this->Guard);
  read += this->Boundary ? this->Boundary->GetBytesRead() : 0;
  for (const auto& entry : this->Meshes)
  {
    read += entry.second->IsPart ? 0 : entry.second->GetBytesRead();
  }
  return read;
}
}
