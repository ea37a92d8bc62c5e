// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunCache_h
#define gatunCache_h

#include "gatunCacheBudgetInternals.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <utility>

namespace gatun
{
/** Which entries a new one may remove. */
enum class CachePolicy
{
  LeastRecentlyUsed, ///< the least recently used ones
  KeepLast,          ///< the same, and all others if it exceeds the budget by itself
  KeepFirst          ///< none; for users that go through all keys in a cycle
};

/**
 * A map from keys to immutable parts, within a budget that it may share with other caches. Part may
 * be void, if the key determines the type of the part.
 *
 * Thread safe. Parts are never destroyed while a lock is held. Two threads that miss the same key
 * may both make its part; the first one is kept.
 */
template <typename Key, typename Part>
class Cache final : public CacheUser
{
public:
  using Pointer = std::shared_ptr<const Part>;

  /** The memory that an entry takes besides its part: the nodes of list and map. */
  static constexpr std::uint64_t Overhead =
    sizeof(Entry) + 2 * sizeof(void*) + sizeof(Key) + 5 * sizeof(void*);

  explicit Cache(
    std::shared_ptr<CacheBudget> budget, CachePolicy policy = CachePolicy::LeastRecentlyUsed)
    : CacheUser(std::move(budget))
    , Policy(policy)
  {
  }
  ~Cache() override { this->Clear(); }

  /** The part, which then counts as the one used last, or null. */
  Pointer Find(const Key& key)
  {
    const std::lock_guard<std::mutex> lock(this->GetGuard());
    const auto found = this->Places.find(key);
    return found == this->Places.end() ? nullptr : this->UsePart(found);
  }

  /** The part with the largest key that is not before first and not after last, and that key. */
  std::optional<std::pair<Key, Pointer>> FindLast(const Key& first, const Key& last)
  {
    const std::lock_guard<std::mutex> lock(this->GetGuard());
    auto found = this->Places.upper_bound(last);
    if (found == this->Places.begin())
    {
      return std::nullopt;
    }
    --found;
    if (found->first < first)
    {
      return std::nullopt;
    }
    return std::pair{ found->first, this->UsePart(found) };
  }

  /** Finds a part, or makes and offers it. Its GetBytes() returns its memory. Made: the type of the
   * part, if that depends on the key. */
  template <typename Made = Part, typename Make>
  std::shared_ptr<const Made> FindOrMake(const Key& key, Make&& make)
  {
    if (auto found = this->Find(key))
    {
      return std::static_pointer_cast<const Made>(std::move(found));
    }
    auto made = std::make_shared<const Made>(make());
    this->Keep(key, made, made->GetBytes());
    return made;
  }

  /** Offers a part. Bytes: its memory. A part whose key is here already is not kept, nor is one
   * that exceeds the budget, unless the policy is KeepLast. Nor is one for which there is no memory
   * left; nothing is thrown. */
  void Keep(const Key& key, Pointer part, std::uint64_t bytes)
  {
    bytes += std::min(Overhead, ~bytes);
    Entries dropped; // destroyed without the lock
    Entries added;
    const std::lock_guard<std::mutex> lock(this->GetGuard());
    this->CountMade();
    const bool isWelcome = this->Policy == CachePolicy::KeepFirst ? this->HasRoom(bytes)
      : this->Policy == CachePolicy::KeepLast                     ? true
                                                                  : this->CanFit(bytes);
    if (!isWelcome)
    {
      return;
    }
    try
    {
      added.push_back({ this, nullptr, std::move(part), bytes });
      const auto [place, isNew] = this->Places.try_emplace(key, added.begin());
      if (!isNew)
      {
        return;
      }
      added.front().Key = &place->first;
    }
    catch (const std::bad_alloc&)
    {
      return; // the caller has the part
    }
    this->MakeRoom(bytes, dropped);
    this->Add(added);
  }

  /** Removes the parts whose keys are chosen. The function must not use the cache. */
  void RemoveIf(const std::function<bool(const Key&)>& choose)
  {
    Entries dropped; // destroyed without the lock
    const std::lock_guard<std::mutex> lock(this->GetGuard());
    for (auto place = this->Places.begin(); place != this->Places.end();)
    {
      if (!choose(place->first))
      {
        ++place;
        continue;
      }
      this->Drop(place->second, dropped);
      place = this->Places.erase(place);
    }
  }

  void Clear()
  {
    this->RemoveIf([](const Key&) { return true; });
  }

private:
  using Map = std::map<Key, Entries::iterator>;

  void Forget(const void* key) override
  {
    this->Places.erase(this->Places.find(*static_cast<const Key*>(key)));
  }

  Pointer UsePart(typename Map::iterator place)
  {
    this->Use(place->second);
    return std::static_pointer_cast<const Part>(place->second->Part);
  }

  const CachePolicy Policy;
  Map Places;
};
}

#endif
