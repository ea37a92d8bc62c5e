// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnFileOrder_h
#define gtnFileOrder_h

// The order of several files as time steps.

#include <optional>
#include <string>
#include <vector>

namespace gtn
{
/** A file, and the time in it if it has one. */
struct TimedFile
{
  std::string File;
  std::optional<double> Time;
};

/** Orders files by their times; a file that is there twice counts once. Without times, they get 0,
 * 1, 2 and so on, in the order of the numbers in their names if these differ in numbers only, or
 * else as given. A new order by names is said unless quiet. Throws Failure if only some files have
 * times, or several have the same one. */
std::vector<TimedFile> OrderFiles(std::vector<TimedFile> files, bool quiet);
}

#endif
