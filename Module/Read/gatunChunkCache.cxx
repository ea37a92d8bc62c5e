// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkCache.h"

#include "gatunChunkCacheInternals.h"

#include <algorithm>

namespace gatun
{
namespace
{
bool IsOfChunk(PartKind kind)
{
  switch (kind)
  {
    case PartKind::BlockQuadratic: // large, and only worth it for several arrays or steps
    case PartKind::ChunkMesh:
    case PartKind::ChunkFit:
    case PartKind::ChunkQuadratic:
    case PartKind::ChunkCellQuadratic:
    case PartKind::ChunkPointOrder:
    case PartKind::ChunkCellOrder:
    case PartKind::ChunkArray:
      return true;
    default:
      return false;
  }
}
}

//------------------------------------------------------------------------------
void ChunkCache::Internals::Keep(const PartKey& key, Part part, std::uint64_t bytes)
{
  const bool isOfChunk = IsOfChunk(key.Kind);
  if (isOfChunk && !this->KeepsChunks)
  {
    return;
  }
  this->Parts->Keep(key, std::move(part), bytes);
  if (isOfChunk && !this->KeepsChunks && !this->Other) // turned off meanwhile
  {
    this->RemoveChunks();
  }
}

//------------------------------------------------------------------------------
void ChunkCache::Internals::RemoveBlocks(const std::vector<std::uint32_t>& blocks)
{
  this->Parts->RemoveIf(
    [&](const PartKey& key)
    {
      return key.Kind != PartKind::Domains && !IsOfChunk(key.Kind) &&
        std::binary_search(blocks.begin(), blocks.end(), key.Index);
    });
}

//------------------------------------------------------------------------------
void ChunkCache::Internals::RemoveChunks()
{
  this->Parts->RemoveIf([](const PartKey& key) { return IsOfChunk(key.Kind); });
}

//------------------------------------------------------------------------------
ChunkCache::ChunkCache(std::shared_ptr<const FileReader> file, std::uint64_t budget)
  : ChunkCache(std::move(file), std::make_shared<CacheBudget>(budget))
{
}

ChunkCache::ChunkCache(std::shared_ptr<const FileReader> file, std::shared_ptr<CacheBudget> budget)
  : Self(std::make_unique<Internals>(std::move(file), std::move(budget)))
{
}

ChunkCache::ChunkCache(const std::shared_ptr<ChunkCache>& other, bool keepsChunks)
  : Self(std::make_unique<Internals>(other, keepsChunks))
{
}

ChunkCache::ChunkCache(const ChunkCache& other, std::shared_ptr<const FileReader> file)
  : Self(std::make_unique<Internals>(std::move(file), *other.Self))
{
}

ChunkCache::~ChunkCache() = default;

//------------------------------------------------------------------------------
const std::shared_ptr<const FileReader>& ChunkCache::GetFile() const
{
  return this->Self->File;
}

//------------------------------------------------------------------------------
const std::shared_ptr<CacheBudget>& ChunkCache::GetSharedBudget() const
{
  return this->Self->Parts->GetBudget();
}

//------------------------------------------------------------------------------
void ChunkCache::SetBudget(std::uint64_t bytes)
{
  this->GetSharedBudget()->SetBytes(bytes);
}

//------------------------------------------------------------------------------
std::uint64_t ChunkCache::GetBudget() const
{
  return this->GetSharedBudget()->GetBytes();
}

//------------------------------------------------------------------------------
void ChunkCache::SetKeepsChunks(bool keeps)
{
  this->Self->KeepsChunks = keeps;
  if (!keeps && !this->Self->Other)
  {
    this->Self->RemoveChunks();
  }
}

//------------------------------------------------------------------------------
ChunkCacheStatistics ChunkCache::GetStatistics() const
{
  const auto parts = this->Self->Parts->GetStatistics();
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  auto all = this->Self->Done;
  all.Bytes = parts.Bytes;
  all.PeakBytes = parts.PeakBytes;
  return all;
}

//------------------------------------------------------------------------------
void ChunkCache::Clear()
{
  this->Self->Parts->Clear();
}
}
