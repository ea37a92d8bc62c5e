// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunEncoderMarks_h
#define gatunEncoderMarks_h

#include "gatunCellList.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace gatun
{
/** The number of corners of a surface cell that a face can be, 0 if it can be none of the type. A
 * polygon has any number. */
unsigned CountMarkCorners(std::uint8_t type, unsigned degree);

/** Whether a surface cell has as many points as one with this number of corners has. */
bool HasAllNodes(std::uint8_t type, unsigned degree, std::size_t points);

/** The corner of a cell at place i of its cycle: the points of a pixel are in rows. */
constexpr unsigned GetMarkCorner(std::uint8_t type, unsigned i)
{
  return type == 8 && i >= 2 ? 5 - i : i;
}

/** The place in a face of place i of the cycle. turn: twice the first place, plus 1 if the cycle
 * runs backward. */
constexpr unsigned GetMarkPlace(unsigned turn, unsigned i, unsigned degree)
{
  return (turn / 2 + (turn % 2 != 0 ? degree - i : i)) % degree;
}

/** The cells of an encoder's input that may be faces of others. */
class EncoderMarks
{
public:
  /** candidates: the cells that no walk takes. */
  EncoderMarks(const CellList& cells, std::span<const std::uint32_t> candidates);

  /** Whether there may be one. */
  bool HasCells() const { return !this->Found.empty(); }

  /** Finds a cell that is a face with these corners, once. */
  bool FindCell(std::span<const std::uint32_t> face);

  /** Whether a cell was found. */
  bool IsTaken(std::uint32_t cell) const { return this->Taken[cell] != 0; }

  // The cell that was found:
  std::uint32_t Cell = 0;
  std::uint8_t Type = 0;
  std::uint8_t Turn = 0;

private:
  bool FindTurn(std::uint32_t cell, std::span<const std::uint32_t> face);

  const CellList& Cells;
  // Not a multimap: the order of its equal keys differs between libraries, and so would files.
  std::unordered_map<std::uint64_t, std::uint32_t> Found; // the last cell of a hash of corners
  std::vector<std::uint32_t> Earlier;                     // the one before of the same hash
  std::vector<char> Taken;
};
}

#endif
