// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunProcessors_h
#define gatunProcessors_h

// How many processors this process may use: a container or a batch system may give it fewer than
// the machine has.

#include "gatunExport.h" // For export macro

#include <functional>
#include <string>

namespace gatun
{
/** The contents of a file; empty if there is none. */
using FileText = std::function<std::string(const std::string& path)>;

/**
 * The processors that the control groups of a process allow, rounded up and at least 1; 0 if they
 * do not limit them. That is the least of all quotas of its groups and their parents: cpu.max
 * (version 2), cpu.cfs_quota_us by cpu.cfs_period_us (version 1). Read has /proc/self/cgroup and
 * the files of /sys/fs/cgroup. In a container, the name of the group may be that outside of it; the
 * groups that are not there have no quota.
 */
GATUN_EXPORT int GetProcessorQuota(const FileText& read);

/** The number of processors that this process may use: the processors of its affinity, but no more
 * than its quota at the first call. At least 1. */
GATUN_EXPORT int GetNumberOfProcessors();
}

#endif
