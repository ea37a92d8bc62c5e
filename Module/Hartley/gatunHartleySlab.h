// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleySlab_h
#define gatunHartleySlab_h

// Blocks of a slab, added up or composited on one lattice.

#include "gatunHartleyLattice.h"
#include "gatunHartleyLookup.h"
#include "gatunHartleyView.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace gatun
{
/** The lattice of some blocks of a slab. */
struct HartleySlab
{
  /** Points around the blocks' pictures, for interpolation. */
  static constexpr std::size_t Margin = 2;

  std::array<double, 2> Origin{}; ///< sheared coordinates of the first point
  std::array<std::size_t, 2> Points{};
  std::vector<std::array<float, 4>> Channels;

  /** For blocks from first up to, not including, end, across and down. */
  void Start(const HartleyLattice& lattice, const std::array<std::uint32_t, 2>& first,
    const std::array<std::uint32_t, 2>& end, double middleAlong);

  /** A block, and the pictures that are known of it. */
  struct Part
  {
    std::array<std::uint32_t, 2> Place{}; ///< across, down
    const float* Unit = nullptr;          ///< of ones
    const float* Picture = nullptr;       ///< null: nothing but the base value
  };

  /** Adds blocks, those in front first, behind what is there. */
  void Add(const HartleyLattice& lattice, const HartleyLookup& lookup, std::span<const Part> parts);

  /** Adds what is here behind what is in a picture. Returns whether there are pixels through which
   * light still comes. */
  bool AddTo(const HartleyLattice& lattice, const HartleyView& view, const HartleyLookup& lookup,
    std::vector<std::array<float, 4>>& pixels) const;

private:
  std::array<std::size_t, 2> GetCorner(
    const HartleyLattice& lattice, const std::array<std::uint32_t, 2>& place) const;

  std::array<std::uint32_t, 2> First{}; ///< block
};
}

#endif
