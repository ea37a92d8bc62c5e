// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// load: time, memory and mispredicted branches from a file to vtkUnstructuredGrid.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunParallel.h"

#include "vtkUnstructuredGrid.h"

#include <memory>

namespace bench
{
namespace
{
struct LoadOptions
{
  std::vector<std::string> Files;
  int Rounds = 5;
};

void MeasureLoading(const LoadOptions& options)
{
  vtkIdType cells = 0;
  std::uint64_t gridBytes = 0;
  std::vector<Operation> operations;
  for (const std::string& file : options.Files)
  {
    operations.push_back({ file,
      [&]
      {
        const Grid grid = Load(file);
        if (cells != 0 && grid->GetNumberOfCells() != cells)
        {
          throw Failure(file, "has another number of cells");
        }
        cells = grid->GetNumberOfCells();
        gridBytes = 1024 * static_cast<std::uint64_t>(grid->GetActualMemorySize());
      } });
  }
  const Cost first = CostOf(operations[0].Run);
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["cells"] = static_cast<std::uint64_t>(cells);
      json["gridBytes"] = gridBytes;
      AddCost(json["first"], first);
      json["seconds"] = Json::arrayValue;
      for (const Operation& operation : operations)
      {
        json["seconds"].append(gtn::MakeJsonArray(operation.Seconds));
        const auto misses = CountBranchMisses(operation.Run);
        json["branchMisses"].append(misses
            ? Json::Value(static_cast<double>(*misses) / static_cast<double>(cells))
            : Json::Value());
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddLoad(CLI::App& app)
{
  auto options = std::make_shared<LoadOptions>();
  CLI::App* command = app.add_subcommand("load",
    "Time to load files of one mesh, in turns, mispredicted branches a cell of the calling thread, "
    "and the peak memory of the first file");
  command->add_option("FILES", options->Files, ".gtn, .vtu and .zst files")->required();
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(0, 1000));
  command->callback([options] { MeasureLoading(*options); });
}
}
