// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// contour: time, bytes and memory from a file to an isosurface, by vtkGatunContour from a .gtn file
// and by vtkContour3DLinearGrid from a .vtu file. contour-memory: both with the mesh in memory.
// quantiles: isovalues.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunParallel.h"
#include "vtkGatunContour.h"
#include "vtkGatunReader.h"

#include "vtkContour3DLinearGrid.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
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
struct ContourOptions
{
  std::string File;
  std::string Array = "Density";
  std::vector<double> Values;
  int Rounds = 5;
};

/** Bytes that this process has read so far; 0 where the system does not tell. */
std::uint64_t GetBytesRead()
{
  std::ifstream file("/proc/self/io");
  std::string name;
  std::uint64_t bytes = 0;
  return file >> name >> bytes && name == "rchar:" ? bytes : 0;
}

/** The number of triangles. */
template <typename Filter>
std::uint64_t Extract(Filter* contour, const ContourOptions& options)
{
  contour->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, options.Array.c_str());
  contour->SetNumberOfContours(static_cast<int>(options.Values.size()));
  for (std::size_t i = 0; i < options.Values.size(); ++i)
  {
    contour->SetValue(static_cast<int>(i), options.Values[i]);
  }
  contour->Modified(); // also for the values that it had
  contour->Update();
  auto* const output = vtkPolyData::SafeDownCast(contour->GetOutputDataObject(0));
  if (!output || contour->GetErrorCode() != 0)
  {
    throw Failure("an isosurface cannot be made");
  }
  return static_cast<std::uint64_t>(output->GetNumberOfPolys());
}

std::uint64_t ExtractFromFile(const ContourOptions& options)
{
  if (options.File.ends_with(".gtn"))
  {
    vtkNew<vtkGatunReader> reader;
    reader->SetFileName(options.File.c_str());
    reader->SetMemoryBudget(0);
    vtkNew<vtkGatunContour> contour;
    contour->SetInputConnection(reader->GetOutputPort());
    return Extract(contour.Get(), options);
  }
  vtkNew<vtkContour3DLinearGrid> contour;
  contour->SetInputData(Load(options.File));
  contour->MergePointsOn();
  return Extract(contour.Get(), options);
}

void MeasureFromFile(const ContourOptions& options)
{
  std::uint64_t triangles = 0;
  const std::uint64_t before = GetBytesRead();
  const Cost cost = CostOf([&] { triangles = ExtractFromFile(options); });
  const std::uint64_t bytes = GetBytesRead() - before;
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      AddCost(json, cost);
      json["bytes"] = bytes;
      json["triangles"] = triangles;
    });
}

void MeasureInMemory(const ContourOptions& options)
{
  const Grid grid = Load(options.File);
  vtkNew<vtkGatunContour> own;
  own->SetInputData(grid);
  vtkNew<vtkContour3DLinearGrid> peer;
  peer->SetInputData(grid);
  peer->MergePointsOn();
  std::vector<Operation> operations{ { "gatun", [&] { Extract(own.Get(), options); } },
    { "vtk", [&] { Extract(peer.Get(), options); } } };
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      for (const Operation& operation : operations)
      {
        AddList(json, operation.Name.c_str(), operation.Seconds);
      }
    });
}

/** The values that so large parts of the points' values are not above. */
void PrintQuantiles(const ContourOptions& options)
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
      AddList(json, "values", found);
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddContour(CLI::App& app)
{
  auto options = std::make_shared<ContourOptions>();
  const auto add = [&](const char* name, const char* about, void (*measure)(const ContourOptions&))
  {
    CLI::App* command = app.add_subcommand(name, about);
    command->add_option("FILE", options->File, "A .vtu or .gtn file")->required();
    command->add_option("--array", options->Array, "Point array");
    command->add_option("--values", options->Values, "Isovalues; of quantiles: parts, 0 to 1")
      ->required();
    command->add_option("--rounds", options->Rounds, "Rounds of contour-memory");
    command->callback([options, measure] { measure(*options); });
  };
  add("contour", "Time, bytes and memory from a file to its isosurfaces", MeasureFromFile);
  add("contour-memory", "Time of isosurfaces of a mesh in memory, by both filters in turns",
    MeasureInMemory);
  add("quantiles", "Quantiles of an array", PrintQuantiles);
}
}
