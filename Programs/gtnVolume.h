// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnVolume_h
#define gtnVolume_h

// The subcommands of gtn volume, each in a file of its own.

#include "gtnCommands.h"

namespace gtn
{
void AddVolumeInfo(CLI::App& app, Settings& settings);
void AddVolumePack(CLI::App& app, Settings& settings);
void AddVolumeRender(CLI::App& app, Settings& settings);
void AddVolumeUnpack(CLI::App& app, Settings& settings);
}

#endif
