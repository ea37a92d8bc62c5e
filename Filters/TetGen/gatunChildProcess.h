// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChildProcess_h
#define gatunChildProcess_h

// Runs code that may crash, print or never end in a process of its own.

#include <functional>
#include <vector>

namespace gatun
{
enum class ChildOutcome
{
  Done,
  Crashed,
  OutOfMemory,
  Stopped ///< because keepGoing returned false
};

using Bytes = std::vector<unsigned char>;

/**
 * Calls work in a copy of this process and hands back what it put into its argument. What work
 * changes elsewhere is lost with the copy, and work must not use threads. While it runs, keepGoing
 * is called about ten times a second, and ends it by returning false. What the copy prints is
 * thrown away if quiet. Where the system cannot copy processes, work is called directly, and its
 * exceptions pass. Throws std::bad_alloc.
 */
ChildOutcome RunInChild(const std::function<void(Bytes&)>& work,
  const std::function<bool()>& keepGoing, bool quiet, Bytes& result);
}

#endif
