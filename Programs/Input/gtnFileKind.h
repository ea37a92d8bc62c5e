// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnFileKind_h
#define gtnFileKind_h

// What a file is by its content, where the extension does not tell.

#include <string>

namespace gtn
{
/** Whether a file is netCDF, by its first bytes, and so possibly Exodus. */
bool IsNetCDF(const std::string& file);

/** Whether a file is netCDF with the dimensions of Exodus. */
bool HasExodusContent(const std::string& file);

/** Whether a file may be CGNS, as HDF5 or in the older form ADF. */
bool HasCGNSContent(const std::string& file);
}

#endif
