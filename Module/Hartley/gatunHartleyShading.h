// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyShading_h
#define gatunHartleyShading_h

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** How the densities along a ray become a colour. */
enum class HartleyLaw : std::uint8_t
{
  XRay = 0,            ///< their sum
  Exponential = 1,     ///< a sample of density D has the opacity 1 - exp(-K D)
  TransferFunction = 2 ///< any opacity of a sample
};

/** Densities to colours. Colours and opacities of a sample, evenly spaced from First to Last. */
struct HartleyShading
{
  HartleyLaw Law = HartleyLaw::XRay;

  /** K of HartleyLaw::Exponential, per sample; densities count from Zero on, below which there is
   * nothing. */
  double Extinction = 0.01;
  double Zero = 0;

  /** Red, green, blue and opacity of one sample, 0 to 1; the opacity is that of
   * HartleyLaw::TransferFunction. At least two. Not used by XRay. */
  std::vector<std::array<float, 4>> Table;
  double First = 0;
  double Last = 255;

  /** For HartleyLaw::XRay: the sums that are black and white; the same: the picture's own. */
  double Black = 0;
  double White = 0;
};
}

#endif
