// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnOptions.h"

#include <CLI/CLI.hpp>

namespace gtn
{
//------------------------------------------------------------------------------
CLI::Option* AddForce(CLI::App* command, bool& overwrite)
{
  return command->add_flag(
    "-f,--force", overwrite, "Overwrite OUT if it exists and is not read-only");
}

//------------------------------------------------------------------------------
void AddArrays(CLI::App* command, InputOptions& input, const std::string& description)
{
  command->add_option("--arrays", input.Arrays, description)
    ->each([&input](const std::string&) { input.AllArrays = false; })
    ->delimiter(',')
    ->allow_extra_args(false)
    ->option_text("NAME,...");
}

//------------------------------------------------------------------------------
void AddSkip(CLI::App* command, InputOptions& input, const std::string& description)
{
  command->add_option("--skip", input.Skip, description)
    ->delimiter(',')
    ->allow_extra_args(false)
    ->option_text("NAME,...");
}

//------------------------------------------------------------------------------
void AddNoGhosts(CLI::App* command, InputOptions& input, const std::string& description)
{
  command->add_flag_callback(
    "--no-ghosts", [&input] { input.Ghosts = false; }, description);
}

//------------------------------------------------------------------------------
void AddSkipMissing(CLI::App* command, InputOptions& input)
{
  command->add_flag("--skip-missing", input.SkipMissing,
    "Go on without the files that a .pvtu, .pvtp, .vtm, .vtpc, .pvd or .series file lists and that "
    "do not exist. They are named (default: such a list is refused)");
}

//------------------------------------------------------------------------------
void AddSets(CLI::App* command, InputOptions& input)
{
  command->add_flag("--sets", input.Sets,
    "Also read the side sets and node sets of Exodus files, the patches of OpenFOAM cases and "
    "the boundaries of CGNS files, as blocks of faces, lines and vertices");
}
}
