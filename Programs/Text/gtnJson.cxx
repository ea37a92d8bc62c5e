// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnJson.h"

#include "gtnFailure.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string_view>

namespace gtn
{
namespace
{

// "* Line 1, Column 5\n  Missing '}'\n..." becomes "line 1, column 5: Missing '}'".
std::string FirstOf(const std::string& errors)
{
  constexpr std::string_view start = "* Line ";
  const std::size_t lineEnd = errors.find('\n');
  if (!errors.starts_with(start) || lineEnd == errors.npos)
  {
    return MakePrintableLine(errors);
  }
  std::string place = "line " + errors.substr(start.size(), lineEnd - start.size());
  if (const std::size_t column = place.find("Column"); column != place.npos)
  {
    place[column] = 'c';
  }
  const std::size_t from = errors.find_first_not_of(" \n", lineEnd);
  const std::size_t to = std::min(errors.find('\n', from), errors.size());
  return from == errors.npos ? MakePrintableLine(place)
                             : MakePrintableLine(place + ": " +
                                 errors.substr(from, to - from - (errors[to - 1] == '.' ? 1 : 0)));
}

} // anonymous namespace

//------------------------------------------------------------------------------
bool ParseJson(const std::string& file, Json::Value& root, std::string& reason)
{
  try
  {
    std::ifstream stream(file, std::ios::binary);
    std::string errors;
    if (Json::parseFromStream(Json::CharReaderBuilder(), stream, &root, &errors))
    {
      return true;
    }
    reason = FirstOf(errors);
  }
  catch (const Json::Exception& error)
  {
    // Such as too many brackets.
    reason = MakePrintableLine(error.what());
  }
  return false;
}

//------------------------------------------------------------------------------
Json::Value ReadJson(const std::string& file)
{
  CheckReadable(file);
  Json::Value root;
  std::string reason;
  if (!ParseJson(file, root, reason))
  {
    throw Failure(file, "is not JSON: " + reason);
  }
  return root;
}

//------------------------------------------------------------------------------
std::vector<double> NumbersOf(
  const Json::Value& array, const std::string& file, const std::string& name)
{
  bool good = array.isArray();
  std::vector<double> numbers;
  for (Json::ArrayIndex i = 0; good && i < array.size(); ++i)
  {
    good = array[i].isNumeric() && std::isfinite(array[i].asDouble());
    if (good)
    {
      numbers.push_back(array[i].asDouble());
    }
  }
  if (!good)
  {
    throw Failure(file, name + " is not a list of finite numbers");
  }
  return numbers;
}
}
