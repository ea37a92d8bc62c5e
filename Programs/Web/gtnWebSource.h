// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnWebSource_h
#define gtnWebSource_h

#include "gtnWebFile.h"

#include "gatunByteSource.h"

#include <cstddef>
#include <cstdint>
#include <future>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gtn
{
/**
 * The bytes of a file on a web server, of which only what is needed is fetched: in blocks of 64
 * KiB, of which the last used 64 MiB are kept. HttpSource of the Python package works in the same
 * way.
 *
 * Thread safe. Threads that need the same block fetch it once.
 */
class WebSource final : public gatun::ByteSource
{
public:
  /** Throws as WebFile. */
  explicit WebSource(const std::string& address);

  std::uint64_t GetSize() const override { return this->File.GetSize(); }
  int ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const override;
  bool IsRemote() const override { return true; }

  /** Fetches the ranges, if all can be kept, on several connections. If not, each read of a part of
   * them also fetches a part of what follows. */
  void Fetch(const std::vector<gatun::ByteRange>& ranges) const override;

private:
  using Block = std::shared_ptr<const WebFile::Bytes>;
  using Blocks = std::map<std::uint64_t, Block>; ///< by number
  using Numbers = std::vector<gatun::ByteRange>; ///< of blocks, not of bytes
  using Use = std::pair<std::uint64_t, Block>;

  /** Blocks in a row, for one request. */
  struct Job
  {
    std::uint64_t First = 0;
    std::vector<std::promise<Block>> Results;
  };

  static std::uint64_t FindEnd(const Job& job) { return job.First + job.Results.size(); }
  Numbers FindBlocks(const std::vector<gatun::ByteRange>& ranges, std::uint64_t gap) const;
  Blocks Obtain(const Numbers& wanted) const;
  Block FindKept(std::uint64_t number) const;
  void Claim(std::uint64_t number, std::vector<Job>& jobs) const;
  void ReadAhead(Job& job) const;
  void Keep(std::uint64_t number, const Block& block) const;
  void Run(std::vector<Job>& jobs) const;
  void Run(Job& job) const noexcept;
  std::vector<Block> Request(const Job& job) const;

  const WebFile File;
  mutable std::mutex Guard;    // of what follows
  mutable std::list<Use> Kept; // the last used one first
  mutable std::unordered_map<std::uint64_t, std::list<Use>::iterator> Places;
  mutable std::unordered_map<std::uint64_t, std::shared_future<Block>> Pending;
  mutable Numbers Planned; // what Fetch has left to reads
};
}

#endif
