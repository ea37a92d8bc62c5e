// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBaseMesh_h
#define gatunBaseMesh_h

#include "gatunBytes.h"
#include "gatunCoarseCells.h"
#include "gatunMergeTree.h"
#include "gatunPartition.h"
#include "gatunWriterOptions.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Base meshes of meshes of so many cells or fewer would not save time. */
constexpr std::uint64_t SmallLevel = 20'000;

/** The options of the file of a base mesh, but for its tree. whole: those of the whole file. */
WriterOptions MakeLevelOptions(const WriterOptions& whole);

/** The mesh after a number of merges, as a mesh of its own: its tetrahedra, or the cells of a
 * surface in their original form. */
class BaseMesh
{
public:
  BaseMesh(const MeshAccess& mesh, const MergeTree& tree, std::size_t merges,
    PieceForm form = PieceForm::Tetrahedra);

  /** Valid during the lifetime of this object. */
  MeshInput GetInput() const;

  /** The points that remain, in the order that they have here. */
  const std::vector<std::uint32_t>& GetPoints() const { return this->Points; }

  /** The tuples of the remaining points, or of the cells that remain. */
  Bytes Gather(const void* values, Association where, std::size_t tupleBytes) const;

private:
  void MakeCells(const CoarseCells& cells);

  std::vector<std::uint32_t> Points; // numbers in the whole mesh
  std::vector<std::uint32_t> Cells;
  ScalarType CoordinateType;
  Bytes Coordinates;
  bool WideIds;
  Bytes Connectivity;
  Bytes Offsets; // unless all are tetrahedra
  std::vector<std::uint8_t> Types;
};
}

#endif
