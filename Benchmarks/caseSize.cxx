// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// size: what a mesh takes as .gtn, by part, and as .vtu. write: how long that takes.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunFileReader.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <memory>

namespace bench
{
namespace
{

struct SizeOptions
{
  std::string In;
  std::string Folder;
  int Rounds = 3;
};

/** Coordinates, 32-bit connectivity and arrays: no file that is not compressed can be smaller. */
std::uint64_t RawBytes(vtkUnstructuredGrid* grid)
{
  std::uint64_t bytes = 16 * static_cast<std::uint64_t>(grid->GetNumberOfCells());
  const auto add = [&](vtkDataArray* array)
  {
    if (array)
    {
      bytes += static_cast<std::uint64_t>(array->GetNumberOfValues() * array->GetDataTypeSize());
    }
  };
  add(grid->GetPoints()->GetData());
  for (vtkDataSetAttributes* arrays : { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
         static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      add(arrays->GetArray(i));
    }
  }
  return bytes;
}

void AddParts(Json::Value& json, const std::string& file)
{
  const gatun::FileReader reader(file);
  const gatun::FileStatistics sizes = reader.GetStatistics();
  json["chunks"] = static_cast<std::uint64_t>(reader.GetChunks().size());
  json["sharedPoints"] = reader.GetNumberOfSharedPoints();
  json["parts"]["file"] = sizes.FileBytes;
  json["parts"]["connectivity"] = sizes.ConnectivityBytes;
  json["parts"]["geometry"] = sizes.GeometryBytes;
  json["parts"]["sharedGeometry"] = sizes.SharedGeometryBytes;
  json["parts"]["order"] = sizes.OrderBytes;
  json["parts"]["fieldData"] = sizes.FieldDataBytes;
  json["parts"]["directory"] = sizes.DirectoryBytes;
  json["arrays"] = Json::arrayValue;
  for (std::size_t i = 0; i < reader.GetArrays().size(); ++i)
  {
    const gatun::ArrayDescription& array = reader.GetArrays()[i];
    Json::Value arrayJson;
    arrayJson["name"] = array.Name;
    arrayJson["of"] = array.Where == gatun::Association::Point ? "points" : "cells";
    arrayJson["components"] = static_cast<std::uint64_t>(array.Components);
    arrayJson["valueBytes"] = static_cast<std::uint64_t>(gatun::SizeOf(array.Type));
    arrayJson["bytes"] = sizes.ArrayBytes[i];
    json["arrays"].append(arrayJson);
  }
}

void Size(const SizeOptions& options)
{
  const Grid grid = Load(options.In);
  PrintJson(
    [&](Json::Value& json)
    {
      json["points"] = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      json["rawBytes"] = RawBytes(grid);
      json["gridBytes"] = 1024 * static_cast<std::uint64_t>(grid->GetActualMemorySize());
      json["files"] = Json::arrayValue;
      for (const Format& format : GetFormats())
      {
        const std::string file = format.GetFile(options.Folder);
        const double seconds = SecondsOf([&] { Write(format, grid, file); });
        Json::Value fileJson;
        fileJson["format"] = format.Name;
        fileJson["bytes"] = FileSize(file);
        fileJson["seconds"] = seconds;
        json["files"].append(fileJson);
      }
      AddParts(json, GetFormats()[0].GetFile(options.Folder));
    });
}

void TimeWriting(const SizeOptions& options)
{
  const Grid grid = Load(options.In);
  std::vector<Operation> operations;
  for (const Format& format : GetFormats())
  {
    if (!format.IsSlow)
    {
      operations.push_back(
        { format.Name, [&] { Write(format, grid, format.GetFile(options.Folder)); } });
    }
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintTimes(operations, static_cast<std::uint64_t>(grid->GetNumberOfCells()));
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddSize(CLI::App& app)
{
  auto options = std::make_shared<SizeOptions>();
  CLI::App* command =
    app.add_subcommand("size", "Sizes as .gtn, part by part, and as .vtu; leaves the files");
  command->add_option("IN", options->In, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("FOLDER", options->Folder, "Where the files go")->required();
  command->callback([options] { Size(*options); });
}

//------------------------------------------------------------------------------
void AddWrite(CLI::App& app)
{
  auto options = std::make_shared<SizeOptions>();
  CLI::App* command = app.add_subcommand("write", "Time to write .gtn and .vtu");
  command->add_option("IN", options->In, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("FOLDER", options->Folder, "Where the files go")->required();
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  command->callback([options] { TimeWriting(*options); });
}
}
