// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLayerDescription_h
#define gatunLayerDescription_h

// The layers of values by which a .gtn file is organized.

#include "gatunDescription.h"

#include "gatunFileReader.h"

namespace gatun
{
/** Adds the layers of a file that has some. */
void DescribeLayers(const FileReader& file, Description& description);
}

#endif
