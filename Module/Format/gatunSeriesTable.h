// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSeriesTable_h
#define gatunSeriesTable_h

// The TIME section: which mesh each time step has. See Documentation/format.md, 18.

#include "gatunBytes.h"
#include "gatunTypes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The mesh of a time step as it is stored. */
struct StoredStep
{
  std::uint32_t Mesh = 0;
  std::uint32_t Mask = 0; // of its cells, from 1; 0: the step has all cells
  double Time = 0;

  bool HasMeshOf(const StoredStep& other) const
  {
    return this->Mesh == other.Mesh && this->Mask == other.Mask;
  }
};

/** Whether a step has only some cells of its mesh. */
bool HasMasks(std::span<const StoredStep> steps);

Bytes WriteSeries(std::span<const StoredStep> steps);

/** Reads the steps of a file, given its number of meshes and the number of masks of the first one.
 * Throws Error(Corrupt) unless times ascend, and meshes and masks are numbered in the order of
 * their first steps. */
std::vector<StoredStep> ReadSeries(
  std::span<const std::uint8_t> bytes, std::size_t meshes, std::size_t masks);
}

#endif
