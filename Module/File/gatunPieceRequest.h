// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunPieceRequest_h
#define gatunPieceRequest_h

#include "gatunMergeTree.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
/** Which part of a file to decode. */
struct PieceRequest
{
  std::vector<std::uint32_t> Chunks; ///< ascending; their tetrahedra make the piece

  /** Ascending, with all of Chunks: the mesh that the piece is one of, as if the file had no other
   * chunks. Ghosts come from there, and there is the owner of each point. Empty: the whole file. */
  std::vector<std::uint32_t> Universe;

  std::vector<std::uint32_t> Arrays; ///< indices into GetArrays(), ascending
  std::size_t Step = 0;
  unsigned GhostLevels = 0;      ///< layers of cells around the piece, sharing a point
  bool WithUnusedPoints = false; ///< points of no tetrahedron too (give them to one piece)
  bool RestoreOrder = true;      ///< original order, if kept and all chunks are asked for

  /** How many merges to make, by the tree of the file; corners keep no order then but orientation.
   * With ghosts the whole universe is decoded. */
  std::size_t Merges = 0;
  std::shared_ptr<const MergeTree> Tree; ///< the file's, if there are merges

  bool operator==(const PieceRequest&) const = default;
};

/** Where the caller wants the piece; each pointer may be null if not wanted. Sizes as announced. */
struct PieceTarget
{
  void* Points = nullptr;                 ///< 3 values a point of GetCoordinateType()
  void* Connectivity = nullptr;           ///< 4 ids a cell
  bool WideIds = true;                    ///< ids are std::int64_t, else std::int32_t
  std::vector<void*> Arrays;              ///< one for each array of the request, or empty
  std::int64_t* GlobalPointIds = nullptr; ///< original ids where the file keeps point order
  std::int64_t* GlobalCellIds = nullptr;  ///< original ids where the file keeps cell order

  /** 0: of the piece; 1: a duplicate, owned by another (VTK's DUPLICATEPOINT, DUPLICATECELL).
   * A shared point is owned by the lowest chunk of the universe that uses it. */
  unsigned char* PointGhosts = nullptr;
  unsigned char* CellGhosts = nullptr;
};
}

#endif
