// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSharedFile.h"

#include <algorithm>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
SharedFile::SharedFile(const std::string& path, std::uint64_t budget)
  : File(std::make_shared<const FileReader>(path))
  , Budget(std::make_shared<CacheBudget>(budget))
{
}

//------------------------------------------------------------------------------
SharedFile::SharedFile(std::shared_ptr<const FileReader> file, std::shared_ptr<CacheBudget> budget)
  : File(std::move(file))
  , Budget(std::move(budget))
{
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
SimplifiedFile& SharedFile::GetHierarchy()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->Hierarchy)
  {
    this->Hierarchy = std::make_unique<SimplifiedFile>(this->File);
  }
  return *this->Hierarchy;
}

//------------------------------------------------------------------------------
std::shared_ptr<const FileReader> SharedFile::GetBoundary()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->Boundary)
  {
    this->Boundary = this->File->OpenBoundary();
  }
  return this->Boundary;
}

//------------------------------------------------------------------------------
SimplifiedFile& SharedFile::GetBoundaryHierarchy()
{
  auto boundary = this->GetBoundary();
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->BoundaryHierarchy)
  {
    this->BoundaryHierarchy = std::make_unique<SimplifiedFile>(std::move(boundary));
  }
  return *this->BoundaryHierarchy;
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
  const std::lock_guard<std::mutex> lock(this->Guard);
  auto read = this->Hierarchy ? this->Hierarchy->GetBytesRead() : this->File->GetBytesRead();
  read += this->Boundary ? this->Boundary->GetBytesRead() : 0;
  for (const auto& entry : this->Meshes)
  {
    read += entry.second->IsPart ? 0 : entry.second->GetBytesRead();
  }
  return read;
}
}
