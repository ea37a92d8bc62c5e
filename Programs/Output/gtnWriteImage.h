// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnWriteImage_h
#define gtnWriteImage_h

// Rendered images as files.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;

namespace gtn
{
/** Red, green, blue, 0 to 1. */
using Color = std::array<double, 3>;

/** The extensions of the files that WriteImage writes. */
extern const char* const ImageFormats;
bool IsImage(const std::string& file);

/**
 * Writes the array RGBA of a rendered image over a background, or transparent without one. In a
 * .png file, opacity is not multiplied into the colors, as the format demands. In an .exr file it
 * is, and the channel Z is the array Depth, if there is one. The remarks are keys and strings that
 * are stored in the file. The file gets its name when it is complete. Throws Failure.
 */
void WriteImage(vtkImageData* rendered, const std::optional<Color>& background,
  const std::vector<std::pair<std::string, std::string>>& remarks, const std::string& file);
}

#endif
