// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChangedChunks_h
#define gatunChangedChunks_h

#include "gatunExport.h"
#include "gatunFileReader.h"
#include "gatunMergeChanges.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** The chunks of a file that differ between two numbers of merges, ascending: chunks with a point
 * whose ancestor changes. Changes: of the tree of the file. Takes time in proportion to the points
 * that change. */
GATUN_EXPORT std::vector<std::uint32_t> FindChangedChunks(
  const FileReader& file, const MergeChanges& changes, std::size_t from, std::size_t to);
}

#endif
