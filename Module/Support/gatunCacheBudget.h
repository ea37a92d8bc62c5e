// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunCacheBudget_h
#define gatunCacheBudget_h

#include "gatunExport.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/** The contents and the work of a cache, or of all caches of a budget. */
struct CacheStatistics
{
  std::uint64_t Bytes = 0;     ///< held now, including the cache's own nodes
  std::uint64_t PeakBytes = 0; ///< maximum since the budget was set
  std::uint64_t Entries = 0;   ///< held now
  std::uint64_t Found = 0;     ///< searches that returned an entry
  std::uint64_t Made = 0;      ///< entries offered to the cache, whether it kept them or not
};

/**
 * A number of bytes that several caches share. When an entry does not fit, the entries that have
 * not been used for the longest time are removed, whichever cache they belong to.
 *
 * A cache keeps its budget alive. Thread safe.
 */
class GATUN_EXPORT CacheBudget
{
public:
  /** With 0 bytes the caches keep nothing. */
  explicit CacheBudget(std::uint64_t bytes);
  ~CacheBudget();
  CacheBudget(const CacheBudget&) = delete;
  CacheBudget& operator=(const CacheBudget&) = delete;

  /** Removes entries at once until the others fit into the new budget. */
  void SetBytes(std::uint64_t bytes);
  std::uint64_t GetBytes() const;

  /** Sums over all caches, including those that no longer exist. */
  CacheStatistics GetStatistics() const;

private:
  friend class CacheUser;
  class Internals;
  const std::unique_ptr<Internals> Self;
};
}

#endif
