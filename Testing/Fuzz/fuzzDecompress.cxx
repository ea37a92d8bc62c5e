// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fuzzInput.h"
#include "gatunCompress.h"

#include <cstdlib>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::uint64_t limit = 1u << 18;
  const auto bytes = gatun::fuzz::Copy({ data, size });
  gatun::fuzz::Accepts(
    [&]
    {
      if (gatun::Decompress(bytes, limit).size() > limit)
      {
        std::abort();
      }
    });
  return 0;
}
