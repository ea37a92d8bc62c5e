// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyBasis_h
#define gatunHartleyBasis_h

#include "gatunHartleyPainter.h"

#include <functional>

namespace gatun
{
/**
 * Computes the image of a block as the weighted sum of the images of its Hartley basis functions.
 * These are computed once for a direction and shared by all blocks. The result is exact except for
 * rounding. The time for a block is proportional to the number of its nonzero coefficients.
 *
 * The basis functions of opposite frequencies are mirror images of each other. Only the even and
 * the odd part of one of them are stored, on one half of the points.
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

  /** Two coefficients of opposite frequencies, or one whose frequency is its own opposite. */
  struct Pair
  {
    std::uint32_t First;
    std::uint32_t Second;
    float Mirror; // image of Second = Mirror * mirrored image of First
  };

  /** The contribution of a coefficient to the weights of its pair's even and odd image. */
  struct Place
  {
    std::uint32_t Pair;
    float Even;
    float Odd;
  };

  void FindPairs();

  HartleyLattice Lattice;
  HartleyLayout::Triple Block{};
  std::size_t Half = 0;     // number of stored points: up to the middle one
  std::size_t Segments = 0; // of HartleySegment points, whose sums stay in registers
  std::vector<Pair> Pairs;
  std::vector<Place> Places; // of each coefficient
  std::vector<float> Images; // of each segment and pair: even, odd
};
}

#endif
