// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a file. Checksums keep most of them from getting far; see fuzzSections.cxx.

#include "fuzzFiles.h"
#include "fuzzInput.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  gatun::fuzz::UseOneThread();
  gatun::fuzz::DecodeFile({ data, size });
  return 0;
}
