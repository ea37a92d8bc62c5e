// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnFailure_h
#define gtnFailure_h

// How a subcommand ends early.

#include <exception>
#include <stdexcept>
#include <string>

namespace gtn
{
/** The job cannot be done: main prints "gtn: " and what(), and the exit code is 1. */
class Failure : public std::runtime_error
{
public:
  explicit Failure(const std::string& message)
    : std::runtime_error(message)
  {
  }
  Failure(const std::string& file, const std::string& reason);
};

/** The command line makes no sense: as Failure, but the exit code is 2. */
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** Returns the message of an exception; std::bad_alloc has none of its own. */
const char* ReasonOf(const std::exception& error) noexcept;

/** The user pressed Ctrl+C. */
struct Interrupted
{
};
}

#endif
