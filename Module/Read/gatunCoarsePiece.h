// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCoarsePiece_h
#define gatunCoarsePiece_h

#include "gatunCoarseCells.h"
#include "gatunCoarseLayout.h"
#include "gatunFileReader.h"
#include "gatunPieceRequest.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
class ChunkCache;

/** A chunk after merges. */
struct CoarseChunk
{
  std::vector<std::uint32_t> Ids; ///< remaining cells by their numbers in the chunk
  CoarseCells Cells;              ///< corners by their numbers in the file
};

/** Decodes and simplifies the mesh of a chunk: its tetrahedra, or the cells of a surface. */
CoarseChunk DecodeCoarse(const std::shared_ptr<ChunkCache>& cache, const CoarseLayout& layout,
  std::uint32_t chunk, PieceForm form);

/**
 * A piece of a file after merges: the remaining cells and points of its chunks, and the corners
 * that cells take from other chunks. Decodes chunk by chunk and keeps only the remaining parts.
 * Surfaces have their cells if the request asks for original ones; other files have tetrahedra.
 *
 * Cells are sorted chunk by chunk, points by their numbers in the file, and both with ghosts last.
 * If the request asks for the original order and the file has it, both follow it.
 */
class CoarsePiece
{
public:
  using Progress = std::function<bool(double)>;

  CoarsePiece(std::shared_ptr<ChunkCache> cache, std::shared_ptr<const CoarseLayout> layout,
    const PieceRequest& request, const Progress& progress);

  std::uint64_t GetNumberOfPoints() const { return this->Points.size(); }
  const CoarseCells& GetCells() const { return this->Cells; }

  void Fill(const PieceTarget& target, const std::vector<std::uint32_t>& arrays, std::size_t step,
    const Progress& progress) const;

private:
  /** A position in a chunk and the position in the piece. */
  struct Copy
  {
    std::uint32_t From;
    std::uint32_t To;
  };

  /** The part of the piece from one chunk, or from the unused points. */
  struct Part
  {
    std::uint32_t Chunk;
    std::vector<Copy> Points;
    std::vector<Copy> Cells;
  };

  static constexpr std::uint32_t NoChunk = 0xffffffffu; // the unused points

  void AddCells(const Progress& progress);
  void AddGhosts(std::vector<CoarseChunk>& around, const std::vector<std::uint32_t>& chunks);
  void AddPoints();
  void RestoreOrder();
  bool Owns(std::uint32_t point) const;
  Part& GetPart(std::uint32_t chunk);
  void FillPart(const Part& part, const PieceTarget& target,
    const std::vector<std::uint32_t>& arrays, std::size_t step) const;

  std::shared_ptr<ChunkCache> Cache;
  std::shared_ptr<const FileReader> File;
  std::shared_ptr<const CoarseLayout> Layout;
  PieceRequest Request;
  std::vector<std::uint32_t> Points; // by their numbers in the file
  PieceForm Form;                    // of what is decoded
  CoarseCells Cells;                 // corners as positions in Points
  std::size_t OwnCells = 0;
  std::size_t OwnPoints = 0; // further points are only corners of cells
  std::vector<Part> Parts;
};
}

#endif
