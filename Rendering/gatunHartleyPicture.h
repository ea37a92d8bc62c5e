// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHartleyPicture_h
#define gatunHartleyPicture_h

#include "gatunHartleyProjector.h"

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

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
struct PictureOutput
{
  std::optional<std::array<double, 3>> Background; ///< red, green, blue; none: transparent
  bool Floats = false; ///< the other arrays, too, as far as the picture has them
};

/** Fills an image with a part of a picture, as vtkHartleyProjection describes its arrays. */
void FillImage(const HartleyPicture& picture, const PictureOutput& options,
  const std::array<int, 6>& extent, vtkImageData* image);
}

#endif
