// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// pack: sizes of a mesh in all formats, those of .gtn by part, and the time to write them.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunFileReader.h"
#include "gatunParallel.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
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
  std::vector<std::string> Formats;
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
  std::vector<std::string> files;
  for (const Format& format : GetFormats())
  {
    const auto& chosen = options.Formats;
    if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), format.Name) == chosen.end())
    {
      continue;
    }
    files.push_back(format.GetFile(options.Folder));
    operations.push_back(
      { format.Name, [&grid, &format, file = files.back()] { Write(format, grid, file); } });
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["points"] = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
      json["cells"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      for (std::size_t i = 0; i < operations.size(); ++i)
      {
        Json::Value& file = json["files"][operations[i].Name];
        file["bytes"] = FileSize(files[i]);
        AddList(file, "seconds", operations[i].Seconds);
        if (files[i].ends_with(".gtn"))
        {
          AddParts(file["parts"], files[i]);
        }
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddPack(CLI::App& app)
{
  auto options = std::make_shared<PackOptions>();
  CLI::App* command =
    app.add_subcommand("pack", "Sizes in all formats, and times of writing; leaves the files");
  command->add_option("IN", options->In, "A .vtu or .gtn file")->required();
  command->add_option("FOLDER", options->Folder, "Where the files go")->required();
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(0, 1000));
  command->add_option("--formats", options->Formats, "These formats only")->delimiter(',');
  command->callback([options] { MeasurePacking(*options); });
}
}
