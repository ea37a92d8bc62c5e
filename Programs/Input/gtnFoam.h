// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnFoam_h
#define gtnFoam_h

// Cases of OpenFOAM, which a .foam file marks.

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAlgorithm;

namespace gtn
{
/** A reader with all fields switched on; sets: with the patches, too. Throws Failure for a case
 * that is decomposed. */
vtkSmartPointer<vtkAlgorithm> MakeFoamReader(const std::string& file, bool sets);

/** The names of the patches. Throws Failure. */
std::vector<std::string> ListFoamPatches(const std::string& file);
}

#endif
