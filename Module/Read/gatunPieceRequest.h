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
class CoarseLayout;

/** The form of the cells of a piece. */
enum class PieceForm : std::uint8_t
{
  Tetrahedra, ///< those of which the cells consist; cells of a lower dimension are left out
  Original    ///< the cells as they were written
};

/** The part of a file to decode. */
struct PieceRequest
{
  std::vector<std::uint32_t> Chunks; ///< ascending; their cells form the piece

  /** The chunks that form the whole mesh, ascending, a superset of Chunks. Ghosts and owners of
   * points are among them. Empty for all chunks of the file. */
  std::vector<std::uint32_t> Universe;

  std::vector<std::uint32_t> Arrays; ///< indices into GetArrays(), ascending
  std::size_t Step = 0;
  unsigned GhostLevels = 0;      ///< layers of cells around the piece that share points
  bool WithUnusedPoints = false; ///< whether to include unused points (in one piece only)
  PieceForm Form = PieceForm::Tetrahedra;

  /** Whether to restore the original order, if the file keeps it and the piece is whole. The order
   * of tetrahedra of other cells is not restored. */
  bool RestoreOrder = true;

  /** The number of merges of the file's tree to apply. The result has tetrahedra, but that of a
   * surface has its cells in their original form if Form says so. Corners keep their orientation
   * but not their order. With ghosts, the whole universe is decoded. */
  std::size_t Merges = 0;
  std::shared_ptr<const MergeTree> Tree; ///< the file's tree, if there are merges

  /** The merges of a cut in place of the first ones of the tree, all of which are among those; or
   * null. Requests with the same merges can share it. */
  std::shared_ptr<const CoarseLayout> Cut;

  bool operator==(const PieceRequest&) const = default;
};

/** Memory for a piece, with the sizes that the decoder reports. Null pointers are skipped. */
struct PieceTarget
{
  void* Points = nullptr;       ///< 3 values of GetCoordinateType() for each point
  void* Connectivity = nullptr; ///< the ids of the cells' points: 4 for each tetrahedron
  bool WideIds = true;          ///< whether ids are std::int64_t or std::int32_t

  /** For original cells that are not all tetrahedra; all or none of them, and with Connectivity.
   * As in MeshInput, but polyhedra have their faces in the order of the cells. */
  void* Offsets = nullptr; ///< ids
  std::uint8_t* Types = nullptr;
  std::int64_t* FaceLocations = nullptr; ///< may be null if there are no faces
  std::int64_t* Faces = nullptr;

  std::vector<void*> Arrays;              ///< one for each array of the request, or empty
  std::int64_t* GlobalPointIds = nullptr; ///< original ids if the file keeps the order of points
  std::int64_t* GlobalCellIds = nullptr;  ///< original ids if the file keeps the order of cells

  /** For each cell an earlier one of the piece that shares the face opposite to its last corner, as
   * far as that is known from decoding, or NoParent; always that if an order is restored. */
  std::uint32_t* CellParents = nullptr;
  static constexpr std::uint32_t NoParent = 0xffffffffu;

  std::uint64_t* FileCells = nullptr; ///< numbers in the order of the file; not after merges

  /** 0 for elements of the piece, 1 for duplicates that another piece owns (VTK's DUPLICATEPOINT,
   * DUPLICATECELL). A shared point belongs to the lowest chunk of the universe that uses it. */
  unsigned char* PointGhosts = nullptr;
  unsigned char* CellGhosts = nullptr;
};
}

#endif
