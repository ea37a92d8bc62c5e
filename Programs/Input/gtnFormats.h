// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnFormats_h
#define gtnFormats_h

// Readers and a writer that need netCDF or HDF5, in a library that is loaded on demand.

#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace gtn
{
/** The readers are made with all arrays switched on. The functions do not throw. */
struct FormatFunctions
{
  /** sets: whether to read side sets and node sets, too. */
  vtkSmartPointer<vtkAlgorithm> (*MakeExodus)(const std::string& file, bool sets);

  /** Appends the names of the side sets and node sets that a reader of Exodus files knows. */
  void (*ListExodusSets)(vtkAlgorithm* reader, std::vector<std::string>& names);

  /** The number of blocks and sets that a reader of Exodus files reads. */
  int (*CountExodusBlocks)(vtkAlgorithm* reader);

  /** About the number of bytes of the largest one in memory, with a time step. */
  std::uint64_t (*EstimateExodusBlock)(vtkAlgorithm* reader);

  /** Makes it read only one of them. */
  void (*SelectExodusBlock)(vtkAlgorithm* reader, int number);

  /** sets: whether to read boundaries, too. Null if this VTK has no reader of CGNS files. */
  vtkSmartPointer<vtkAlgorithm> (*MakeCGNS)(const std::string& file, bool sets);

  vtkSmartPointer<vtkAlgorithm> (*MakeHDF)(const std::string& file);

  /** Writes all time steps of a grid or surface. Null if this VTK has no writer. */
  bool (*WriteHDF)(vtkAlgorithm* source, const std::string& file, bool compress);
};

/** The functions that the library gtnFormats exports by this name. */
inline constexpr const char* FormatFunctionsName = "gtnFormatFunctions";

/** Loads the library. Throws Failure. */
const FormatFunctions& GetFormatFunctions();
}

#endif
