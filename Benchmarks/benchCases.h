// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchCases_h
#define benchCases_h

// The subcommands of gatunBenchmarks. Each prints one JSON object on the standard output, unless
// its help says otherwise.

#include <CLI/CLI.hpp>

namespace bench
{
void AddMake(CLI::App& app);
void AddPrepare(CLI::App& app);
void AddMachine(CLI::App& app);
void AddSize(CLI::App& app);
void AddSizes(CLI::App& app);
void AddThreads(CLI::App& app);
void AddWrite(CLI::App& app);
void AddLoad(CLI::App& app);
void AddPeak(CLI::App& app);
void AddPieces(CLI::App& app);
void AddRegion(CLI::App& app);
void AddSeries(CLI::App& app);
void AddRender(CLI::App& app);
void AddPicture(CLI::App& app);
void AddBudget(CLI::App& app);
void AddDetail(CLI::App& app);
void AddDetailFilm(CLI::App& app);
void AddDetailFlight(CLI::App& app);
void AddStudyPicture(CLI::App& app);
void AddStudyRelease(CLI::App& app);
void AddStudyPrefilter(CLI::App& app);
void AddSimplify(CLI::App& app);
void AddSimplifyIntegrated(CLI::App& app);
void AddSimplifyPicture(CLI::App& app);
void AddSimplifySurface(CLI::App& app);
void AddSurface(CLI::App& app);
void AddSurfaceDraw(CLI::App& app);
void AddSurfaceCuts(CLI::App& app);
void AddSurfaceFrames(CLI::App& app);
void AddSurfaceMemory(CLI::App& app);
void AddMakeSurface(CLI::App& app);
void AddSurfaceFiles(CLI::App& app);
void AddVolumeBlocks(CLI::App& app);
void AddVolumePictures(CLI::App& app);
void AddVolumeRates(CLI::App& app);
void AddVolumeTimes(CLI::App& app);
void AddVolumeDraw(CLI::App& app);

/** Prints the JSON object that fill makes. */
template <typename Fill>
void PrintJson(Fill&& fill);
}

#include "benchHarness.h"

#include <cstdio>

namespace bench
{
template <typename Fill>
void PrintJson(Fill&& fill)
{
  Json::Value json(Json::objectValue);
  fill(json);
  std::fputs(gtn::JsonText(json).c_str(), stdout);
}
}

#endif
