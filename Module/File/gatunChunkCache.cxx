// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkCache.h"

#include "gatunChunkCacheInternals.h"

#include <algorithm>
#include <iterator>
#include <new>

namespace gatun
{
//--------------------------------------------------------------------------------------------------
ChunkCache::Internals::Part ChunkCache::Internals::FindPart(const PartKey& key)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const auto found = this->Parts.find(key);
  return found == this->Parts.end() ? nullptr : this->Use(found->second);
}

ChunkCache::Internals::Part ChunkCache::Internals::Use(List::iterator entry)
{
  this->Uses.splice(this->Uses.begin(), this->Uses, entry);
  return entry->Content;
}

namespace
{
bool IsOfChunk(PartKind kind)
{
  switch (kind)
  {
    case PartKind::ChunkMesh:
    case PartKind::ChunkFit:
    case PartKind::ChunkPointOrder:
    case PartKind::ChunkCellOrder:
    case PartKind::ChunkArray:
      return true;
    default:
      return false;
  }
}
}

void ChunkCache::Internals::Keep(const PartKey& key, Part part, std::uint64_t bytes)
{
  bytes += Overhead;
  List dropped; // destroyed without the lock
  List added;
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (bytes > this->Budget || this->Parts.count(key) > 0 ||
    (IsOfChunk(key.Kind) && !this->KeepsChunks))
  {
    return;
  }
  dropped = this->MakeRoom(bytes);
  try
  {
    added.push_back({ key, std::move(part), bytes });
    this->Parts.emplace(key, added.begin());
  }
  catch (const std::bad_alloc&)
  {
    return; // what was decoded is no worse for not being kept
  }
  this->Uses.splice(this->Uses.begin(), added);
  this->Done.Bytes += bytes;
  this->Done.PeakBytes = std::max(this->Done.PeakBytes, this->Done.Bytes);
}

ChunkCache::Internals::List ChunkCache::Internals::MakeRoom(std::uint64_t bytes)
{
  List dropped;
  while (!this->Uses.empty() && this->Done.Bytes + bytes > this->Budget)
  {
    const auto last = std::prev(this->Uses.end());
    this->Parts.erase(last->Key);
    this->Done.Bytes -= last->Bytes;
    dropped.splice(dropped.begin(), this->Uses, last);
  }
  return dropped;
}

//--------------------------------------------------------------------------------------------------
ChunkCache::ChunkCache(std::shared_ptr<const FileReader> file, std::uint64_t budget)
  : Self(std::make_unique<Internals>(std::move(file), budget))
{
}

ChunkCache::~ChunkCache() = default;

const std::shared_ptr<const FileReader>& ChunkCache::GetFile() const
{
  return this->Self->File;
}

void ChunkCache::SetBudget(std::uint64_t bytes)
{
  Internals::List dropped;
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  this->Self->Budget = bytes;
  dropped = this->Self->MakeRoom(0);
  this->Self->Done.PeakBytes = this->Self->Done.Bytes;
}

std::uint64_t ChunkCache::GetBudget() const
{
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  return this->Self->Budget;
}

void ChunkCache::SetKeepsChunks(bool keeps)
{
  Internals::List dropped; // destroyed without the lock
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  this->Self->KeepsChunks = keeps;
  auto& uses = this->Self->Uses;
  for (auto it = uses.begin(); !keeps && it != uses.end();)
  {
    const auto next = std::next(it);
    if (IsOfChunk(it->Key.Kind))
    {
      this->Self->Done.Bytes -= it->Bytes;
      this->Self->Parts.erase(it->Key);
      dropped.splice(dropped.end(), uses, it);
    }
    it = next;
  }
}

ChunkCacheStatistics ChunkCache::GetStatistics() const
{
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  return this->Self->Done;
}

void ChunkCache::Clear()
{
  Internals::Map parts;
  Internals::List uses;
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  parts.swap(this->Self->Parts);
  uses.swap(this->Self->Uses);
  this->Self->Done.Bytes = 0;
}
}
