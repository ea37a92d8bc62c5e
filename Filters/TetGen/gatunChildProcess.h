// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChildProcess_h
#define gatunChildProcess_h

// Runs code that may crash, print or never return in a child process.

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
 * Calls work in a forked child process and returns the bytes that it stored in its argument. All
 * other side effects of work are lost. Work must not use threads. While it runs, keepGoing is
 * called about ten times a second; the child is killed when keepGoing returns false. If quiet is
 * set, the output of the child is discarded. On systems without fork(), work is called directly and
 * its exceptions propagate. Throws std::bad_alloc.
 */
ChildOutcome RunInChild(const std::function<void(Bytes&)>& work,
  const std::function<bool()>& keepGoing, bool quiet, Bytes& result);
}

#endif
