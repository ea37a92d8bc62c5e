// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyXRay_h
#define gatunHartleyXRay_h

#include "gatunHartleyView.h"
#include "gatunHartleyVolumeSpectrum.h"

#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Draws the sums of a volume along rays from its spectrum: the central slice orthogonal to the
 * rays, times the spectrum of the trilinear basis function, is transformed to an image in sheared
 * coordinates (HartleyLattice), which is resampled to the pixels. The slice is divided by the
 * transform of the resampling kernel, so that resampling adds no blur.
 *
 * The slice ends at the lowest frequency beyond which the mean square of the rest of the image,
 * over the area of the volume, is below a given part of the square of the largest sum. Both are
 * estimates: the rest from some points of the slice, the sum from those along the closest axis.
 */
class HartleyXRay
{
public:
  /** Largest: sums of the volume along each axis. */
  HartleyXRay(std::shared_ptr<const HartleyVolumeSpectrum> spectrum,
    const std::array<double, 3>& largest, double meanSquareError);

  /** Sums of the volume along the rays of all pixels, in samples, row by row. Parallel. */
  void Draw(const HartleyView& view, std::span<float> sums) const;

private:
  class Drawing;

  std::shared_ptr<const HartleyVolumeSpectrum> Spectrum;
  std::array<double, 3> Largest;
  double MeanSquareError;
};
}

#endif
