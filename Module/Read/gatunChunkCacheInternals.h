// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkCacheInternals_h
#define gatunChunkCacheInternals_h

#include "gatunCache.h"
#include "gatunChunkCache.h"

#include <atomic>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace gatun
{
/** The kinds of parts. */
enum class PartKind : std::uint8_t
{
  BlockPoints,
  BlockOrder,
  BlockQuadratic,
  BlockArray,
  ChunkMesh,
  ChunkFit,
  ChunkQuadratic,
  ChunkCellQuadratic,
  ChunkPointOrder,
  ChunkCellOrder,
  ChunkArray,
  Domains // of an array at a step; index 0
};

/** Names a part of a file; array and step are 0 except for arrays. */
struct PartKey
{
  PartKind Kind = PartKind::ChunkMesh;
  std::uint32_t Index = 0; // of the block or chunk
  std::uint32_t Array = 0;
  std::size_t Step = 0;

  auto operator<=>(const PartKey&) const = default; // NOLINT(modernize-use-nullptr)
};

/** The cache as decoders see it. All parts of a kind have the same type. */
class ChunkCache::Internals
{
public:
  using Part = std::shared_ptr<const void>;

  Internals(std::shared_ptr<const FileReader> file, std::shared_ptr<CacheBudget> budget)
    : File(std::move(file))
    , Parts(std::make_shared<Cache<PartKey, void>>(std::move(budget)))
  {
  }

  Internals(std::shared_ptr<ChunkCache> other, bool keepsChunks)
    : File(other->GetFile())
    , Other(std::move(other))
    , Parts(this->Other->Self->Parts)
    , KeepsChunks(keepsChunks)
  {
  }

  /** For a file with the same streams as that of another cache. */
  Internals(std::shared_ptr<const FileReader> file, const Internals& other)
    : File(std::move(file))
    , Parts(other.Parts)
  {
  }

  /** The part, which then counts as just used, or null. */
  template <typename T>
  std::shared_ptr<const T> Find(const PartKey& key)
  {
    return std::static_pointer_cast<const T>(this->Parts->Find(key));
  }

  /** The part at the latest step not before first and not after key.Step, and that step. */
  template <typename T>
  std::pair<std::shared_ptr<const T>, std::size_t> FindLatest(const PartKey& key, std::size_t first)
  {
    auto from = key;
    from.Step = first;
    const auto found = this->Parts->FindLast(from, key);
    if (!found)
    {
      return {};
    }
    return { std::static_pointer_cast<const T>(found->second), found->first.Step };
  }

  /** Keeps a part that takes a given number of bytes, if the budget allows any part of that size.
   */
  void Keep(const PartKey& key, Part part, std::uint64_t bytes);

  /** Removes the points, orders and arrays of some blocks, which must be ascending. */
  void RemoveBlocks(const std::vector<std::uint32_t>& blocks);

  /** Counts decoded and found parts. */
  void Count(std::uint64_t ChunkCacheStatistics::*what, std::uint64_t count = 1)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      this->Done.*what += count;
    }
    if (this->Other)
    {
      this->Other->Self->Count(what, count);
    }
  }

  const std::shared_ptr<const FileReader> File;

private:
  friend class ChunkCache;

  void RemoveChunks();

  const std::shared_ptr<ChunkCache> Other; // null unless this is a view
  const std::shared_ptr<Cache<PartKey, void>> Parts;
  std::atomic<bool> KeepsChunks{ true };
  mutable std::mutex Guard; // of what follows
  ChunkCacheStatistics Done;
};

inline ChunkCache::Internals& InternalsOf(ChunkCache& cache)
{
  return *cache.Self;
}
}

#endif
