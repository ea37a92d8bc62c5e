// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnReaders_h
#define gtnReaders_h

// VTK's reader for a file, by the file's extension.

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace gatun
{
class FileReader;
}

namespace gtn
{
/** A reader with all arrays switched on, or nullptr if the extension is not known. sets: whether it
 * also reads the side sets and node sets of an Exodus file, the patches of an OpenFOAM case and the
 * boundaries of a CGNS file. */
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& file, bool sets);

/** The names of the sets, patches and boundaries of a file that a reader without them leaves out.
 * Throws Failure. */
std::vector<std::string> ListSets(const std::string& file);

/** Whether a file holds a surface (vtkPolyData), by its extension, or by its beginning where others
 * have the same extension. */
bool IsSurfaceFile(const std::string& file);

/** What a message says of a mesh without 3D cells, which are named, and of a surface in place of a
 * mesh. */
std::string DescribeFlatCells(const std::string& cells);
std::string DescribeSurface();

/** Throws Failure if a .gtn file holds a surface, or no 3D cells but others. */
void RequireGrid(const gatun::FileReader& file);

/** Whether a file is an Exodus file, by its extension, or by its content if no other reader has the
 * extension. */
bool IsExodus(const std::string& file);

/** The number of blocks and sets of an Exodus file. Throws Failure. */
std::size_t CountExodusBlocks(const std::string& file, bool sets);

/** About the number of bytes of the largest one in memory, with a time step. Throws Failure. */
std::uint64_t EstimateExodusBlock(const std::string& file, bool sets);

/** A reader for one of them. Throws Failure. */
vtkSmartPointer<vtkAlgorithm> MakeExodusReader(
  const std::string& file, bool sets, std::size_t number);

/** The same for regular volumes, but slices. */
vtkSmartPointer<vtkAlgorithm> MakeVolumeReader(const std::string& file);

/** The same for surfaces. */
vtkSmartPointer<vtkAlgorithm> MakeSurfaceReader(const std::string& file);
}

#endif
