// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnOtherProfile_h
#define gtnOtherProfile_h

#include "gatunFileReader.h"

#include <cstdint>
#include <optional>

namespace gtn
{
/** About how many bytes a file would take in the other profile: its size, in proportion to what a
 * piece of its first time step takes in both. Nothing if it has no cells or bounds of errors. */
std::optional<std::uint64_t> EstimateOtherProfile(const gatun::FileReader& file);
}

#endif
