// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunEncoderSurface_h
#define gatunEncoderSurface_h

#include "gatunCellList.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The most corners of a polygon that a walk over surfaces takes. */
constexpr std::uint32_t MaxWalkedCorners = 32767;

/** The cells of an encoder's input that a walk over surfaces can take, by their edges. */
class EncoderSurface
{
public:
  /** candidates: the cells that may be taken. Cells that share no edge with another one are not.
   * keepCorners: whether triangles keep their first corner. Otherwise they may begin with any
   * corner, and keep their orientation. */
  EncoderSurface(
    const CellList& cells, std::span<const std::uint32_t> candidates, bool keepCorners);

  /** Whether there is any cell. */
  bool HasCells() const { return this->Number > 0; }

  /** Whether all cells are triangles that begin with any corner and are oriented alike. Before any
   * cell is begun. */
  bool IsUniform() const;

  /** Begins an unvisited cell with an edge, if possible one with the given orientation (`turned`).
   * Returns false if there is none. */
  bool FindCell(std::uint32_t begin, std::uint32_t end, bool turned);

  /** Begins any unvisited cell. Returns false if there is none. */
  bool FindSeed();

  /** Whether a cell was begun. */
  bool IsTaken(std::uint32_t cell) const { return this->States[cell] == State::Taken; }

  // The cell that was begun:
  std::uint32_t Cell = 0;
  std::uint8_t Type = 0;
  std::uint32_t Turn = 0;             // see GetMarkPlace
  std::vector<std::uint32_t> Corners; // around it, from the edge on

private:
  static constexpr std::uint32_t None = 0xffffffff;

  enum class State : std::uint8_t
  {
    Never,
    Waiting,
    Taken
  };

  struct Edge
  {
    std::uint32_t Cell;
    std::uint32_t Place; // where it begins in the cell
    std::uint32_t Next;  // with the same place in the table, or None
  };

  std::size_t GetPlaceOfHead(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t& GetHead(std::uint32_t a, std::uint32_t b)
  {
    return this->Heads[this->GetPlaceOfHead(a, b)];
  }
  std::uint32_t GetCorner(std::uint32_t cell, std::uint32_t place) const;
  void AddEdges(std::uint32_t cell);
  bool HasNeighbor(std::uint32_t cell);
  void Begin(std::uint32_t cell, std::uint32_t place, bool turned);

  const CellList& Cells;
  const bool KeepCorners;
  std::vector<std::uint32_t> Seeds; // in the order of the input
  std::vector<State> States;
  std::vector<Edge> Edges;
  std::vector<std::uint32_t> Heads;
  std::size_t Number = 0;
  std::size_t NextSeed = 0;
};
}

#endif
