// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnGridWriter_h
#define gtnGridWriter_h

#include <string>
#include <vector>

class vtkUnstructuredGrid;
class vtkXMLWriterBase;

namespace gtn
{
class Progress;

/** How to store what VTK writes. */
enum class Compressor
{
  None,
  ZLib,
  LZ4,
  LZMA
};

/** Sets the compressor of a writer of XML files. */
void SetCompressor(vtkXMLWriterBase* writer, Compressor compressor);

/** Writes a .pvd file: a list of files in its folder with their times. Throws Failure. */
void WriteCollection(
  const std::string& file, const std::vector<std::string>& parts, const std::vector<double>& times);

/** Writes a .vtu or .vtk file by its extension; a file of that name is replaced once the new one is
 * complete. A .vtk file is binary and takes no compressor. Throws Failure. */
void WriteGrid(
  vtkUnstructuredGrid* grid, const std::string& file, Compressor compressor, Progress& progress);
}

#endif
