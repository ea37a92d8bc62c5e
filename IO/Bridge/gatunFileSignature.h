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
 * What tells one content of a file from a later one, without reading it: which file it is, how
 * long, and when it was written.
 */
struct FileSignature
{
  std::uint64_t Device = 0;
  std::uint64_t Inode = 0;
  std::int64_t Size = -1; ///< -1: there is no such file
  std::int64_t Seconds = 0;
  std::int64_t Nanoseconds = 0;

  bool operator==(const FileSignature&) const = default;
};

VTKGATUNIO_EXPORT FileSignature SignatureOf(const std::string& path);
}

#endif
