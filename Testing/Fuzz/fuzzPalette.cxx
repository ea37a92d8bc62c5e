// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fuzzInput.h"
#include "gatunPalette.h"

#include <cstdlib>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace gatun;
  fuzz::Input in(data, size);
  const auto type = static_cast<ScalarType>(1 + in.TakeUpTo(9));
  const std::uint64_t count =
    in.TakeBool() ? in.TakeUpTo(600) : in.Take<std::uint64_t>() | MaxPalette;
  const auto stream = fuzz::Copy(in.TakeRest());
  fuzz::Accepts(
    [&]
    {
      const auto palette = DecodePalette(type, stream, count);
      if (*DecodePalette(type, EncodePalette(type, *palette), count) != *palette)
      {
        std::abort();
      }
    });
  return 0;
}
