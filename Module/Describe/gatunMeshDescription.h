// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMeshDescription_h
#define gatunMeshDescription_h

#include "gatunDescription.h"

namespace gatun
{
class FileReader;

/** What is in a .gtn file and the sizes of its parts, from its directory alone. Verbose: also each
 * chunk. Throws Error. */
GATUN_EXPORT Description DescribeMesh(const FileReader& file, bool verbose);
}

#endif
