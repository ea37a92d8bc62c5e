// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyShading_h
#define gatunHartleyShading_h

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** How the densities along a ray determine the color and opacity of a pixel. */
enum class HartleyOpacityModel : std::uint8_t
{
  XRay = 0,            ///< gray level by the sum of the densities
  Exponential = 1,     ///< a sample of density D has the opacity 1 - exp(-K D)
  TransferFunction = 2 ///< the opacity of a sample comes from the table
};

/** Opacity model and transfer function. */
struct HartleyShading
{
  HartleyOpacityModel OpacityModel = HartleyOpacityModel::XRay;

  /** Exponential: the extinction K of one sample. Densities are measured from Zero; lower ones are
   * transparent. */
  double Extinction = 0.01;
  double Zero = 0;

  /** Red, green, blue and opacity of one sample, 0 to 1, for densities that are evenly spaced from
   * First to Last. At least two entries. XRay does not use it; Exponential uses the colors only. */
  std::vector<std::array<float, 4>> Table;
  double First = 0;
  double Last = 255;

  /** XRay: the sums that are drawn black and white. If they are equal, the smallest and the largest
   * sum of the image. */
  double Black = 0;
  double White = 0;
};
}

#endif
