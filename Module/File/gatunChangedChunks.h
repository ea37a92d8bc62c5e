// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChangedChunks_h
#define gatunChangedChunks_h

#include "gatunFileReader.h"
#include "gatunMergeTree.h"
#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** The chunks of a file that differ between two numbers of merges of its tree, ascending: those with
 * a point whose ancestor changes. Takes time in proportion to the points that change. */
VTKGATUNCORE_EXPORT std::vector<std::uint32_t> FindChangedChunks(
  const FileReader& file, const MergeTree& tree, std::size_t from, std::size_t to);
}

#endif
