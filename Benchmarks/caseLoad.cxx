// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// load: time from file to vtkUnstructuredGrid. peak: memory of loading or writing.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunParallel.h"

#include "vtkUnstructuredGrid.h"

#include <memory>

namespace bench
{
namespace
{

struct Options
{
  std::string File;
  std::string Out;
  int Rounds = 5;
  bool Cold = false;
};

void TimeLoading(const Options& options)
{
  vtkIdType tets = 0;
  std::vector<Operation> operations;
  for (const Format& format : GetFormats())
  {
    if (format.IsLoaded)
    {
      const std::string file = format.GetFile(options.File);
      const auto load = [&tets, file]
      {
        const vtkIdType loaded = Load(file)->GetNumberOfCells();
        if (tets != 0 && loaded != tets)
        {
          throw Failure(file, "has another number of cells");
        }
        tets = loaded;
      };
      operations.push_back({ format.Name, load, format.IsSlow ? 3 : 1000 });
      if (options.Cold)
      {
        operations.back().Prepare = [file] { Evict(file); };
      }
    }
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintTimes(operations, static_cast<std::uint64_t>(tets));
}

void MeasurePeak(const Options& options)
{
  Grid grid;
  if (!options.Out.empty())
  {
    grid = Load(options.File);
  }
  const Cost cost = CostOf(
    [&]
    {
      if (options.Out.empty())
      {
        grid = Load(options.File);
      }
      else
      {
        Write(GetFormats()[0], grid, options.Out);
      }
    });
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      AddCost(json, cost);
      json["gridBytes"] = 1024 * static_cast<std::uint64_t>(grid->GetActualMemorySize());
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddLoad(CLI::App& app)
{
  auto options = std::make_shared<Options>();
  CLI::App* command =
    app.add_subcommand("load", "Time to load the files that the case size has left");
  command->add_option("FOLDER", options->File, "Where the files are")->required();
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  command->add_flag("--cold", options->Cold,
    "Remove each file from the page cache before it is read, so that it comes from the disk");
  command->callback([options] { TimeLoading(*options); });
}

//------------------------------------------------------------------------------
void AddPeak(CLI::App& app)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
    "peak", "Most memory in use while a file is loaded, or written with --write");
  command->add_option("FILE", options->File, "A .vtu or .gtn file")->required();
  command->add_option("--write", options->Out, "Load first, and measure writing this .gtn file");
  command->callback([options] { MeasurePeak(*options); });
}
}
