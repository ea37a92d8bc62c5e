// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchFiles_h
#define benchFiles_h

// The files that are compared: .gtn in both profiles, the flavors of VTK's own .vtu, and zstd.

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

  bool IsGatun() const { return this->Name.starts_with("gtn"); }
  std::string GetFile(const std::string& folder) const
  {
    return folder + "/" + this->Name +
      (this->IsGatun()                     ? ".gtn"
          : this->Name.starts_with("zstd") ? ".zst"
                                           : ".vtu");
  }
};

/**
 * gtn: the fast profile, which is the default; gtn-small: the small one; vtu-raw, vtu-lz4 and
 * vtu-zlib with VTK's default settings (appended, not in base64); vtu-lzma-best: level 9, 32-bit
 * ids, blocks of 32 MiB; zstd and zstd-shuffle: see benchZstd.h.
 */
const std::vector<Format>& GetFormats();

void Write(const Format& format, vtkUnstructuredGrid* grid, const std::string& file);

/** Reads a .gtn, .vtu or .zst file as a program would that knows nothing of it. Throws Failure. */
Grid Load(const std::string& file);
}

#endif
