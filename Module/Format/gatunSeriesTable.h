// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSeriesTable_h
#define gatunSeriesTable_h

// The TIME section: which mesh each time step has. See Documentation/format.md, 18.

#include "gatunBytes.h"
#include "gatunTypes.h"

#include <span>
#include <vector>

namespace gatun
{
Bytes WriteSeries(std::span<const SeriesStep> steps);

/** Reads the steps of a file with so many meshes. Throws Error(Corrupt) unless times ascend and the
 * meshes are numbered in the order of their first steps. */
std::vector<SeriesStep> ReadSeries(std::span<const std::uint8_t> bytes, std::size_t meshes);
}

#endif
