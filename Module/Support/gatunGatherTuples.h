// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGatherTuples_h
#define gatunGatherTuples_h

#include "gatunBytes.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace gatun
{
/** Copies the tuples with some numbers, in their order. */
template <typename Numbers>
void GatherTuples(const void* values, const Numbers& numbers, std::size_t tupleBytes, void* target)
{
  const auto* const from = static_cast<const std::uint8_t*>(values);
  auto* to = static_cast<std::uint8_t*>(target);
  for (const auto number : numbers)
  {
    std::memcpy(to, from + static_cast<std::size_t>(number) * tupleBytes, tupleBytes);
    to += tupleBytes;
  }
}

inline Bytes GatherTuples(
  const void* values, const std::vector<std::uint32_t>& numbers, std::size_t tupleBytes)
{
  Bytes to(numbers.size() * tupleBytes);
  GatherTuples(values, numbers, tupleBytes, to.data());
  return to;
}
}

#endif
