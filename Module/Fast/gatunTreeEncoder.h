// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeEncoder_h
#define gatunTreeEncoder_h

#include "gatunBytes.h"
#include "gatunTetTree.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
struct EncodedTree
{
  Bytes Stream;
  TetTree Tree;
  std::vector<std::uint32_t> TetOrder; ///< of the input's tetrahedra

  /** For each tetrahedron, before it is flipped, the places of its first three corners among those
   * of the input's: two bits each. */
  std::vector<std::uint8_t> Turns;

  std::vector<std::uint32_t> OwnOrder; ///< of the input's own vertices, from 0

  static constexpr unsigned NoTurn = 0 | 1 << 2 | 2 << 4;

  static constexpr std::array<unsigned, 4> GetPlaces(unsigned turn)
  {
    const unsigned a = turn & 3;
    const unsigned b = turn >> 2 & 3;
    const unsigned c = turn >> 4;
    return { a, b, c, a ^ b ^ c };
  }

  /** Whether a turn is an odd permutation. */
  static constexpr bool IsMirrored(unsigned turn)
  {
    const auto p = GetPlaces(turn);
    const int swaps =
      (p[0] > p[1]) + (p[0] > p[2]) + (p[0] > p[3]) + (p[1] > p[2]) + (p[1] > p[3]) + (p[2] > p[3]);
    return swaps % 2 != 0;
  }
};

/** Encodes tetrahedra. Vertices below shared are the shared ones; each is used. */
EncodedTree EncodeTree(
  std::span<const std::array<std::uint32_t, 4>> tets, std::uint32_t shared, std::uint32_t vertices);
}

#endif
