// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// surface-memory: isosurfaces of a mesh in memory. surface-strips: triangle strips.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchSurface.h"

#include "gatunParallel.h"
#include "vtkGatunContour.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStripper.h"
#include "vtkUnstructuredGrid.h"

#include <memory>

namespace bench
{
namespace
{
struct SurfaceMemoryOptions
{
  std::string File;
  std::string Array;
  std::vector<double> Values;
  int Rounds = 5;
};

void MeasureWays(const SurfaceMemoryOptions& options)
{
  const Grid grid = Load(options.File);
  std::vector<Operation> operations;
  std::vector<std::shared_ptr<SurfaceMaker>> makers;
  std::vector<vtkIdType> triangles(3, 0);
  for (const char* const way : { "memory", "linear", "span" })
  {
    const std::shared_ptr<SurfaceMaker> maker = MakeSurfaceMaker(way, grid, options.Array);
    vtkIdType& count = triangles[makers.size()];
    makers.push_back(maker);
    operations.push_back(
      { way, [&, maker] { count = maker->Make(options.Values)->GetNumberOfPolys(); } });
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      json["ways"] = Json::arrayValue;
      for (std::size_t i = 0; i < operations.size(); ++i)
      {
        Json::Value wayJson;
        wayJson["way"] = operations[i].Name;
        wayJson["triangles"] = static_cast<std::uint64_t>(triangles[i]);
        AddTimes(wayJson, operations[i]);
        json["ways"].append(wayJson);
      }
    });
}

/** How many strips there are, and points that they name. */
void AddStrips(Json::Value& json, const char* name, vtkPolyData* surface, double seconds)
{
  vtkCellArray* const strips = surface->GetStrips();
  json[name]["seconds"] = seconds;
  json[name]["strips"] = static_cast<std::uint64_t>(strips->GetNumberOfCells());
  json[name]["corners"] = static_cast<std::uint64_t>(strips->GetNumberOfConnectivityIds());
  json[name]["loose"] = static_cast<std::uint64_t>(surface->GetNumberOfPolys());
}

void MeasureStrips(const SurfaceMemoryOptions& options)
{
  const auto maker = MakeSurfaceMaker("file", options.File, options.Array);
  vtkSmartPointer<vtkPolyData> triangles;
  const double plain = SecondsOf([&] { triangles = maker->Make(options.Values); });
  maker->GetGatun()->OutputStripsOn();
  vtkSmartPointer<vtkPolyData> strips;
  const double own = SecondsOf([&] { strips = maker->Make(options.Values); });
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(triangles);
  const double vtk = SecondsOf([&] { stripper->Update(); });
  PrintJson(
    [&](Json::Value& json)
    {
      json["triangles"] = static_cast<std::uint64_t>(triangles->GetNumberOfPolys());
      json["seconds"] = plain;
      AddStrips(json, "gatun", strips, own);
      AddStrips(json, "vtkStripper", stripper->GetOutput(), vtk);
    });
}

CLI::App* AddCommand(CLI::App& app, const char* name, const char* description,
  const std::shared_ptr<SurfaceMemoryOptions>& options)
{
  CLI::App* const command = app.add_subcommand(name, description);
  command->add_option("FILE", options->File, "A .vtu or .gtn file")->required();
  command->add_option("--array", options->Array, "Point array")->required();
  command->add_option("--values", options->Values, "Isovalues")->required();
  return command;
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSurfaceMemory(CLI::App& app)
{
  auto options = std::make_shared<SurfaceMemoryOptions>();
  CLI::App* const ways =
    AddCommand(app, "surface-memory", "Time for isosurfaces of a mesh in memory", options);
  ways->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  ways->callback([options] { MeasureWays(*options); });
  CLI::App* const strips =
    AddCommand(app, "surface-strips", "Triangle strips of isosurfaces of a .gtn file", options);
  strips->callback([options] { MeasureStrips(*options); });
}
}
