// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * @brief GATUN_EXPORT marks the exported symbols of the core. All else is hidden.
 *
 * Headers of the core name nothing of VTK, so that its code is the same for every VTK.
 */

#ifndef gatunExport_h
#define gatunExport_h

#if defined(_WIN32)
#define GATUN_EXPORT // the core is no library of its own there
#else
#define GATUN_EXPORT __attribute__((visibility("default")))
#endif

#endif
