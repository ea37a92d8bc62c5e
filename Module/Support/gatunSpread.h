// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSpread_h
#define gatunSpread_h

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace gatun
{
/** The numbers from 0 to count - 1 in an order whose beginnings, of any length, are from
 * everywhere. */
inline std::vector<std::size_t> SpreadNumbers(std::size_t count)
{
  std::vector<std::size_t> numbers(count);
  // The golden ratio leaves no large gaps.
  auto step = static_cast<std::size_t>(static_cast<double>(count) * 0.6180339887) + 1;
  while (std::gcd(step, count) > 1)
  {
    ++step;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    numbers[i] = i * step % count;
  }
  return numbers;
}
}

#endif
