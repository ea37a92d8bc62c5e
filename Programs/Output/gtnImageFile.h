// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnImageFile_h
#define gtnImageFile_h

// What the library gtnImages does for gtn. It is loaded when the first image is read or written,
// because OpenImageIO brings hundreds of libraries along, which would slow down all that gtn does.

#include "gatunTypes.h"

#include <functional>
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

/** A picture of single numbers: a slice of a volume. Rows from the top down. */
struct Slice
{
  int Width = 0;
  int Height = 0;
  int Channels = 1;
  gatun::ScalarType Type = gatun::ScalarType::UInt8;
  const void* Values = nullptr;
};

/** Reads all pictures in a file, one after the other, and gives them to a function; if that returns
 * false, reading ends. A picture of several channels comes without values. Returns whether it
 * could; if not, the reason is set. Throws what the function throws. */
using ReadSlicesFunction = bool(
  const std::string& file, const std::function<bool(const Slice&)>& take, std::string& reason);

inline constexpr const char* ReadSlicesName = "gtnReadSlices";

/** Writes a picture of one channel, as WriteImageFunction does. */
using WriteSliceFunction = bool(const Slice& slice, const std::string& file, std::string& reason);

inline constexpr const char* WriteSliceName = "gtnWriteSlice";
}

#endif
