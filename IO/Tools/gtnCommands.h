// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCommands_h
#define gtnCommands_h

// The subcommands, each in a file of its own.

#include <CLI/CLI.hpp>

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

void AddBench(CLI::App& app, Settings& settings);
void AddContour(CLI::App& app, Settings& settings);
void AddInfo(CLI::App& app, Settings& settings);
void AddMesh(CLI::App& app, Settings& settings);
void AddPack(CLI::App& app, Settings& settings);
void AddRender(CLI::App& app, Settings& settings);
void AddSimplify(CLI::App& app, Settings& settings);
void AddUnpack(CLI::App& app, Settings& settings);
void AddVerify(CLI::App& app, Settings& settings);
void AddVolume(CLI::App& app, Settings& settings);

/** Prints the manual page, in man's language. */
void PrintManual(const CLI::App& app);
}

#endif
