// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHartleyOutput_h
#define gatunHartleyOutput_h

#include "gatunHartleyProjector.h"

#include <array>
#include <optional>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkImageData;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
struct ImageOutput
{
  std::optional<std::array<double, 3>> Background; ///< red, green, blue; none: transparent
  bool Floats = false;                             ///< adds the arrays of OutputFloats
};

/** Fills a vtkImageData with the part of an image that an extent selects, with the arrays that
 * vtkGatunHartleyProjection documents. */
void FillImage(const HartleyImage& drawn, const ImageOutput& options,
  const std::array<int, 6>& extent, vtkImageData* output);
}

#endif
