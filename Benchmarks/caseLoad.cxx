// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// load, load-files: time from file to vtkUnstructuredGrid. peak: memory of loading or writing.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunParallel.h"

#include "vtkUnstructuredGrid.h"

#include <memory>
#include <utility>
#include <vector>

namespace bench
{
namespace
{

struct LoadOptions
{
  std::string File;
  std::vector<std::string> Files;
  std::string Out;
  int Rounds = 5;
  bool Cold = false;
};

/** Files of one mesh in turns. */
void TimeInTurns(std::vector<Operation> operations, const std::vector<std::string>& files,
  const LoadOptions& options)
{
  vtkIdType tets = 0;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const std::string& file = files[i];
    operations[i].Run = [&tets, &file]
    {
      const vtkIdType loaded = Load(file)->GetNumberOfCells();
      if (tets != 0 && loaded != tets)
      {
        throw Failure(file, "has another number of cells");
      }
      tets = loaded;
    };
    if (options.Cold)
    {
      operations[i].Prepare = [&file] { Evict(file); };
    }
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintTimes(operations, static_cast<std::uint64_t>(tets));
}

void TimeLoading(const LoadOptions& options)
{
  std::vector<Operation> operations;
  std::vector<std::string> files;
  for (const Format& format : GetFormats())
  {
    if (format.IsLoaded)
    {
      operations.push_back({ format.Name, {}, format.IsSlow ? 3 : 1000 });
      files.push_back(format.GetFile(options.File));
    }
  }
  TimeInTurns(std::move(operations), files, options);
}

void TimeFiles(const LoadOptions& options)
{
  std::vector<Operation> operations;
  for (const std::string& file : options.Files)
  {
    operations.push_back({ file, {}, 1000 });
  }
  TimeInTurns(std::move(operations), options.Files, options);
}

void MeasurePeak(const LoadOptions& options)
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
  auto options = std::make_shared<LoadOptions>();
  const auto addOptions = [options](CLI::App* command)
  {
    command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
      ->check(CLI::Range(1, 1000));
    command->add_flag("--cold", options->Cold,
      "Remove each file from the page cache before it is read, so that it comes from the disk");
  };
  CLI::App* folder =
    app.add_subcommand("load", "Time to load the files that the case size has left");
  folder->add_option("FOLDER", options->File, "Where the files are")->required();
  addOptions(folder);
  folder->callback([options] { TimeLoading(*options); });
  CLI::App* files = app.add_subcommand("load-files",
    "Time to load files of one mesh, in turns: with and without layers, or a .vtu file");
  files->add_option("FILES", options->Files, ".gtn and .vtu files")->required();
  addOptions(files);
  files->callback([options] { TimeFiles(*options); });
}

//------------------------------------------------------------------------------
void AddPeak(CLI::App& app)
{
  auto options = std::make_shared<LoadOptions>();
  CLI::App* command = app.add_subcommand(
    "peak", "Most memory in use while a file is loaded, or written with --write");
  command->add_option("FILE", options->File, "A .vtu or .gtn file")->required();
  command->add_option("--write", options->Out, "Load first, and measure writing this .gtn file");
  command->callback([options] { MeasurePeak(*options); });
}
}
