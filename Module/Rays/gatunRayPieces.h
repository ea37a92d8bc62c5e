// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayPieces_h
#define gatunRayPieces_h

#include "gatunRayTable.h"

#include <array>
#include <functional>

namespace gatun
{
/** The channels of a cell of a RayTable at a place. */
using RayEntry = std::function<std::array<double, 4>(double place)>;

/** Approximates a table, whose cells are known, by pieces. Where the function steps within a cell,
 * the step is located to 1 / 16384 of the cell. */
void MakeRayPieces(const RayEntry& getEntry, RayTable& table);
}

#endif
