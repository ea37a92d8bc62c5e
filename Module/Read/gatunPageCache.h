// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPageCache_h
#define gatunPageCache_h

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace gatun
{
/**
 * Keeps the pages of tables that were used last, up to a number of bytes. A page that is evicted is
 * freed after its last use. Thread safe.
 */
class PageCache
{
public:
  using Key = std::pair<std::size_t, std::size_t>; // kind, number

  explicit PageCache(std::uint64_t budget)
    : Budget(budget)
  {
  }

  /** Returns a page, which make() makes if it is not there. Page::GetBytes() tells its size. A kind
   * always has the same type of pages. Two threads may make the same page at once. */
  template <typename Page, typename Make>
  std::shared_ptr<const Page> Get(const Key& key, Make&& make)
  {
    if (auto found = this->Find(key))
    {
      return std::static_pointer_cast<const Page>(std::move(found));
    }
    auto page = std::make_shared<const Page>(make());
    this->Keep(key, page, page->GetBytes());
    return page;
  }

private:
  struct Kept
  {
    std::shared_ptr<const void> Page;
    std::uint64_t Bytes;
    std::list<Key>::iterator Use;
  };

  std::shared_ptr<const void> Find(const Key& key);
  void Keep(const Key& key, std::shared_ptr<const void> page, std::uint64_t bytes);

  const std::uint64_t Budget;
  std::mutex Mutex; // of what follows
  std::map<Key, Kept> Pages;
  std::list<Key> LastUsed; // the last one in front
  std::uint64_t Bytes = 0;
};
}

#endif
