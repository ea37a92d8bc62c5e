// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleySlab_h
#define gatunHartleySlab_h

// The blocks of a slab, summed or composited on one lattice.

#include "gatunHartleyKernel.h"
#include "gatunHartleyLattice.h"
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
  std::size_t Stride = 0;    ///< from one row of points to the next
  std::vector<float> Values; ///< plane by plane

  /** Clears the lattice and sets its extent to the blocks [first, end), across and down. Only parts
   * with content are cleared and interpolated. */
  void Start(const HartleyLattice& lattice, const std::array<std::uint32_t, 2>& first,
    const std::array<std::uint32_t, 2>& end, double middleAlong, std::size_t planes);

  /** The kernel uses eight points at a time. Images of blocks may be accessed as far beyond their
   * end, and rows of the images of ones are as much longer and filled with 0. */
  static constexpr std::size_t Lanes = 8;
  static std::size_t RoundUp(std::size_t points) { return (points + Lanes - 1) / Lanes * Lanes; }

  /** A block and its images. */
  struct Part
  {
    std::array<std::uint32_t, 2> Place{}; ///< across, down
    const float* Unit = nullptr;          ///< of a block of ones
    const float* Image = nullptr;         ///< null: all voxels have the base value
  };

  /** Composites blocks, given from front to back, behind the present content. */
  void Add(
    const HartleyLattice& lattice, const HartleyOpacity& opacities, std::span<const Part> parts);

  /** Composites the slab behind the content of an image, with the planes of the opacity model.
   * Returns whether a pixel is not opaque afterwards. */
  bool AddTo(const HartleyLattice& lattice, const HartleyView& view,
    const HartleyOpacity& opacities, std::vector<float>& pixels) const;

private:
  std::array<std::size_t, 2> GetCorner(
    const HartleyLattice& lattice, const std::array<std::uint32_t, 2>& place) const;
  std::size_t GetPlane() const { return this->Stride * this->Points[1]; }

  // Squares of points, of which it is known whether they have content.
  static constexpr std::size_t CellSize = 8;

  void Clear();
  void Mark(const HartleyLattice& lattice, std::span<const Part> parts);
  bool IsEmpty(double left, double right, double top, double bottom) const;

  std::array<std::uint32_t, 2> First{}; ///< block
  std::size_t Planes = 0;
  std::array<std::size_t, 2> Cells{};
  std::vector<std::uint8_t> HasContent; // of each cell
};
}

#endif
