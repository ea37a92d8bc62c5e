// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// surface: from a file to an isosurface, in a process of its own. surface-repeat: one value after
// the other. surface-values: quantiles of an array.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchSurface.h"

#include "gatunParallel.h"
#include "vtkGatunContour.h"
#include "vtkGatunReader.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <fstream>
#include <memory>

namespace bench
{
namespace
{
struct SurfaceOptions
{
  std::string File;
  std::string Way = "file";
  std::string Array;
  std::vector<double> Values;
  int Cache = 0; ///< MiB
};

std::unique_ptr<SurfaceMaker> Open(const SurfaceOptions& options)
{
  auto maker = MakeSurfaceMaker(options.Way, options.File, options.Array);
  if (maker->GetReader())
  {
    maker->GetReader()->SetMemoryBudget(options.Cache);
  }
  return maker;
}

/** Bytes that this process has read so far; 0 where the system does not tell. */
std::uint64_t GetBytesRead()
{
  std::ifstream file("/proc/self/io");
  std::string name;
  std::uint64_t bytes = 0;
  return file >> name >> bytes && name == "rchar:" ? bytes : 0;
}

void AddSurface(Json::Value& json, vtkPolyData* surface, SurfaceMaker& maker)
{
  json["triangles"] = static_cast<std::uint64_t>(surface->GetNumberOfPolys());
  json["points"] = static_cast<std::uint64_t>(surface->GetNumberOfPoints());
  if (vtkGatunContour* const gatun = maker.GetGatun())
  {
    json["chunks"] = static_cast<std::uint64_t>(gatun->GetNumberOfChunks());
    json["chunksUsed"] = static_cast<std::uint64_t>(gatun->GetNumberOfChunksUsed());
    json["tetsUsed"] = static_cast<std::uint64_t>(gatun->GetNumberOfTetrahedraUsed());
  }
}

void MeasureOne(const SurfaceOptions& options)
{
  std::unique_ptr<SurfaceMaker> maker;
  vtkSmartPointer<vtkPolyData> surface;
  const std::uint64_t before = GetBytesRead();
  const Cost cost = CostOf(
    [&]
    {
      maker = Open(options);
      surface = maker->Make(options.Values);
    });
  const std::uint64_t bytes = GetBytesRead() - before;
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      AddCost(json, cost);
      json["bytes"] = bytes;
      AddSurface(json, surface, *maker);
    });
}

void MeasureRepeated(const SurfaceOptions& options)
{
  std::unique_ptr<SurfaceMaker> maker;
  const double open = SecondsOf([&] { maker = Open(options); });
  std::vector<double> seconds;
  for (const double value : options.Values)
  {
    seconds.push_back(SecondsOf([&] { maker->Make({ value }); }));
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["open"] = open;
      AddList(json, "seconds", seconds);
    });
}

/** The values that so large parts of the points' values are not above. */
void PrintQuantiles(const SurfaceOptions& options)
{
  const Grid grid = Load(options.File);
  vtkDataArray* const array = grid->GetPointData()->GetArray(options.Array.c_str());
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() == 0)
  {
    throw Failure(options.File, "has no such array of one component");
  }
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  }
  std::sort(values.begin(), values.end());
  std::vector<double> found;
  for (const double part : options.Values)
  {
    found.push_back(values[static_cast<std::size_t>(
      std::clamp(part, 0.0, 1.0) * static_cast<double>(values.size() - 1))]);
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      json["points"] = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
      AddList(json, "values", found);
    });
}

CLI::App* AddCommand(CLI::App& app, const char* name, const char* description,
  const std::shared_ptr<SurfaceOptions>& options)
{
  CLI::App* const command = app.add_subcommand(name, description);
  command->add_option("FILE", options->File, "A .vtu or .gtn file")->required();
  command->add_option("--array", options->Array, "Point array")->required();
  return command;
}

void AddWays(CLI::App* command, const std::shared_ptr<SurfaceOptions>& options)
{
  command->add_option("--values", options->Values, "Isovalues")->required();
  command->add_option("--way", options->Way, "How")
    ->check(CLI::IsMember({ "file", "memory", "linear", "span" }));
  command->add_option("--cache", options->Cache, "Memory of decoded chunks, in MiB");
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSurface(CLI::App& app)
{
  auto options = std::make_shared<SurfaceOptions>();
  CLI::App* const one =
    AddCommand(app, "surface", "Time, bytes and memory from a file to its isosurfaces", options);
  AddWays(one, options);
  one->callback([options] { MeasureOne(*options); });
  CLI::App* const repeated = AddCommand(
    app, "surface-repeat", "Time for one isovalue after the other, of a file once opened", options);
  AddWays(repeated, options);
  repeated->callback([options] { MeasureRepeated(*options); });
  CLI::App* const quantiles = AddCommand(app, "surface-values", "Quantiles of an array", options);
  quantiles->add_option("--parts", options->Values, "Parts of the points, 0 to 1")->required();
  quantiles->callback([options] { PrintQuantiles(*options); });
}
}
