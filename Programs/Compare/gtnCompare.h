// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCompare_h
#define gtnCompare_h

#include "gtnGridView.h"
#include "gtnHash.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gtn
{
/**
 * Tells whether two grids of tetrahedra are the same, bit for bit, step after step of time.
 *
 * Where an order is kept (flags of gatun::KeepOrder), values are compared place by place. Where it
 * is not, points and cells are matched by all that is known of them: a point is its coordinates
 * and the values of its arrays, at this step and those before; a tetrahedron is its four points up
 * to an even permutation, and its values. What coincides in all that is told apart by its
 * neighbours, and theirs. Each point and each cell is a hash then, and the sorted hashes of both
 * grids must be equal.
 *
 * This is exact, but for a hash of 128 bits. Points that coincide in everything and are alike in
 * their surroundings, too, are matched in all ways; where that would take too long, the outcome is
 * a difference that says "undecided".
 */
class Comparison
{
public:
  /** Names of the two, for messages. */
  Comparison(std::string first, std::string second, std::uint8_t keptOrder);

  /** Compares a step. Returns the first difference in words, or nothing. */
  std::string Compare(const GridView& first, const GridView& second);

  /** How many points coincide with others in everything but their neighbours, at the last step. */
  std::size_t GetAmbiguousPoints() const { return this->Ambiguous; }

private:
  struct Side
  {
    std::string Name;
    std::vector<Hash> Points; ///< what is known of each point, over all steps so far
    std::vector<Hash> Cells;  ///< the same of each cell without its corners
  };

  std::string CompareOrdered(const GridView& first, const GridView& second) const;
  std::string CompareUnordered(const GridView& first, const GridView& second);
  std::string ExplainPoints(const GridView& first, const GridView& second) const;
  std::string ExplainCells(const GridView& first, const GridView& second) const;

  Side First;
  Side Second;
  std::uint8_t Kept;
  std::size_t Ambiguous = 0;
};
}

#endif
