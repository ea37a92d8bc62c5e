// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellNode_h
#define gatunCellNode_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A point of a nonlinear cell that is no corner. Points are named by their numbers in the cell. */
struct CellNode
{
  static constexpr std::uint16_t None = 0xffff;

  enum class Kind : std::uint8_t
  {
    Edge,
    Triangle,
    Quad,
    Inside ///< no other cell has it
  };

  /** The points that a node is predicted from, as in a CellRecord. */
  enum Slot : std::uint8_t
  {
    N1,
    N2,
    N3,
    D12,
    D13,
    D23,
    O,
    B1,
    B2,
    B3,
    Slots
  };

  Kind Where = Kind::Edge;
  bool IsBetween = false; // whether Near are the corners of Host
  std::uint16_t Point = None;

  /** The node's coordinates in the lattice of a cell of any order, from 0 to the order. */
  std::array<std::uint8_t, 3> Place{};

  /** The corners that the node lies between, then None. There are none inside a cell of any order,
   * and four for the center of a quadratic cell. */
  std::array<std::uint16_t, 4> Host{ None, None, None, None };

  /** The node is the mean of the corners with these weights if the cell is straight. */
  std::array<std::uint16_t, 4> Weights{};

  std::array<std::uint16_t, Slots> Near{ None, None, None, None, None, None, None, None, None,
    None };
};

/** The points of nonlinear cells that are no corners. */
struct CellNodes
{
  std::size_t Corners = 0; // 0 for cells that have no nodes
  std::size_t Points = 0;  // corners and nodes

  /** In an order in which the points that one is predicted from come before it. */
  std::vector<CellNode> Nodes;
};
}

#endif
