// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchHarness.h"

#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
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
        operation.Prepare();
        const std::clock_t before = std::clock();
        operation.Seconds.push_back(SecondsOf(operation.Run));
        operation.CpuSeconds.push_back(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
      }
    }
  }
}

//------------------------------------------------------------------------------
void WarmUpAndRunInterleaved(std::vector<Operation>& operations, int rounds)
{
  for (Operation& operation : operations)
  {
    operation.Prepare();
    operation.First = SecondsOf(operation.Run);
  }
  RunInterleaved(operations, rounds);
}

//------------------------------------------------------------------------------
void AddTimes(Json::Value& json, const Operation& operation)
{
  json["first"] = operation.First;
  AddList(json, "seconds", operation.Seconds);
  AddList(json, "cpuSeconds", operation.CpuSeconds);
}

//------------------------------------------------------------------------------
void AddList(Json::Value& json, const char* name, const std::vector<double>& values)
{
  json[name] = gtn::JsonArray(values);
}

//------------------------------------------------------------------------------
PeakMemory::PeakMemory()
{
  // Linux lets a process forget its peak.
  std::ofstream("/proc/self/clear_refs") << 5;
  this->Before = ReadStatus("VmRSS");
}

//------------------------------------------------------------------------------
std::uint64_t PeakMemory::GetPeak()
{
  return ReadStatus("VmHWM");
}

//------------------------------------------------------------------------------
Cost CostOf(const std::function<void()>& work)
{
  const PeakMemory memory;
  const double seconds = SecondsOf(work);
  return { seconds, memory.GetBefore(), PeakMemory::GetPeak() };
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

//------------------------------------------------------------------------------
void Evict(const std::string& file)
{
#if defined(POSIX_FADV_DONTNEED)
  const int handle = ::open(file.c_str(), O_RDONLY);
  // Pages that have not been written to the disk cannot be removed.
  const bool done =
    handle >= 0 && ::fsync(handle) == 0 && ::posix_fadvise(handle, 0, 0, POSIX_FADV_DONTNEED) == 0;
  if (handle >= 0)
  {
    ::close(handle);
  }
  if (!done)
  {
    throw Failure(file, "cannot be removed from the page cache");
  }
#else
  throw Failure(file, "cannot be removed from the page cache on this system");
#endif
}
}
