// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnImageFile_h
#define gtnImageFile_h

// Image files: .png by VTK and libpng, others by OpenImageIO, which is loaded when it is needed
// first.

#include "gtnImage.h"

#include <string>

namespace gtn
{
/** Writes an image; a .png file takes values of type uint8 or uint16. The file gets its name when
 * it is complete. Throws Failure. */
void WriteImageFile(const Image& image, const std::string& file);

/** Reads all images in a file. Throws Failure, and what the function throws. */
void ReadImageFile(const std::string& file, const ImageFunction& take);
}

#endif
