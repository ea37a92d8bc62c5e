// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayPieces_h
#define gatunRayPieces_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/** The four channels of a RayTable between two places as parabolas: C0 + x C1 + x^2 C2, x the
 * distance from the center in cells. */
struct alignas(64) RayPiece
{
  float Center = 0, From = 0, To = 0;
  alignas(16) std::array<float, 4> C0{}, C1{}, C2{};

  bool operator==(const RayPiece&) const = default;
};

/**
 * A table of a function as few pieces, in order. Between the boundaries of cells, the table is
 * linear. The pieces deviate from it by no more than 1 / 4096 of the largest absolute value of a
 * channel in the piece. A piece is either visible, with a last channel above 0, or invisible
 * throughout. Steps of the function are ends of pieces; they are located to 1 / 16384 of a cell.
 * The first and the last piece are constant and lie beyond the cells.
 */
struct RayPieces
{
  std::vector<RayPiece> All;

  /** The first and the last piece of each cell; one more than there are cells. */
  std::vector<std::array<std::uint16_t, 2>> OfCells;

  bool operator==(const RayPieces&) const = default;
};

/** The channels at a place, counted in cells. */
using RayEntry = std::function<std::array<double, 4>(double place)>;

RayPieces MakeRayPieces(const RayEntry& getEntry, std::size_t cells);
}

#endif
