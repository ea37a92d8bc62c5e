// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPng_h
#define gtnPng_h

#include "gtnImage.h"

namespace gtn
{
/** Reads and writes .png files with values of type uint8 or uint16. Damaged files are refused with
 * a reason. */
extern const ImageCodec PngCodec;
}

#endif
