// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnLayers_h
#define gtnLayers_h

// The layers of values by which a .gtn file is organised, as gtn info tells them.

#include "gtnJson.h"

#include "gatunFileReader.h"

namespace gtn
{
/** Both do nothing without layers. */
void PrintLayers(const gatun::FileReader& file);
void AddLayers(Json& json, const gatun::FileReader& file);
}

#endif
