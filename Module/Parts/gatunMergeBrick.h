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
/** A merge that has made a side of a tetrahedron, which it has not changed, a part of the boundary.
 */
struct BaredTet
{
  std::uint32_t Tet;
  std::uint32_t Merge; ///< its point
};

/** The same with a side at the wall of a group of bricks: the tetrahedron behind is elsewhere. */
struct BaredFace
{
  std::array<std::uint32_t, 3> Points; ///< their numbers in the mesh, ascending
  std::uint32_t Merge;
  MergeQueue::Key Key; ///< see MergeBrick
};

/** A merge that has changed the tetrahedron with a side at the wall of a group. */
struct TouchedFace
{
  std::array<std::uint32_t, 3> Points; ///< as above
  std::uint32_t Merge;
};

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

  // To find dependencies. Merges are known by the points that they merge.
  std::vector<std::uint32_t> Last; ///< the merge that has changed each tetrahedron last, or None
  std::vector<BaredTet> Bared;     ///< since then; a tetrahedron may occur several times
};
}

#endif
