// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnLibrary_h
#define gtnLibrary_h

// Libraries of gtn that are loaded on demand, because loading what they need takes longer than most
// commands.

#include <string>

namespace gtn
{
/**
 * Loads one of the libraries in the folder "gatun" next to those of Gatun, such as "gtnImages", and
 * returns what it exports by a name. Nothing else of this name is loaded, whatever the environment
 * says. Throws Failure, which says that gtn cannot do the purpose, such as "read
 * images", if there is no such library or name.
 */
const void* LoadLibrary(const char* library, const char* name, const std::string& purpose);
}

#endif
