// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnLayers_h
#define gtnLayers_h

// The layers of values by which a .gtn file is organized, as gtn info prints them.

#include "gtnDescription.h"

#include "gatunFileReader.h"

namespace gtn
{
/** Adds the layers of a file that has some. */
void DescribeLayers(const gatun::FileReader& file, Description& description);
}

#endif
