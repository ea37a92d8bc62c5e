// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// pack: sizes of a mesh as .gtn, by part, and as .vtu, and the time to write them.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunFileReader.h"
#include "gatunParallel.h"

#include "vtkUnstructuredGrid.h"

#include <memory>
#include <numeric>

namespace bench
{
namespace
{
struct PackOptions
{
  std::string In;
  std::string Folder;
  int Rounds = 3;
};

void AddParts(Json::Value& json, const std::string& file)
{
  const gatun::FileStatistics sizes = gatun::FileReader(file).GetStatistics();
  json["connectivity"] = sizes.ConnectivityBytes;
  json["geometry"] = sizes.GeometryBytes + sizes.SharedGeometryBytes;
  json["arrays"] =
    std::accumulate(sizes.ArrayBytes.begin(), sizes.ArrayBytes.end(), std::uint64_t{ 0 });
}

void MeasurePacking(const PackOptions& options)
{
  const Grid grid = Load(options.In);
  std::vector<Operation> operations;
  for (const Format& format : GetFormats())
  {
    const auto write = [&] { Write(format, grid, format.GetFile(options.Folder)); };
    operations.push_back({ format.Name, write, format.IsSlow ? 0 : options.Rounds });
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["points"] = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      for (std::size_t i = 0; i < operations.size(); ++i)
      {
        Json::Value& file = json["files"][operations[i].Name];
        file["bytes"] = FileSize(GetFormats()[i].GetFile(options.Folder));
        AddList(file, "seconds", operations[i].Seconds);
      }
      AddParts(json["parts"], GetFormats()[0].GetFile(options.Folder));
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddPack(CLI::App& app)
{
  auto options = std::make_shared<PackOptions>();
  CLI::App* command =
    app.add_subcommand("pack", "Sizes as .gtn and as .vtu, and times of writing; leaves the files");
  command->add_option("IN", options->In, "A .vtu or .gtn file")->required();
  command->add_option("FOLDER", options->Folder, "Where the files go")->required();
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  command->callback([options] { MeasurePacking(*options); });
}
}
