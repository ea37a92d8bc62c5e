// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellStore_h
#define gatunCellStore_h

#include "gatunCellList.h"
#include "gatunChunkCodec.h"
#include "gatunOriginalNumbers.h"
#include "gatunPieceRequest.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/** The original cells of a chunk, with the ids that its points have in a piece. */
struct PlacedCells
{
  CellList Cells;
  std::vector<std::uint64_t> Ids; ///< of the points of the chunk

  /** The position of each cell in the piece if the original order is restored, or null. */
  std::shared_ptr<const OriginalNumbers> Places;
};

/** The cells of a chunk of tetrahedra as cells of any type. */
CellList MakeTetList(std::vector<std::array<Vertex, 4>> tets);

/**
 * Stores the original cells of chunks in a PieceTarget. Without an original order, each chunk has
 * its place. With it, chunks are added first, and stored when all sizes are known.
 *
 * Different chunks may be stored or added by several threads.
 */
class CellStore
{
public:
  explicit CellStore(const PieceTarget& target)
    : Target(target)
  {
  }

  /** Stores cells from the given positions on. ids: as PlacedCells::Ids. */
  void Store(const CellList& cells, std::span<const std::uint64_t> ids, std::uint64_t firstCell,
    std::uint64_t firstCorner, std::uint64_t firstFaceValue) const;

  /** Stores the end of the offsets, if chunks were stored. */
  void Finish(std::uint64_t cells, std::uint64_t corners) const;

  /** Stores the sizes and types of cells. */
  void Add(const PlacedCells& cells) const;

  /** Computes the positions of all cells from their sizes. */
  void AddUp(std::uint64_t cells) const;

  /** Stores cells that were added. */
  void StoreAdded(const PlacedCells& cells) const;

private:
  void SetOffset(std::uint64_t cell, std::uint64_t value) const;
  std::uint64_t GetOffset(std::uint64_t cell) const;
  void StoreCorners(std::span<const std::uint32_t> corners, std::span<const std::uint64_t> ids,
    std::uint64_t first) const;
  void StoreFaces(const CellList& list, std::size_t cell, std::span<const std::uint64_t> ids,
    std::uint64_t faceValue) const;

  const PieceTarget& Target;
};

/** The number of values that a cell has in PieceTarget::Faces. */
std::uint64_t CountFaceValues(const CellList& cells, std::size_t cell);
}

#endif
