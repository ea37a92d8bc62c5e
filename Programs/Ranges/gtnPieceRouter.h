// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPieceRouter_h
#define gtnPieceRouter_h

// The piece of a mesh that a cell goes to.

#include "gtnPointTree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gtn
{
/** The bytes that cells and points take in memory. */
struct ElementBytes
{
  double Point = 0;
  double Cell = 0;
  double Corner = 0;    ///< an id of a cell
  double FaceValue = 0; ///< a number in the faces of a polyhedron
};

/** A cell goes to the least leaf of its points, in the order of a PointTree. Leaves are divided
 * among pieces. Takes 2 bytes for each point. */
class PieceRouter
{
public:
  /** The most levels that a tree may have. */
  static constexpr unsigned MostLevels = 15;

  PieceRouter(std::size_t points, std::size_t leaves);

  void SetLeaf(std::size_t point, std::size_t leaf)
  {
    this->Leaves[point] = static_cast<std::uint16_t>(leaf);
  }

  /** Adds a cell to the weights, for all cells. */
  void Weigh(std::span<const std::uint32_t> corners, std::uint32_t faceValues);

  /** Divides the leaves when all cells have been weighed. most: the bytes of a piece. least: number
   * of pieces. Returns the number of pieces. */
  std::size_t Divide(const ElementBytes& bytes, std::uint64_t most, std::size_t least);

  /** The piece of the next cell, in the same order. */
  std::size_t Route(std::span<const std::uint32_t> corners);

  /** Whether no cell with this point has been routed. */
  bool IsUnused(std::size_t point) const { return (this->Leaves[point] & Used) == 0; }

private:
  static constexpr std::uint16_t Used = 0x8000;

  struct Leaf
  {
    std::uint64_t Cells = 0;
    std::uint64_t Corners = 0;
    std::uint64_t FaceValues = 0;
    std::uint32_t FirstPiece = 0;
    std::uint32_t Pieces = 1;
    std::uint64_t Routed = 0;
  };

  Leaf& Find(std::span<const std::uint32_t> corners);

  std::vector<std::uint16_t> Leaves; // of the points, and whether they are used
  std::vector<Leaf> All;
};
}

#endif
