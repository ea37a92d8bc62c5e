// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCommands_h
#define gtnCommands_h

// The subcommands, each in a file of its own.

#include "gtnCommandLine.h"
#include "gtnSettings.h"

#include <string>

namespace gtn
{
void AddContour(CLI::App& app, Settings& settings);
void AddInfo(CLI::App& app, Settings& settings);
void AddMesh(CLI::App& app, Settings& settings);
void AddPack(CLI::App& app, Settings& settings);
void AddRender(CLI::App& app, Settings& settings);
void AddSimplify(CLI::App& app, Settings& settings);
void AddUnpack(CLI::App& app, Settings& settings);
void AddVerify(CLI::App& app, Settings& settings);
void AddVolume(CLI::App& app, Settings& settings);

/** Writes the manual pages into a folder: gtn.1, gtn-pack.1 and so on. */
void WriteManual(const CLI::App& app, const std::string& folder);

/** Prints the completion of command lines for a shell, bash or zsh. */
void PrintCompletion(const CLI::App& app, const std::string& shell);
}

#endif
