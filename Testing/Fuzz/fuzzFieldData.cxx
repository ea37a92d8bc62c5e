// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Field data, written without compression; data that are read must survive writing and reading.

#include "fuzzInput.h"
#include "gatunFileImage.h"

#include <cstdlib>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace gatun;
  const auto bytes = test::Store({ data, data + size });
  fuzz::Accepts(
    [&]
    {
      const auto field = ReadFieldData(bytes);
      if (ReadFieldData(WriteFieldData(field)) != field)
      {
        std::abort();
      }
    });
  return 0;
}
