// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChildProcess_h
#define gatunChildProcess_h

// Runs a program that may crash, print or never return.

#include <functional>
#include <string>
#include <vector>

namespace gatun
{
enum class ChildOutcome
{
  Done,
  Crashed, ///< or ended with any other exit code
  OutOfMemory,
  Stopped ///< because keepGoing returned false
};

using Bytes = std::vector<unsigned char>;

/**
 * Starts a program, sends it the input through a socket as its standard input, and returns its
 * answer from there. The process gets none of the other open files of this one, and no code of this
 * one runs in it. While it runs, keepGoing is called about ten times a second; the process is
 * killed when keepGoing returns false. If quiet is set, its messages are discarded. Throws
 * std::system_error if the program cannot be started, and std::bad_alloc.
 */
ChildOutcome RunProgram(const std::string& program, const Bytes& input,
  const std::function<bool()>& keepGoing, bool quiet, Bytes& result);

/** The absolute path of a program in the folder "gatun" next to this library, or, if this is a
 * static library of a program, next to the libraries that are installed with the program. Throws
 * std::system_error. */
std::string FindProgram(const char* name);
}

#endif
