// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellSources_h
#define gatunCellSources_h

// The choice of sources for the cells of a CellTree.

#include "gatunCellRows.h"
#include "gatunCodedCells.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
class SourceFinder
{
public:
  /** cells: those that were coded so far. numbers: of the input's vertices, or CodedCells::None. */
  SourceFinder(std::size_t count, const CodedCells& cells, const CellUsers& users,
    const std::vector<std::uint32_t>& numbers);

  /** Finds the sources of a cell with these points of the input, of which the first corners count,
   * reach each. Sets From, and returns their number. To be called for each cell in order. */
  unsigned Find(std::uint32_t cell, std::span<const std::uint32_t> points, std::size_t reach);

  SourceCells From{};
  bool AreKnown = true; ///< whether each used one follows that of the cell before

private:
  using Ids = std::vector<std::uint32_t>;

  void FindKnown(std::span<const std::uint32_t> points);
  void FindNearCells(std::uint32_t cell, std::span<const std::uint32_t> points);
  std::uint32_t FindBest(const Ids& open, std::uint32_t expected, std::size_t reach);
  void SortMore();
  bool IsCovered(std::uint32_t vertex, std::uint32_t source, std::size_t reach) const;
  std::size_t Cover(Ids& open, std::uint32_t source, std::size_t reach) const;

  const CodedCells& Coded;
  const CellUsers& Users;
  const std::vector<std::uint32_t>& Numbers;
  struct State
  {
    std::uint32_t Rank = CodedCells::None;
    std::uint32_t Common = 0; // corners with the cell that is looked at
  };
  std::vector<State> States; // of the input's cells
  SourceCells Last{ CodedCells::None, CodedCells::None, CodedCells::None };
  Ids Known;              // vertices of the cell
  Ids Others;             // the input's cells around it
  std::size_t Sorted = 0; // of the following
  struct NearCell
  {
    std::uint32_t Common; // corners
    std::uint32_t Rank;
  };
  std::vector<NearCell> Near;
};
}

#endif
