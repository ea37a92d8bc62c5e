// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceTable_h
#define gatunSurfaceTable_h

// The SURF section, which marks the mesh of a file as a surface. See Documentation/format.md, 16.

#include "gatunBytes.h"
#include "gatunTypes.h"

#include <span>
#include <vector>

namespace gatun
{
Bytes WriteSurfaceMark();

/** Throws unless the section is right and the cells of all types can be part of a surface. */
void CheckSurfaceMark(std::span<const std::uint8_t> bytes, const std::vector<CellTypeCount>& types);
}

#endif
