// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyBasis_h
#define gatunHartleyBasis_h

#include "gatunHartleyPainter.h"

#include <functional>

namespace gatun
{
/**
 * Pictures of blocks as sums of the pictures of their basis functions, which are computed once for
 * a direction and serve all blocks: exact, and the work for a block is that of its coefficients
 * that are not zero.
 *
 * A basis function and its partner of the opposite frequency are mirror images. What is kept of the
 * two is the even and the odd part of the one, on one half of the points.
 */
class HartleyBasis : public HartleyPainter
{
public:
  HartleyBasis(const HartleyLayout::Triple& block, const HartleyLattice& lattice,
    const std::function<bool(double)>& progress = {});

  std::unique_ptr<Brush> MakeBrush() const override;
  std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const override;

private:
  class PairBrush;

  /** Coefficients of opposite frequencies, or one that is its own opposite. */
  struct Pair
  {
    std::uint32_t First;
    std::uint32_t Second;
    float Mirror; // the picture of Second is that of First mirrored, times this
  };

  /** What a coefficient adds to the weights of its pair's even and odd picture. */
  struct Place
  {
    std::uint32_t Pair;
    float Even;
    float Odd;
  };

  void FindPairs();

  HartleyLattice Lattice;
  HartleyLayout::Triple Block{};
  std::size_t Half = 0;     // points that are kept: up to the middle one
  std::size_t Segments = 0; // of so many of them that the sums of all stay in registers
  std::vector<Pair> Pairs;
  std::vector<Place> Places;   // of each coefficient
  std::vector<float> Pictures; // of each segment and pair: even, odd
};
}

#endif
