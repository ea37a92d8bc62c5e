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

struct Options
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

void AddParts(gtn::Json& json, const std::string& file)
{
  const gatun::FileReader reader(file);
  const gatun::FileStatistics sizes = reader.GetStatistics();
  json.Add("chunks", static_cast<std::uint64_t>(reader.GetChunks().size()));
  json.Add("sharedPoints", reader.GetNumberOfSharedPoints());
  json.BeginObject("parts");
  json.Add("file", sizes.FileBytes);
  json.Add("connectivity", sizes.ConnectivityBytes);
  json.Add("geometry", sizes.GeometryBytes);
  json.Add("sharedGeometry", sizes.SharedGeometryBytes);
  json.Add("order", sizes.OrderBytes);
  json.Add("fieldData", sizes.FieldDataBytes);
  json.Add("directory", sizes.DirectoryBytes);
  json.EndObject();
  json.BeginArray("arrays");
  for (std::size_t i = 0; i < reader.GetArrays().size(); ++i)
  {
    const gatun::ArrayDescription& array = reader.GetArrays()[i];
    json.BeginObject();
    json.Add("name", array.Name);
    json.Add("of", array.Where == gatun::Association::Point ? "points" : "cells");
    json.Add("components", static_cast<std::uint64_t>(array.Components));
    json.Add("valueBytes", static_cast<std::uint64_t>(gatun::SizeOf(array.Type)));
    json.Add("bytes", sizes.ArrayBytes[i]);
    json.EndObject();
  }
  json.EndArray();
}

void Size(const Options& options)
{
  const Grid grid = Load(options.In);
  PrintJson(
    [&](gtn::Json& json)
    {
      json.Add("points", static_cast<std::uint64_t>(grid->GetNumberOfPoints()));
      json.Add("tets", static_cast<std::uint64_t>(grid->GetNumberOfCells()));
      json.Add("rawBytes", RawBytes(grid));
      json.Add("gridBytes", 1024 * static_cast<std::uint64_t>(grid->GetActualMemorySize()));
      json.BeginArray("files");
      for (const Format& format : GetFormats())
      {
        const std::string file = format.GetFile(options.Folder);
        const double seconds = SecondsOf([&] { Write(format, grid, file); });
        json.BeginObject();
        json.Add("format", format.Name);
        json.Add("bytes", FileSize(file));
        json.Add("seconds", seconds);
        json.EndObject();
      }
      json.EndArray();
      AddParts(json, GetFormats()[0].GetFile(options.Folder));
    });
}

void TimeWriting(const Options& options)
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
  auto options = std::make_shared<Options>();
  CLI::App* command =
    app.add_subcommand("size", "Sizes as .gtn, part by part, and as .vtu; leaves the files");
  command->add_option("IN", options->In, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("FOLDER", options->Folder, "Where the files go")->required();
  command->callback([options] { Size(*options); });
}

//------------------------------------------------------------------------------
void AddWrite(CLI::App& app)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("write", "Time to write .gtn and .vtu");
  command->add_option("IN", options->In, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("FOLDER", options->Folder, "Where the files go")->required();
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  command->callback([options] { TimeWriting(*options); });
}
}
