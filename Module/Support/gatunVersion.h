// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file gatunVersion.h
 * @brief The version of the package and the version of the file format, which move apart.
 *
 * The package version counts releases of the software. The format version is the one written into
 * new `.gtn` files: a new major number breaks older readers, a new minor number only adds what
 * they may skip. The build takes the package version from the macros below.
 */

#ifndef gatunVersion_h
#define gatunVersion_h

#include "vtkGatunCoreModule.h"

#define GATUN_VERSION_MAJOR 0
#define GATUN_VERSION_MINOR 1
#define GATUN_VERSION_PATCH 0

#define GATUN_FORMAT_VERSION_MAJOR 1
#define GATUN_FORMAT_VERSION_MINOR 2

// The same of `.ghv` files.
#define GATUN_VOLUME_FORMAT_VERSION_MAJOR 1
#define GATUN_VOLUME_FORMAT_VERSION_MINOR 0

namespace gatun
{

/// Version of the library that is loaded, such as "0.1.0"; it may differ from the macros, which
/// are those of the headers. Never null, lives as long as the program. Thread safe.
VTKGATUNCORE_EXPORT const char* PackageVersion() noexcept;

/// Version of the format that the loaded library writes, such as "1.0". As above.
VTKGATUNCORE_EXPORT const char* FormatVersion() noexcept;

} // namespace gatun

#endif
