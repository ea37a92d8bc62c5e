// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyXRays_h
#define gatunHartleyXRays_h

#include "gatunHartleyImage.h"
#include "gatunHartleyShading.h"
#include "gatunHartleySource.h"
#include "gatunHartleyXRay.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace gatun
{
/** X-rays of all of a volume, whatever its blocks are, from one spectrum for all directions. */
class HartleyXRays
{
public:
  /** Makes the spectrum, unless it is there. Returns false if it takes more than a number of bytes;
   * then X-rays are to be drawn block by block. Throws the errors of the source, and Error(Aborted)
   * if progress returns false. */
  bool Make(
    const HartleySource& source, std::uint64_t bytes, const std::function<bool(double)>& progress);

  /** Make must have returned true. */
  HartleyImage Draw(const HartleyView& view, const HartleyShading& shading) const;

private:
  HartleyLayout::Triple Size{};
  std::unique_ptr<HartleyXRay> XRay;
  double Border = 0; // value of a box that the spectrum does not contain
  bool Unfit = false;
};

/** Adds the base to the sums of an image, which has sums and samples, and makes its colors. */
void FinishHartleyXRay(const HartleyShading& shading, double base, HartleyImage& image);
}

#endif
