// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchHarness.h"

#include <chrono>
#include <filesystem>
#include <fstream>

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

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
std::optional<std::uint64_t> CountBranchMisses(const std::function<void()>& work)
{
#ifdef __linux__
  perf_event_attr what{};
  what.size = sizeof(what);
  what.type = PERF_TYPE_HARDWARE;
  what.config = PERF_COUNT_HW_BRANCH_MISSES;
  what.exclude_kernel = 1;
  what.exclude_hv = 1;
  const auto counter = static_cast<int>(syscall(SYS_perf_event_open, &what, 0, -1, -1, 0UL));
  if (counter >= 0)
  {
    std::uint64_t before = 0;
    std::uint64_t after = 0;
    bool known = read(counter, &before, sizeof(before)) == sizeof(before);
    work();
    known = known && read(counter, &after, sizeof(after)) == sizeof(after);
    close(counter);
    return known ? std::optional(after - before) : std::nullopt;
  }
#endif
  work();
  return std::nullopt;
}

//------------------------------------------------------------------------------
std::uint64_t FileSize(const std::string& file)
{
  return std::filesystem::file_size(file);
}
}
