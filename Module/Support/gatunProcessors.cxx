// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunProcessors.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <thread>

#ifdef __linux__
#include <sched.h>
#endif

namespace gatun
{
namespace
{
constexpr double NoQuota = std::numeric_limits<double>::infinity();

/** The number at the start of a text, or none. "max" and "-1" are none. */
double ParsePositive(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  long long number = 0;
  return stream >> number && number > 0 ? static_cast<double>(number) : NoQuota;
}

/** Of the two numbers of cpu.max. */
double ParseQuota(const std::string& text)
{
  const std::size_t space = text.find(' ');
  const double quota = ParsePositive(text.substr(0, space));
  const double period = space == std::string::npos ? NoQuota : ParsePositive(text.substr(space));
  return quota < NoQuota && period < NoQuota ? quota / period : NoQuota;
}

/** The least quota of a group and of those around it, up to the root. */
double FindQuota(const FileText& read, const std::string& root, std::string group)
{
  double least = NoQuota;
  for (;;)
  {
    while (!group.empty() && group.back() == '/')
    {
      group.pop_back();
    }
    const std::string folder = root + group + "/";
    least = std::min(least, ParseQuota(read(folder + "cpu.max")));
    least = std::min(least,
      ParseQuota(read(folder + "cpu.cfs_quota_us") + " " + read(folder + "cpu.cfs_period_us")));
    if (group.empty())
    {
      return least;
    }
    group.erase(group.rfind('/') == std::string::npos ? 0 : group.rfind('/'));
  }
}

std::string ReadFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/** Those that the system schedules this process on. */
int CountScheduled()
{
#ifdef __linux__
  cpu_set_t set;
  CPU_ZERO(&set);
  // It fails on machines with more processors than the set has.
  if (sched_getaffinity(0, sizeof(set), &set) == 0)
  {
    return CPU_COUNT(&set);
  }
#endif
  return static_cast<int>(std::thread::hardware_concurrency());
}
}

//------------------------------------------------------------------------------
int GetProcessorQuota(const FileText& read)
{
  // "4:cpu,cpuacct:/group" (version 1), "0::/group" (version 2)
  std::istringstream groups(read("/proc/self/cgroup"));
  double least = NoQuota;
  for (std::string line; std::getline(groups, line);)
  {
    const std::size_t first = line.find(':');
    const std::size_t second = first == line.npos ? first : line.find(':', first + 1);
    if (second == line.npos)
    {
      continue;
    }
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const std::string group = line.substr(second + 1);
    const std::string root = "/sys/fs/cgroup";
    if (controllers.empty())
    {
      least = std::min(least, FindQuota(read, root, group));
    }
    else if (("," + controllers + ",").find(",cpu,") != std::string::npos)
    {
      least = std::min(least, FindQuota(read, root + "/" + controllers, group));
      // A link to that folder, or the folder itself.
      least = std::min(least, FindQuota(read, root + "/cpu", group));
    }
  }
  constexpr double most = std::numeric_limits<int>::max();
  return least < NoQuota ? static_cast<int>(std::clamp(std::ceil(least), 1., most)) : 0;
}

//------------------------------------------------------------------------------
int GetNumberOfProcessors()
{
  // Parallel loops ask often, and the files of a quota take longer to read than the affinity.
  static const int quota = GetProcessorQuota(ReadFile);
  const int scheduled = std::max(1, CountScheduled());
  return quota > 0 ? std::min(scheduled, quota) : scheduled;
}
}
