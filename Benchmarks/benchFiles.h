// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchFiles_h
#define benchFiles_h

// The files that are compared: .gtn and the flavours of VTK's own .vtu.

#include "benchHarness.h"
#include "benchMeshes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bench
{
/** A way to store a grid. */
struct Format
{
  std::string Name; ///< gtn, vtu-raw, vtu-zlib, ...
  bool IsSlow;      ///< to write, so once is enough

  bool IsGatun() const { return this->Name.starts_with("gtn"); }
  std::string GetFile(const std::string& folder) const
  {
    return folder + "/" + this->Name + (this->IsGatun() ? ".gtn" : ".vtu");
  }
};

/**
 * gtn with default settings, gtn-fast with the fast profile; vtu-zlib with VTK's default settings
 * (appended, not in base64); vtu-lzma-best: level 9, 32-bit ids, blocks of 32 MiB. Write also takes
 * vtu-raw, without compression.
 */
const std::vector<Format>& GetFormats();

void Write(const Format& format, vtkUnstructuredGrid* grid, const std::string& file);

/** Reads a .gtn or .vtu file as a program would that knows nothing of it. Throws Failure. */
Grid Load(const std::string& file);
}

#endif
