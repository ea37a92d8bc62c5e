// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnParseJson_h
#define gtnParseJson_h

// Files that are JSON. (gtnJson.h writes it.)

#include "vtk_jsoncpp.h"

#include <string>
#include <vector>

namespace gtn
{
/** What a file holds. Returns false, and says why, if that is not JSON. */
bool ParseJson(const std::string& file, ::Json::Value& root, std::string& reason);

/** The same, but throws Failure: no such file, not JSON. */
::Json::Value ReadJson(const std::string& file);

/** The numbers of an array. Throws Failure for the file, with the name that is given, if it is not
 * an array of finite numbers. */
std::vector<double> NumbersOf(
  const ::Json::Value& array, const std::string& file, const std::string& name);
}

#endif
