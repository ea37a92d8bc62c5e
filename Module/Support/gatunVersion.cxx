// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVersion.h"

#define GATUN_TEXT_OF(x) #x
#define GATUN_TEXT(x) GATUN_TEXT_OF(x)

namespace gatun
{

const char* PackageVersion() noexcept
{
  return GATUN_TEXT(GATUN_VERSION_MAJOR) "." GATUN_TEXT(GATUN_VERSION_MINOR) "." GATUN_TEXT(
    GATUN_VERSION_PATCH);
}

const char* FormatVersion() noexcept
{
  return GATUN_TEXT(GATUN_FORMAT_VERSION);
}

} // namespace gatun
