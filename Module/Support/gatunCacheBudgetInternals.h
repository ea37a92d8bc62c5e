// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunCacheBudgetInternals_h
#define gatunCacheBudgetInternals_h

#include "gatunCacheBudget.h"

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>

namespace gatun
{
/** The part of a cache that does not depend on the types of keys and parts. */
class CacheUser
{
public:
  CacheUser(const CacheUser&) = delete;
  CacheUser& operator=(const CacheUser&) = delete;

  const std::shared_ptr<CacheBudget>& GetBudget() const { return this->Budget; }
  CacheStatistics GetStatistics() const;

protected:
  /** An entry of any cache of the budget. */
  struct Entry
  {
    CacheUser* User = nullptr;
    const void* Key = nullptr; // in the node of the user's map
    std::shared_ptr<const void> Part;
    std::uint64_t Bytes = 0;
  };
  using Entries = std::list<Entry>;

  explicit CacheUser(std::shared_ptr<CacheBudget> budget);
  virtual ~CacheUser();

  /** Removes a key from the map of this cache, which has it. */
  virtual void Forget(const void* key) = 0;

  // The guard is that of the budget. The methods below need it locked. Entries that they take out
  // must be destroyed after it is unlocked.
  std::mutex& GetGuard() const;

  /** Marks an entry as the one used last and counts the search. */
  void Use(Entries::iterator entry);
  void CountMade();
  bool CanFit(std::uint64_t bytes) const;
  bool HasRoom(std::uint64_t bytes) const;
  /** Takes out entries of all caches until an entry fits, or there are none left. */
  void MakeRoom(std::uint64_t bytes, Entries& dropped);
  /** Adds the one entry of a list. */
  void Add(Entries& added);
  /** Takes out an entry of this cache, but leaves its key in the map. */
  void Drop(Entries::iterator entry, Entries& dropped);

private:
  friend class CacheBudget;

  const std::shared_ptr<CacheBudget> Budget;
  CacheStatistics Statistics;
};

}

#endif
