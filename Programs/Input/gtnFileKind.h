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

/** The type that a file of VTK's XML declares, such as PolyData; nothing if it declares none. */
std::string ReadXMLType(const std::string& file);

/** Throws Failure if a file of VTK's XML, by its extension, declares a type of data that is not
 * read, or another one than .vtu and .vtp files have. VTK's readers do not check it. */
void CheckXMLType(const std::string& file);

/** Whether a file is text in UTF-16, by its first bytes. */
bool IsWideText(const std::string& file);

/** Throws Failure if the values of an .nrrd or .nhdr file are text, which VTK reads as zeros. */
void CheckNrrd(const std::string& file);

/** Whether a file may be CGNS, as HDF5 or in the older form ADF. */
bool HasCGNSContent(const std::string& file);
}

#endif
