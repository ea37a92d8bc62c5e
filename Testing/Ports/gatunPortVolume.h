// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunPortVolume_h
#define gatunPortVolume_h

#include "gatunPortFile.h"

namespace gatun::port
{
/** The coefficients and the voxels of a volume, and the file that is written of them. */
void AddVolume(Line& line, const std::string& path);
}

#endif
