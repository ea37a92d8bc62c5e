// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnNames_h
#define gtnNames_h

// What the format's numbers are called.

#include "gatunTypes.h"

#include "gatunFileReader.h"

#include <cstdint>
#include <string>

namespace gtn
{
/** As numpy has it: "float32". */
const char* NameOf(gatun::ScalarType type);

/** The class of VTK for a cell type, "vtkHexahedron", or "of type 200" if there is none. */
std::string NameOfCell(int type);

/** "1,200 tetrahedra", or "1,200 cells (1,000 vtkHexahedron, 200 vtkWedge)". */
std::string ListCells(const gatun::FileReader& file);

/** "points, cells, corners" of flags of gatun::KeepOrder, or "none". */
std::string NameOfOrder(std::uint8_t kept);
}

#endif
