// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures Gatun and, in the same run, its peers; each operation is a subcommand. report.py runs
// them and writes pages of what they print.

#include "benchCases.h"

#include "gtnThreads.h"

#include <exception>

int main(int argc, char* argv[])
{
  CLI::App app("Measures Gatun next to its peers.", "gatunBenchmarks");
  app.require_subcommand(1);
  int threads = 0;
  app.add_option("--threads", threads, "Threads to use (0: one a processor)")
    ->check(CLI::Range(0, 1024));
  app.parse_complete_callback([&] { gtn::SetThreads(threads); });
  for (const auto add : { bench::AddMake, bench::AddSizes, bench::AddPack, bench::AddLoad,
         bench::AddImage, bench::AddContour, bench::AddSimplify, bench::AddVolume,
         bench::AddSurface, bench::AddFigures, bench::AddTables, bench::AddSteps })
  {
    add(app);
  }
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
