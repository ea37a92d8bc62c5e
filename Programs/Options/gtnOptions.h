// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnOptions_h
#define gtnOptions_h

// Options that several subcommands have.

#include "gtnCommandLine.h"
#include "gtnInput.h"

#include <string>

namespace gtn
{
/** -f: whether OUT may be replaced. */
CLI::Option* AddForce(CLI::App* command, bool& overwrite);

/** --arrays: which arrays of the input are wanted. */
void AddArrays(CLI::App* command, InputOptions& input,
  const std::string& description = "Only these point and cell arrays (default: all)");

/** --skip: which arrays of the input are not wanted. */
void AddSkip(CLI::App* command, InputOptions& input, const std::string& description);

/** --no-ghosts: whether ghost cells are not wanted. */
void AddNoGhosts(CLI::App* command, InputOptions& input, const std::string& description);

/** --skip-missing: whether files that a list names may be missing. */
void AddSkipMissing(CLI::App* command, InputOptions& input);

/** --sets: whether the side sets and node sets of an Exodus file are wanted. */
void AddSets(CLI::App* command, InputOptions& input);
}

#endif
