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
inline Bytes GatherTuples(
  const void* values, const std::vector<std::uint32_t>& numbers, std::size_t tupleBytes)
{
  const auto* const from = static_cast<const std::uint8_t*>(values);
  Bytes to(numbers.size() * tupleBytes);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    std::memcpy(to.data() + i * tupleBytes, from + numbers[i] * tupleBytes, tupleBytes);
  }
  return to;
}
}

#endif
