// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnJson_h
#define gtnJson_h

// JSON as text and as files. The values themselves are those of jsoncpp, which keeps the members of
// an object in alphabetical order.

#include "gatunDescription.h"

#include <json/json.h>

#include <string>
#include <vector>

namespace gtn
{
using gatun::MakeJsonArray;
using gatun::WriteJson;
using gatun::WriteJsonLine;

/** Reads a file. Returns false, and sets the reason, if it is not JSON. */
bool ParseJson(const std::string& file, Json::Value& root, std::string& reason);

/** Reads a file. Throws Failure if there is no such file, or if it is not JSON. */
Json::Value ReadJson(const std::string& file);

/** Returns the numbers of an array. Throws Failure for the file, with the given name of the array,
 * if it is not an array of finite numbers. */
std::vector<double> NumbersOf(
  const Json::Value& array, const std::string& file, const std::string& name);
}

#endif
