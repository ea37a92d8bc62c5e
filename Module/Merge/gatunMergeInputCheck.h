// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeInputCheck_h
#define gatunMergeInputCheck_h

#include "gatunMergeInput.h"

#include <cstddef>

namespace gatun
{
/** Throws InvalidInput if there are too many points or cells, a corner or a value is missing, or a
 * weight is out of range. */
template <std::size_t Corners>
void CheckMergeInput(const BasicMergeInput<Corners>& input);

void CheckMergeSettings(const MergeSettings& settings);
void CheckMergeSettings(const SurfaceMergeSettings& settings);

extern template void CheckMergeInput<3>(const BasicMergeInput<3>& input);
extern template void CheckMergeInput<4>(const BasicMergeInput<4>& input);
}

#endif
