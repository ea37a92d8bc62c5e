// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChunkCacheInternals_h
#define gatunChunkCacheInternals_h

#include "gatunChunkCache.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace gatun
{
/** What a part is of. */
enum class PartKind : std::uint8_t
{
  BlockPoints,
  BlockOrder,
  BlockArray,
  ChunkMesh,
  ChunkFit,
  ChunkPointOrder,
  ChunkCellOrder,
  ChunkArray,
  Domains // of an array at a step; index 0
};

/** Names a part of a file; array and step are 0 but for arrays. */
struct PartKey
{
  PartKind Kind = PartKind::ChunkMesh;
  std::uint32_t Index = 0; // of the block or chunk
  std::uint32_t Array = 0;
  std::size_t Step = 0;

  auto operator<=>(const PartKey&) const = default;
};

/** The cache as decoders see it. Each kind of part is always of one and the same type. */
class ChunkCache::Internals
{
public:
  using Part = std::shared_ptr<const void>;

  Internals(std::shared_ptr<const FileReader> file, std::uint64_t budget)
    : File(std::move(file))
    , Budget(budget)
  {
  }

  /** The part, which then counts as just used, or null. */
  template <typename T>
  std::shared_ptr<const T> Find(const PartKey& key)
  {
    return std::static_pointer_cast<const T>(this->FindPart(key));
  }

  /** The part at the latest step not before first and not after key.Step, and that step. */
  template <typename T>
  std::pair<std::shared_ptr<const T>, std::size_t> FindLatest(const PartKey& key, std::size_t first)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    auto found = this->Parts.upper_bound(key);
    if (found == this->Parts.begin())
    {
      return {};
    }
    --found;
    auto from = key;
    from.Step = first;
    if (found->first < from)
    {
      return {};
    }
    return { std::static_pointer_cast<const T>(this->Use(found->second)), found->first.Step };
  }

  /** Keeps a part of so many bytes, all told, if the budget allows any part of that size. */
  void Keep(const PartKey& key, Part part, std::uint64_t bytes);

  /** Counts what was decoded and what was found. */
  void Count(std::uint64_t ChunkCacheStatistics::*what, std::uint64_t count = 1)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Done.*what += count;
  }

  const std::shared_ptr<const FileReader> File;

private:
  friend class ChunkCache;

  struct Entry
  {
    PartKey Key;
    Part Content;
    std::uint64_t Bytes = 0;
  };
  using List = std::list<Entry>;
  using Map = std::map<PartKey, List::iterator>;

  // What keeping a part takes besides the part: the nodes of list and map.
  static constexpr std::uint64_t Overhead =
    sizeof(Entry) + 2 * sizeof(void*) + sizeof(Map::value_type) + 4 * sizeof(void*);

  Part FindPart(const PartKey& key);
  Part Use(List::iterator entry);
  /** Takes out parts until so much is free; the caller destroys them, without the lock. */
  List MakeRoom(std::uint64_t bytes);

  mutable std::mutex Guard; // of all below
  std::uint64_t Budget;
  bool KeepsChunks = true;
  ChunkCacheStatistics Done;
  List Uses; // last used first
  Map Parts;
};

inline ChunkCache::Internals& InternalsOf(ChunkCache& cache)
{
  return *cache.Self;
}
}

#endif
