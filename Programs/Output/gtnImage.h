// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnImage_h
#define gtnImage_h

// An image in memory, and the functions that read and write image files.

#include "gatunTypes.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gtn
{
/** Values of one type, channel by channel within a pixel. Rows go from the top down. */
struct Image
{
  int Width = 0;
  int Height = 0;
  std::vector<std::string> Channels; ///< their names
  gatun::ScalarType Type = gatun::ScalarType::UInt8;
  const void* Values = nullptr;
  std::vector<std::pair<std::string, std::string>> Remarks = {}; ///< keys and strings for the file
};

/** Takes an image of a file. Returns false to end the reading. */
using ImageFunction = std::function<bool(const Image&)>;

/**
 * Functions for some file formats. They return whether they succeed, and set the reason otherwise.
 */
struct ImageCodec
{
  /** Writes a file, whose extension names the format. Opacity is multiplied into the colors for
   * float values, and is not for others. Does not throw. */
  bool (*Write)(const Image& image, const std::string& file, std::string& reason);

  /** Reads the images in a file, one after the other. An image of several channels comes without
   * values. Throws what the function throws, and nothing else. */
  bool (*Read)(const std::string& file, const ImageFunction& take, std::string& reason);
};

/** The functions that the library gtnImages, which is loaded on demand, exports by this name. */
inline constexpr const char* ImageCodecName = "gtnImageCodec";
}

#endif
