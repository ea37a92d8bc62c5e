// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnRenderStatistics.h"

#include "gtnText.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace gtn
{
namespace
{

// Returns the number after a name in a file of the system, or NaN if there is none.
double ReadNumber(const char* file, std::string_view name)
{
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
  {
    if (line.starts_with(name))
    {
      return std::strtod(line.c_str() + name.size(), nullptr);
    }
  }
  return std::nan("");
}

std::string Text(const Statistic& statistic)
{
  if (!std::isfinite(statistic.Value))
  {
    return "unknown";
  }
  const auto whole = static_cast<std::uint64_t>(statistic.Value);
  return statistic.Kind == Statistic::Seconds ? fmt::format("{:.3f} s", statistic.Value)
    : statistic.Kind == Statistic::Count      ? GroupDigits(whole)
                                              : DescribeByteSize(whole);
}

} // anonymous namespace

//------------------------------------------------------------------------------
double CountBytesRead()
{
  return ReadNumber("/proc/self/io", "rchar:");
}

//------------------------------------------------------------------------------
double GetPeakMemory()
{
  return 1024 * ReadNumber("/proc/self/status", "VmHWM:");
}

//------------------------------------------------------------------------------
void PrintTable(const Statistics& statistics)
{
  for (const Statistic& one : statistics)
  {
    fmt::print("  {:<28} {:>14}\n", one.Title, Text(one));
  }
}

//------------------------------------------------------------------------------
Json::Value JsonOf(const Statistics& statistics)
{
  Json::Value json(Json::objectValue);
  for (const Statistic& one : statistics)
  {
    const bool isReal = one.Kind == Statistic::Seconds || !std::isfinite(one.Value);
    json[one.Name] =
      isReal ? Json::Value(one.Value) : Json::Value(static_cast<Json::UInt64>(one.Value));
  }
  return json;
}
}
