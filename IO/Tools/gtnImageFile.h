// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnImageFile_h
#define gtnImageFile_h

// What the library gtnImages does for gtn. It is loaded when the first image is written, because
// OpenImageIO brings hundreds of libraries along, which would slow down all that gtn does.

#include <string>
#include <utility>
#include <vector>

namespace gtn
{
/** Rows from the top down. One of the two lists of values is used, the other one is empty. */
struct Image
{
  int Width = 0;
  int Height = 0;
  std::vector<std::string> Channels;
  std::vector<unsigned char> Bytes;
  std::vector<float> Floats;
  std::vector<std::pair<std::string, std::string>> Remarks; ///< name and text, kept in the file
};

/** Writes a file in the format that its extension tells; .png: with opacity not multiplied in.
 * Returns whether it could; if not, the reason is set. Throws nothing. */
using WriteImageFunction = bool(const Image& image, const std::string& file, std::string& reason);

inline constexpr const char* WriteImageName = "gtnWriteImage";
}

#endif
