// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSettings_h
#define gtnSettings_h

// What all subcommands share.

#include "gtnCommandLine.h"

#include <string>

namespace gtn
{
/** What every subcommand knows. */
struct Settings
{
  bool Quiet = false;
  bool Verbose = false;
  bool ShowProgress = false; ///< set by main once the options are known
  int Threads = 0;           ///< 0: as many as there are processors
  std::string CommandLine;   ///< as a shell would take it
};

/** Adds a subcommand with the options that all have; examples are whole command lines, one a line,
 * for its help. */
CLI::App* AddCommand(CLI::App& app, Settings& settings, const std::string& name,
  const std::string& description, const std::string& examples, bool withThreads = true);
}

#endif
