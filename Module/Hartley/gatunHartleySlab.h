// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleySlab_h
#define gatunHartleySlab_h

// The blocks of a slab, summed or composited on one lattice.

#include "gatunHartleyLattice.h"
#include "gatunHartleyLookup.h"
#include "gatunHartleyView.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace gatun
{
/** The lattice of a rectangle of blocks. */
struct HartleySlab
{
  /** Points around the images of the blocks, for interpolation. */
  static constexpr std::size_t Margin = 2;

  std::array<double, 2> Origin{}; ///< sheared coordinates of the first point
  std::array<std::size_t, 2> Points{};
  std::vector<std::array<float, 4>> Channels;

  /** Clears the lattice and sets its extent to the blocks [first, end), across and down. */
  void Start(const HartleyLattice& lattice, const std::array<std::uint32_t, 2>& first,
    const std::array<std::uint32_t, 2>& end, double middleAlong);

  /** A block and its images. */
  struct Part
  {
    std::array<std::uint32_t, 2> Place{}; ///< across, down
    const float* Unit = nullptr;          ///< of a block of ones
    const float* Image = nullptr;         ///< null: all voxels have the base value
  };

  /** Composites blocks, given from front to back, behind the present content. */
  void Add(const HartleyLattice& lattice, const HartleyLookup& lookup, std::span<const Part> parts);

  /** Composites the slab behind the content of an image. Returns whether a pixel is not opaque
   * afterwards. */
  bool AddTo(const HartleyLattice& lattice, const HartleyView& view, const HartleyLookup& lookup,
    std::vector<std::array<float, 4>>& pixels) const;

private:
  std::array<std::size_t, 2> GetCorner(
    const HartleyLattice& lattice, const std::array<std::uint32_t, 2>& place) const;

  std::array<std::uint32_t, 2> First{}; ///< block
};
}

#endif
