// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnComplex_h
#define gtnComplex_h

// Tetrahedra whose points and cells have labels instead of places.

#include "gtnGridView.h"
#include "gtnHash.h"

#include <cstddef>
#include <vector>

namespace gtn
{
class Complex
{
public:
  std::vector<Hash> Points;
  std::vector<Hash> Cells;
  std::vector<Tet> Tets;
  bool KeepCorners = false; ///< else tetrahedra are told apart up to even permutations only

  /** One of each cell: its label and its points' labels. Independent of all order. */
  std::vector<Hash> HashTets() const;

  /** Adds to the label of each point what it sees of the tetrahedra around it. */
  void Refine();

  /**
   * Hashes of the parts of the mesh in which labels do not tell the points apart, sorted. Two
   * complexes whose points have the same labels, refined, and whose tetrahedra have the same hashes
   * are the same exactly if these are, too.
   *
   * Points of equal labels hang together where they are corners of one tetrahedron. In each such
   * part one point after the other is marked, among those that look alike, until all points are
   * distinct; the smallest of the outcomes is taken, so that the choice does not matter. That may
   * take long for highly symmetric parts: false if the work exceeds the budget, a number of visits
   * of tetrahedra, which is counted down.
   */
  bool HashAmbiguousParts(std::size_t& budget, std::vector<Hash>& hashes) const;

private:
  bool HashCanonically(std::size_t& budget, Hash& hash) const;
};

/** Number of distinct labels. */
std::size_t CountDistinct(std::vector<Hash> labels);
}

#endif
