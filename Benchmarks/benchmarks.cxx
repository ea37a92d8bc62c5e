// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures operations, Gatun's and those of VTK next to them, each a subcommand. runBenchmarks.py
// runs them all and makes a page of what they print.

#include "benchCases.h"

#include "gtnThreads.h"

#include <cstdio>
#include <exception>

int main(int argc, char* argv[])
{
  CLI::App app("Measures Gatun next to VTK's own files and mappers.", "gatunBenchmarks");
  app.require_subcommand(1);
  int threads = 0;
  app.add_option("--threads", threads, "Threads to use (0: one a processor)")
    ->check(CLI::Range(0, 1024));
  app.parse_complete_callback([&] { gtn::SetThreads(threads); });
  bench::AddMachine(app);
  bench::AddMake(app);
  bench::AddPrepare(app);
  bench::AddSize(app);
  bench::AddWrite(app);
  bench::AddLoad(app);
  bench::AddPeak(app);
  bench::AddPieces(app);
  bench::AddRegion(app);
  bench::AddSeries(app);
  bench::AddRender(app);
  bench::AddPicture(app);
  bench::AddBudget(app);
  bench::AddDetail(app);
  bench::AddDetailFilm(app);
  bench::AddDetailFlight(app);
  bench::AddStudyPicture(app);
  bench::AddStudyRelease(app);
  bench::AddStudyPrefilter(app);
  bench::AddSimplify(app);
  bench::AddSimplifyIntegrated(app);
  bench::AddSimplifyPicture(app);
  bench::AddSimplifySurface(app);
  bench::AddSurface(app);
  bench::AddSurfaceDraw(app);
  bench::AddSurfaceCuts(app);
  bench::AddSurfaceFrames(app);
  bench::AddSurfaceMemory(app);
  bench::AddMakeSurface(app);
  bench::AddSurfaceFiles(app);
  bench::AddVolumeBlocks(app);
  bench::AddVolumePictures(app);
  bench::AddVolumeRates(app);
  bench::AddVolumeTimes(app);
  bench::AddVolumeDraw(app);
  bench::AddSizes(app);
  bench::AddThreads(app);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "gatunBenchmarks: %s\n", error.what());
    return 1;
  }
  return 0;
}
