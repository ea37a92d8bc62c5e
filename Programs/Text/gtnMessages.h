// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnMessages_h
#define gtnMessages_h

// Where VTK's errors and warnings go: nowhere by themselves.

#include <string>
#include <string_view>
#include <vector>

namespace gtn
{
/** Makes VTK keep its messages for the functions below, for as long as the program runs. */
void CatchMessages();

/** Takes what was said since the last call, each message on one line and without VTK's preamble. */
std::vector<std::string> TakeErrors();
std::vector<std::string> TakeWarnings();

/** Throws Failure for the file if VTK reported an error; prints its warnings unless quiet. */
void CheckMessages(const std::string& file, bool quiet);

/** Prints a warning about a file, unless it has been printed before or quiet is set. */
void SayOnce(const std::string& file, const std::string& warning, bool quiet);

/** Prints "gtn: " and a message on stderr; where that is closed, nothing. */
void Say(std::string_view message) noexcept;
}

#endif
