// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnNames_h
#define gtnNames_h

// What the format's numbers are called.

#include "gatunTypes.h"

#include <cstdint>
#include <string>

namespace gtn
{
/** As numpy has it: "float32". */
const char* NameOf(gatun::ScalarType type);

/** "points, cells, corners" of flags of gatun::KeepOrder, or "none". */
std::string NameOfOrder(std::uint8_t kept);
}

#endif
