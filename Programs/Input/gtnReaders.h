// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnReaders_h
#define gtnReaders_h

// VTK's reader for a file, by the file's extension.

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace gtn
{
/** A reader with all arrays switched on, or nullptr if the extension is not known. sets: whether it
 * also reads the side sets and node sets of an Exodus file, the patches of an OpenFOAM case and the
 * boundaries of a CGNS file. */
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& file, bool sets);

/** The same for regular volumes, but slices. */
vtkSmartPointer<vtkAlgorithm> MakeVolumeReader(const std::string& file);

/** The same for surfaces, but those of ReadObj. */
vtkSmartPointer<vtkAlgorithm> MakeSurfaceReader(const std::string& file);
}

#endif
