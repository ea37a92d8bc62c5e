// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnUnpackHDF_h
#define gtnUnpackHDF_h

#include <string>

namespace gtn
{
class Input;
struct Settings;

/** Writes all time steps to a .vtkhdf file; a file of that name is replaced once the new one is
 * complete. Returns what such a file does not hold, as a list for a warning. Throws Failure, also
 * for what VTK cannot write: polyhedra, text at points or cells, cells or arrays that change. */
std::string WriteHDF(
  Input& input, const std::string& file, bool compress, const Settings& settings);
}

#endif
