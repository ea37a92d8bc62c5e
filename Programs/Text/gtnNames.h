// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnNames_h
#define gtnNames_h

// What the format's numbers are called.

#include "gatunDescriptionText.h"
#include "gatunFileReader.h"

#include <string>

namespace gtn
{
using gatun::NameOfCellType;
using gatun::NameOfKeptOrder;
using gatun::NameOfProfile;
using gatun::NameOfType;

/** "1,200 tetrahedra", or "1,200 cells (1,000 vtkHexahedron, 200 vtkWedge)". */
std::string ListCells(const gatun::FileReader& file);
}

#endif
