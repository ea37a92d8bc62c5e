// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPng_h
#define gtnPng_h

#include "gtnImage.h"

#include <string>

namespace gtn
{
/** Reads a .png file with values of type uint8 or uint16, as ImageCodec::Read does. Damaged files
 * are refused with a reason.
 *
 * Not by vtkPNGReader or OpenImageIO: for damaged files, libpng then writes messages of its own. */
bool ReadPNG(const std::string& file, const ImageFunction& take, std::string& reason);
}

#endif
