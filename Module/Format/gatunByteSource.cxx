// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunByteSource.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
std::vector<ByteRange> JoinRanges(std::vector<ByteRange> ranges, std::uint64_t gap)
{
  std::erase_if(ranges, [](const ByteRange& range) { return range.Length == 0; });
  std::sort(ranges.begin(), ranges.end(),
    [](const ByteRange& a, const ByteRange& b) { return a.Offset < b.Offset; });
  std::vector<ByteRange> joined;
  for (const auto& range : ranges)
  {
    if (!joined.empty())
    {
      auto& last = joined.back();
      const auto end = last.Offset + last.Length;
      if (range.Offset <= end || range.Offset - end <= gap)
      {
        last.Length = std::max(end, range.Offset + range.Length) - last.Offset;
        continue;
      }
    }
    joined.push_back(range);
  }
  return joined;
}

//------------------------------------------------------------------------------
int MemorySource::ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const
{
  const auto begin = static_cast<std::size_t>(std::min<std::uint64_t>(offset, this->Data.size()));
  const auto length = std::min(bytes.size(), this->Data.size() - begin);
  std::copy_n(this->Data.begin() + static_cast<std::ptrdiff_t>(begin), length, bytes.begin());
  bytes = bytes.subspan(length);
  return 0;
}
}
