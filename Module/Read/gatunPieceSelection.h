// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPieceSelection_h
#define gatunPieceSelection_h

#include "gatunCellMask.h"
#include "gatunChunkSetDecoder.h"
#include "gatunPieceCells.h"

#include <cstdint>
#include <vector>

namespace gatun
{
/** How a piece is cut out of a larger set of chunks. */
struct PieceCut
{
  const CellMask* Mask = nullptr; // of the remaining cells of the file; null: all
  unsigned GhostLevels = 0;
  bool IsRestored = false; // whether the larger set is the piece, in its original order
};

/**
 * The points and cells of a piece that is cut out of a larger set of chunks: a piece with ghosts,
 * or one without deleted cells. The set is decoded as a whole, and the points and cells of the
 * piece are copied.
 */
class PieceSelection
{
public:
  using Progress = ChunkSetDecoder::Progress;

  PieceSelection(const ChunkSetDecoder& around, const ChunkSet& piece, const PieceCut& cut,
    const Progress& progress);

  /** The positions of points and cells in the larger set: first those of the piece, then ghosts. */
  const std::vector<std::uint64_t>& GetPoints() const { return this->Points; }
  const std::vector<std::uint64_t>& GetCells() const { return this->Cells; }

  /** Those of the piece. */
  std::size_t GetNumberOfOwnPoints() const { return this->OwnPoints; }
  std::size_t GetNumberOfOwnCells() const { return this->OwnCells; }

  const PieceCells& GetMemory() const { return this->Memory; }

  /** For each point of a larger set the lowest chunk with a remaining cell that uses it, or
   * NoChunk.
   */
  static constexpr std::uint32_t NoChunk = 0xffffffffu;
  static std::vector<std::uint32_t> FindOwners(
    const ChunkSetDecoder& around, const CellMask& mask, const Progress& progress);

private:
  std::vector<std::uint64_t> Points;
  std::vector<std::uint64_t> Cells;
  std::size_t OwnPoints = 0;
  std::size_t OwnCells = 0;
  PieceCells Memory;
};
}

#endif
