// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Checks the harness itself: the driver hands over each file whole, an empty one included, in
// memory of its own that may be read to its last byte.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    sum += data[i];
  }
  if (sum > 255 * size)
  {
    std::abort();
  }
  return 0;
}
