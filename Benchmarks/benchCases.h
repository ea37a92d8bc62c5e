// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchCases_h
#define benchCases_h

// The subcommands of gatunBenchmarks. Each prints one JSON object on the standard output, unless
// its help says otherwise.

#include "benchHarness.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace bench
{
void AddMake(CLI::App& app);
void AddSizes(CLI::App& app);
void AddPack(CLI::App& app);
void AddLoad(CLI::App& app);
void AddImage(CLI::App& app);
void AddContour(CLI::App& app);
void AddSimplify(CLI::App& app);
void AddVolume(CLI::App& app);
void AddSurface(CLI::App& app);
void AddFigures(CLI::App& app);
void AddTables(CLI::App& app);
void AddSteps(CLI::App& app);

/** Prints the JSON object that fill makes. */
template <typename Fill>
void PrintJson(Fill&& fill)
{
  Json::Value json(Json::objectValue);
  fill(json);
  std::fputs(gtn::WriteJson(json).c_str(), stdout);
}
}

#endif
