// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSpoolCursor_h
#define gtnSpoolCursor_h

#include "gtnSpool.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gtn
{
/** Reads the numbers of a stream in order, some at a time. */
class SpoolCursor
{
public:
  SpoolCursor(const Spool& file, std::size_t stream, std::size_t most)
    : File(file)
    , Stream(stream)
    , Count(file.Count<std::uint32_t>(stream))
    , Most(most)
  {
  }

  /** Calls use for all numbers below end, which ascend. */
  template <typename Use>
  void TakeBelow(std::uint64_t end, Use&& use)
  {
    for (; this->Fill() && this->Numbers[this->At] < end; ++this->At)
    {
      use(this->Numbers[this->At]);
    }
  }

  /** Calls use for some numbers. */
  template <typename Use>
  void Take(std::size_t count, Use&& use)
  {
    for (; count > 0 && this->Fill(); --count, ++this->At)
    {
      use(this->Numbers[this->At]);
    }
  }

private:
  bool Fill()
  {
    if (this->At == this->Numbers.size() && this->Begin < this->Count)
    {
      this->Numbers.resize(std::min(this->Most, this->Count - this->Begin));
      this->File.Read(this->Stream, this->Begin * sizeof(std::uint32_t),
        { reinterpret_cast<std::uint8_t*>(this->Numbers.data()),
          this->Numbers.size() * sizeof(std::uint32_t) });
      this->Begin += this->Numbers.size();
      this->At = 0;
    }
    return this->At < this->Numbers.size();
  }

  const Spool& File;
  const std::size_t Stream;
  const std::size_t Count;
  const std::size_t Most;
  std::size_t Begin = 0; // of the numbers that follow
  std::vector<std::uint32_t> Numbers;
  std::size_t At = 0;
};
}

#endif
