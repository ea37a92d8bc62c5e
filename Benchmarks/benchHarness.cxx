// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchHarness.h"

#include <chrono>
#include <filesystem>
#include <fstream>

namespace bench
{
namespace
{
/** A line of /proc/self/status, such as VmRSS, in bytes; 0 where there is none. */
std::uint64_t ReadStatus(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.starts_with(name + ":"))
    {
      return 1024 * std::stoull(line.substr(name.size() + 1));
    }
  }
  return 0;
}
}

//------------------------------------------------------------------------------
double SecondsOf(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//------------------------------------------------------------------------------
void RunInterleaved(std::vector<Operation>& operations, int rounds)
{
  for (int round = 0; round < rounds; ++round)
  {
    for (std::size_t i = 0; i < operations.size(); ++i)
    {
      Operation& operation = operations[round % 2 == 0 ? i : operations.size() - 1 - i];
      if (round < operation.MostRounds)
      {
        operation.Seconds.push_back(SecondsOf(operation.Run));
      }
    }
  }
}

//------------------------------------------------------------------------------
void WarmUpAndRunInterleaved(std::vector<Operation>& operations, int rounds)
{
  for (Operation& operation : operations)
  {
    operation.First = SecondsOf(operation.Run);
  }
  RunInterleaved(operations, rounds);
}

//------------------------------------------------------------------------------
void AddList(Json::Value& json, const char* name, const std::vector<double>& values)
{
  json[name] = gtn::MakeJsonArray(values);
}

//------------------------------------------------------------------------------
Cost CostOf(const std::function<void()>& work)
{
  // Linux lets a process forget its peak.
  std::ofstream("/proc/self/clear_refs") << 5;
  const std::uint64_t before = ReadStatus("VmRSS");
  const double seconds = SecondsOf(work);
  return { seconds, before, ReadStatus("VmHWM") };
}

//------------------------------------------------------------------------------
void AddCost(Json::Value& json, const Cost& cost)
{
  json["seconds"] = cost.Seconds;
  json["before"] = cost.Before;
  json["peak"] = cost.Peak;
}

//------------------------------------------------------------------------------
std::uint64_t FileSize(const std::string& file)
{
  return std::filesystem::file_size(file);
}
}
