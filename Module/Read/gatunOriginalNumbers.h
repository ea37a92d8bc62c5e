// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunOriginalNumbers_h
#define gatunOriginalNumbers_h

#include "gatunDomain.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Original ids of points or cells, in as few bytes as the file has them. */
class OriginalNumbers
{
public:
  OriginalNumbers(std::span<const Key> numbers, ScalarType type)
  {
    if (type == ScalarType::UInt32)
    {
      this->Narrow.assign(numbers.begin(), numbers.end());
    }
    else
    {
      this->Wide.assign(numbers.begin(), numbers.end());
    }
  }

  std::uint64_t operator[](std::size_t i) const
  {
    return this->Wide.empty() ? this->Narrow[i] : this->Wide[i];
  }

  std::uint64_t GetBytes() const
  {
    return this->Narrow.size() * sizeof(std::uint32_t) + this->Wide.size() * sizeof(std::uint64_t);
  }

private:
  std::vector<std::uint32_t> Narrow;
  std::vector<std::uint64_t> Wide;
};
}

#endif
