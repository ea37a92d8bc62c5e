// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPicture_h
#define gtnPicture_h

// What vtkGatunRayCaster or vtkGatunHartleyProjection drew, as a file.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;

namespace gtn
{
/** Red, green, blue, 0 to 1. */
using Colour = std::array<double, 3>;

/** Extensions of the files that WritePicture makes. */
extern const char* const PictureFormats;
bool IsPicture(const std::string& file);

/**
 * Writes a picture, its array RGBA, over a background or transparent. In a .png file, opacity is
 * not multiplied into the colours, as that format wants it; in an .exr file it is, and the channel
 * Z is the array Depth, if there is one. The remarks are names and texts to keep in the file. It
 * gets its name when it is complete. Throws Failure.
 */
void WritePicture(vtkImageData* picture, const std::optional<Colour>& background,
  const std::vector<std::pair<std::string, std::string>>& remarks, const std::string& file);
}

#endif
