// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileSignature_h
#define gatunFileSignature_h

#include "vtkGatunIOModule.h" // For export macro

#include <cstdint>
#include <string>

namespace gatun
{
/**
 * Identifies the content of a file without reading it, by device, inode, size and modification
 * time.
 */
struct FileSignature
{
  std::uint64_t Device = 0;
  std::uint64_t Inode = 0;
  std::int64_t Size = -1; ///< -1 if the file does not exist
  std::int64_t Seconds = 0;
  std::int64_t Nanoseconds = 0;

  bool operator==(const FileSignature&) const = default;
};

/** Returns the signature of a file; Size is -1 if there is no such file. Does not throw. */
VTKGATUNIO_EXPORT FileSignature SignatureOf(const std::string& path);
}

#endif
