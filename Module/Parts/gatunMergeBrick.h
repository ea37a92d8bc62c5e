// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeBrick_h
#define gatunMergeBrick_h

#include "gatunMergeFields.h"
#include "gatunMergeQueue.h"
#include "gatunMergeRounds.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * Some of the tetrahedra of a mesh with their points, after some merges. Merges make neither points
 * nor tetrahedra, and a tetrahedron never leaves its brick, so that a brick never grows.
 */
struct MergeBrick
{
  std::vector<std::uint32_t> Points;              ///< their numbers in the mesh, ascending
  std::vector<MergeHint> Hints;                   ///< of each point; Into is a number in the mesh
  std::vector<MergeFields::Sample> Samples;       ///< MergeFields::GetData of each point
  std::vector<std::array<std::uint32_t, 4>> Tets; ///< as places among the points
  std::vector<MergeQueue::Key> Keys; ///< of each tetrahedron, the largest of the merges behind it
  std::vector<std::uint32_t> Cells;  ///< that the tetrahedra are of (MergePart::Cells), or empty
};
}

#endif
