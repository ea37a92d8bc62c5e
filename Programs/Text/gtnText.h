// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnText_h
#define gtnText_h

// Strings and numbers for people.

#include "gatunDescriptionText.h"

#include <string>

namespace gtn
{
using gatun::DescribeByteSize;
using gatun::DescribeNumber;
using gatun::GroupDigits;
using gatun::Join;
using gatun::MakePrintableLine;

/** A text with the letters of ASCII in lower case. */
std::string LowerOf(std::string text);

/** Whether a name is that of a file on a web server. What follows below takes such a name without
 * its query and its fragment, as mesh.gtn?download=1. */
bool IsAddress(const std::string& name);

/** The part of a path after its last slash. */
std::string FileOf(const std::string& path);

/** A path without its extension. */
std::string StemOf(const std::string& path);

/** The extension of a path in lower case, with its dot, or nothing. */
std::string ExtensionOf(const std::string& path);
}

#endif
