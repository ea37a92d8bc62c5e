// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file gatunVersion.h
 * @brief The version of the package and the versions of the file formats, which are independent.
 *
 * The package version counts releases of the software. A format version is a number in the header
 * of each file; a reader rejects files with another one. The build takes the package version from
 * the macros below.
 */

#ifndef gatunVersion_h
#define gatunVersion_h

#include "gatunExport.h"

#define GATUN_VERSION_MAJOR 0
#define GATUN_VERSION_MINOR 1
#define GATUN_VERSION_PATCH 0

#define GATUN_FORMAT_VERSION 1        // of `.gtn` files
#define GATUN_VOLUME_FORMAT_VERSION 1 // of `.ghv` files

namespace gatun
{

/// The version of the loaded library, such as "0.1.0". It may differ from the macros, which belong
/// to the headers. Never null, valid until the program ends. Thread safe.
GATUN_EXPORT const char* PackageVersion() noexcept;

/// The version of the `.gtn` format that the loaded library reads and writes, "1". As above.
GATUN_EXPORT const char* FormatVersion() noexcept;

} // namespace gatun

#endif
