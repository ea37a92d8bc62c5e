// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyImage_h
#define gatunHartleyImage_h

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** How the image of a block is computed from its coefficients. */
enum class HartleyMethod : std::uint8_t
{
  /** X-rays by the spectrum of the whole volume. Other models: Voxels for blocks of up to 64 voxels
   * along each axis; Slice for larger ones. */
  Automatic = 0,
  Basis = 1, ///< weighted sum of the images of the basis functions, which all blocks share
  Slice = 2, ///< inverse transform of a slice through the block's spectrum
  Voxels = 3 ///< weighted sum of the voxels next to each ray
};

/** An image. All arrays are stored row by row; the first row is that of HartleyView::Origin. */
struct HartleyImage
{
  unsigned Width = 0;
  unsigned Height = 0;
  std::vector<std::array<float, 4>> Colors; ///< red, green, blue, opacity; premultiplied
  std::vector<float> Sums;                  ///< XRay only: sum of the densities along the ray
  std::vector<float> Samples;               ///< XRay only: number of samples in the volume

  // Statistics.
  std::uint64_t Terms = 0;  ///< coefficients that were summed
  std::uint64_t Blocks = 0; ///< blocks that were drawn
  HartleyMethod Method = HartleyMethod::Basis;
};
}

#endif
