// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellRows_h
#define gatunCellRows_h

// The order in which a CellTree has its cells.

#include "gatunCellList.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The cells around each vertex. Of long cells, only the first corners count; vertices of very many
 * cells have none, because looking at them would take too long. */
class CellUsers
{
public:
  static constexpr std::size_t MaxCorners = 32;
  static constexpr std::size_t MaxUsers = 128;

  explicit CellUsers(const CellList& cells, std::size_t vertices);

  std::span<const std::uint32_t> Get(std::uint32_t vertex) const
  {
    const auto count = this->Starts[vertex + 1] - this->Starts[vertex];
    return std::span(this->Users).subspan(this->Starts[vertex], count <= MaxUsers ? count : 0);
  }

  static std::span<const std::uint32_t> GetFirst(std::span<const std::uint32_t> corners)
  {
    return corners.first(std::min(corners.size(), MaxCorners));
  }

private:
  std::vector<std::uint32_t> Starts;
  std::vector<std::uint32_t> Users;
};

/** Orders cells: in rows through opposite sides as long as possible, each beginning at a neighbor
 * of the first cell that has one left. */
std::vector<std::uint32_t> FindCellRows(const CellList& cells, const CellUsers& users);
}

#endif
