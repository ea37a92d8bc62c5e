// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunProcessors.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#ifdef __linux__
#include <sched.h>
#endif

namespace
{
/** The quota with these files and no others. */
int QuotaOf(const std::map<std::string, std::string>& files)
{
  return gatun::GetProcessorQuota(
    [&files](const std::string& path)
    {
      const auto file = files.find(path);
      return file == files.end() ? std::string() : file->second;
    });
}

int QuotaOfGroup(const std::string& text)
{
  return QuotaOf({ { "/proc/self/cgroup", "0::/\n" }, { "/sys/fs/cgroup/cpu.max", text } });
}

TEST(Processors, QuotaOfVersion2)
{
  EXPECT_EQ(QuotaOfGroup("200000 100000\n"), 2);
  EXPECT_EQ(QuotaOfGroup("150000 100000\n"), 2); // rounded up
  EXPECT_EQ(QuotaOfGroup("1000 100000\n"), 1);
  EXPECT_EQ(QuotaOfGroup("max 100000\n"), 0);
  for (const char* const text : { "", "\n", "max", "100000", "0 100000", "100000 0", "-1 100000",
         "100000 x", "x 100000", "99999999999999999999999 100000" })
  {
    EXPECT_EQ(QuotaOfGroup(text), 0) << text;
  }
  EXPECT_GT(QuotaOfGroup("9000000000000000000 1"), 1000000);
}

TEST(Processors, QuotaOfGroupsAround)
{
  std::map<std::string, std::string> files{ { "/proc/self/cgroup", "0::/a/b\n" },
    { "/sys/fs/cgroup/a/b/cpu.max", "400000 100000\n" },
    { "/sys/fs/cgroup/a/cpu.max", "300000 100000\n" },
    { "/sys/fs/cgroup/cpu.max", "max 100000\n" } };
  EXPECT_EQ(QuotaOf(files), 3);
  files["/sys/fs/cgroup/a/b/cpu.max"] = "100000 100000\n";
  EXPECT_EQ(QuotaOf(files), 1);
  // A name from outside of the container, whose groups are not here.
  files["/proc/self/cgroup"] = "0::/../x/y\n";
  EXPECT_EQ(QuotaOf(files), 0);
  files["/sys/fs/cgroup/cpu.max"] = "500000 100000\n";
  EXPECT_EQ(QuotaOf(files), 5);
}

TEST(Processors, QuotaOfVersion1)
{
  std::map<std::string, std::string> files{
    { "/proc/self/cgroup", "5:memory:/m\n4:cpu,cpuacct:/c\n1:name=systemd:/s\n0::/s\n" },
    { "/sys/fs/cgroup/cpu,cpuacct/c/cpu.cfs_quota_us", "250000\n" },
    { "/sys/fs/cgroup/cpu,cpuacct/c/cpu.cfs_period_us", "100000\n" },
    { "/sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "-1\n" },
    { "/sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "100000\n" },
    { "/sys/fs/cgroup/memory/m/cpu.max", "100000 100000\n" }
  };
  EXPECT_EQ(QuotaOf(files), 3);
  files["/sys/fs/cgroup/cpu,cpuacct/c/cpu.cfs_quota_us"] = "-1\n";
  EXPECT_EQ(QuotaOf(files), 0);
  EXPECT_EQ(QuotaOf({ { "/proc/self/cgroup", "4:cpu:/c\n" },
              { "/sys/fs/cgroup/cpu/c/cpu.cfs_quota_us", "50000" },
              { "/sys/fs/cgroup/cpu/c/cpu.cfs_period_us", "100000" } }),
    1);
}

TEST(Processors, NoQuotaWithoutGroups)
{
  EXPECT_EQ(QuotaOf({}), 0);
  for (const char* const text : { "\n", ":", "0:", "0::", "x", "4:cpu", "0::relative\n::\n" })
  {
    EXPECT_EQ(QuotaOf({ { "/proc/self/cgroup", text } }), 0) << text;
  }
}

#ifdef __linux__
TEST(Processors, FollowAffinity)
{
  EXPECT_GE(gatun::GetNumberOfProcessors(), 1);
  cpu_set_t before;
  ASSERT_EQ(sched_getaffinity(0, sizeof(before), &before), 0);
  EXPECT_LE(gatun::GetNumberOfProcessors(), CPU_COUNT(&before));
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int i = 0; i < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++i)
  {
    if (CPU_ISSET(i, &before))
    {
      CPU_SET(i, &one);
    }
  }
  ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
  EXPECT_EQ(gatun::GetNumberOfProcessors(), 1);
  sched_setaffinity(0, sizeof(before), &before);
}
#endif
}
