// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume: regular volumes as Hartley coefficients.

#include "gtnVolume.h"

#include "gtnFailure.h"

#include <CLI/CLI.hpp>

namespace gtn
{
//------------------------------------------------------------------------------
void AddVolume(CLI::App& app, Settings& settings)
{
  CLI::App* command = app.add_subcommand("volume",
    "Regular volumes: compress them to Hartley coefficients (.ghv), with a chosen quality, and\n"
    "draw them without going back to voxels.");
  command->footer("gtn volume COMMAND --help tells more, with examples.");
  command->require_subcommand(0, 1); // none is looked at below
  AddVolumePack(*command, settings);
  AddVolumeUnpack(*command, settings);
  AddVolumeInfo(*command, settings);
  AddVolumeRender(*command, settings);
  command->final_callback(
    [command]
    {
      if (command->get_subcommands().empty())
      {
        throw UsageError("a command is missing; see gtn volume --help");
      }
    });
}
}
