// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchPixels_h
#define benchPixels_h

#include <string>
#include <vector>

namespace bench
{
/** Red, green, blue and opacity of the pixels of a picture, row by row from below. */
using Pixels = std::vector<float>;

/** Writes the colors of a square picture, on black, as a .png file. Throws Failure. */
void WritePicture(const Pixels& pixels, int size, const std::string& file);
}

#endif
