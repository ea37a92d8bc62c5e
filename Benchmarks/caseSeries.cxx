// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// series: many time steps over one mesh, in one .gtn file and as a .vtu file for each step.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunErrorBound.h"
#include "gatunFileWriter.h"
#include "gatunParallel.h"
#include "gatunPointRounding.h"
#include "vtkGatunReader.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <numeric>
#include <random>

namespace bench
{
namespace
{

struct SeriesOptions
{
  std::string In;
  std::string Folder;
  int Steps = 50;
  int Rounds = 3;
  bool Moving = false;
  double Error = 0; // of arrays, relative; and of points, of the longest side
};

constexpr const char* ArrayName = "Temperature";

/** A warm blob that wanders through the bounds while it grows, and a wave that passes by. */
vtkSmartPointer<vtkFloatArray> MakeValues(vtkUnstructuredGrid* grid, double time)
{
  double bounds[6];
  grid->GetBounds(bounds);
  double size = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    size = std::max(size, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->SetName(ArrayName);
  values->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = (p[axis] - bounds[2 * axis]) / size;
    }
    const double x = p[0] - 0.2 - 0.5 * time;
    const double y = p[1] - 0.4 - 0.1 * time;
    const double z = p[2] - 0.3;
    const double blob = std::exp(-(x * x + y * y + z * z) / (0.02 + 0.05 * time));
    values->SetValue(
      i, static_cast<float>(300 + 500 * blob + 20 * std::sin(9 * p[0] - 4 * p[2] - 6 * time)));
  }
  return values;
}

/** Sets the points at a time: the mesh bends, twists and swells smoothly. */
void MovePoints(vtkPoints* start, const double* bounds, double time, vtkPoints* moved)
{
  const double size =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  for (vtkIdType i = 0; i < start->GetNumberOfPoints(); ++i)
  {
    double p[3];
    start->GetPoint(i, p);
    const double x = (p[0] - bounds[0]) / size;
    const double y = (p[1] - bounds[2]) / size;
    const double z = (p[2] - bounds[4]) / size;
    const double angle = 0.8 * time * z;
    const double scale = size * (1 + 0.1 * std::sin(5 * time) * x * y);
    if (time > 0)
    {
      p[0] = bounds[0] + scale * (x * std::cos(angle) - y * std::sin(angle));
      p[1] = bounds[2] + scale * (x * std::sin(angle) + y * std::cos(angle));
      p[2] = bounds[4] + size * (z + 0.05 * std::sin(6 * x + 4 * time) * time);
    }
    moved->SetPoint(i, p);
  }
}

/** Rounds points, which become those of the grid, as vtkGatunWriter does. */
void RoundTo(double error, vtkUnstructuredGrid* grid, vtkPoints* points)
{
  gatun::PointRounding rounding;
  rounding.Error = error;
  double largest = 0;
  grid->GetPoints()->DeepCopy(points);
  points->DeepCopy(gatun::RoundPoints(grid, rounding, largest)->GetPoints());
}

/** Four ids a tetrahedron, as vtkIdType whatever the grid has. */
std::vector<std::int64_t> GetConnectivity(vtkUnstructuredGrid* grid)
{
  std::vector<std::int64_t> ids;
  ids.reserve(static_cast<std::size_t>(4 * grid->GetNumberOfCells()));
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    grid->GetCellPoints(cell, count, points);
    ids.insert(ids.end(), points, points + 4);
  }
  return ids;
}

struct Series
{
  std::vector<double> Times;
  std::string Gatun;
  std::vector<std::string> Vtu;
  std::uint64_t GatunBytes = 0;
  std::uint64_t GatunMeshBytes = 0; ///< all but the array
  std::uint64_t VtuBytes = 0;
};

Series WriteSeries(const SeriesOptions& options)
{
  auto grid = Grid::New();
  grid->CopyStructure(Load(options.In));
  Series series;
  series.Gatun = options.Folder + "/series.gtn";
  const std::vector<std::int64_t> connectivity = GetConnectivity(grid);
  gatun::MeshInput mesh;
  mesh.Points = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
  mesh.CoordinateType = grid->GetPoints()->GetDataType() == VTK_DOUBLE ? gatun::ScalarType::Float64
                                                                       : gatun::ScalarType::Float32;
  mesh.Coordinates = grid->GetPoints()->GetData()->GetVoidPointer(0);
  mesh.Cells = static_cast<std::uint64_t>(grid->GetNumberOfCells());
  mesh.Connectivity = connectivity.data();
  gatun::ArrayDescription array;
  array.Name = ArrayName;
  gatun::WriterOptions writing;
  writing.PointsMove = options.Moving;
  if (options.Error > 0)
  {
    writing.Errors.push_back(gatun::ParseError("*=rel:" + std::to_string(options.Error), false));
  }
  vtkNew<vtkPoints> start;
  start->DeepCopy(grid->GetPoints());
  double bounds[6];
  start->GetBounds(bounds);
  vtkNew<vtkPoints> moved;
  moved->DeepCopy(start);
  const double error = options.Error *
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  const auto moveTo = [&](double time)
  {
    MovePoints(start, bounds, time, moved);
    RoundTo(error, grid, moved);
  };
  if (options.Moving)
  {
    moveTo(0);
    start->DeepCopy(moved);
    mesh.Coordinates = start->GetData()->GetVoidPointer(0);
  }
  gatun::FileWriter writer(series.Gatun, mesh, { array }, writing);

  std::ofstream collection(options.Folder + "/series.pvd");
  collection << "<VTKFile type=\"Collection\"><Collection>\n";
  const Format zlib{ "vtu-zlib", false, false };
  for (int step = 0; step < options.Steps; ++step)
  {
    const double time = static_cast<double>(step) / options.Steps;
    const auto values = MakeValues(grid, time);
    const void* pointers[] = { values->GetPointer(0) };
    if (options.Moving)
    {
      moveTo(time);
      grid->GetPoints()->DeepCopy(moved);
    }
    writer.WriteStep(
      pointers, {}, true, time, {}, options.Moving ? moved->GetData()->GetVoidPointer(0) : nullptr);
    if (options.Moving && options.Error > 0)
    {
      MovePoints(start, bounds, time, grid->GetPoints()); // .vtu files have exact values
    }
    grid->GetPointData()->AddArray(values);
    const std::string name = "step" + std::to_string(step) + ".vtu";
    collection << "<DataSet timestep=\"" << time << "\" file=\"" << name << "\"/>\n";
    Write(zlib, grid, options.Folder + "/" + name);
    series.Times.push_back(time);
    series.Vtu.push_back(options.Folder + "/" + name);
    series.VtuBytes += FileSize(series.Vtu.back());
  }
  collection << "</Collection></VTKFile>\n";
  collection.close();
  series.VtuBytes += FileSize(options.Folder + "/series.pvd");
  const gatun::FileStatistics sizes = writer.Finish();
  series.GatunBytes = sizes.FileBytes;
  series.GatunMeshBytes = sizes.FileBytes - sizes.ArrayBytes[0];
  return series;
}

void Check(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfCells() == 0 || !grid->GetPointData()->GetArray(ArrayName))
  {
    throw Failure("a step of the series cannot be read");
  }
}

void StepThroughGatun(const Series& series, const std::vector<std::size_t>& order)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(series.Gatun.c_str());
  reader->UpdateInformation();
  for (const std::size_t step : order)
  {
    reader->UpdateTimeStep(series.Times[step]);
    Check(reader->GetOutput());
  }
}

void StepThroughVtu(const Series& series, const std::vector<std::size_t>& order)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  for (const std::size_t step : order)
  {
    reader->SetFileName(series.Vtu[step].c_str());
    reader->Update();
    Check(reader->GetOutput());
  }
}

void TimeSeries(const SeriesOptions& options)
{
  const Series series = WriteSeries(options);
  std::vector<std::size_t> forward(series.Times.size());
  std::iota(forward.begin(), forward.end(), std::size_t{ 0 });
  std::vector<std::size_t> random = forward;
  std::mt19937_64 engine(3);
  for (std::size_t i = random.size(); i > 1; --i)
  {
    std::swap(random[i - 1], random[engine() % i]);
  }
  const std::vector<std::size_t> first{ 0 };
  std::vector<Operation> operations{
    { "gtn first", [&] { StepThroughGatun(series, first); } },
    { "vtu-zlib first", [&] { StepThroughVtu(series, first); } },
    { "gtn forward", [&] { StepThroughGatun(series, forward); } },
    { "vtu-zlib forward", [&] { StepThroughVtu(series, forward); } },
    { "gtn at random", [&] { StepThroughGatun(series, random); } },
    { "vtu-zlib at random", [&] { StepThroughVtu(series, random); } },
  };
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["steps"] = options.Steps;
      json["tets"] = static_cast<std::uint64_t>(Load(series.Vtu[0])->GetNumberOfCells());
      json["gtnBytes"] = series.GatunBytes;
      json["gtnMeshBytes"] = series.GatunMeshBytes;
      json["vtuBytes"] = series.VtuBytes;
      json["cases"] = Json::arrayValue;
      for (const Operation& operation : operations)
      {
        Json::Value caseJson;
        caseJson["case"] = operation.Name;
        AddTimes(caseJson, operation);
        json["cases"].append(caseJson);
      }
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddSeries(CLI::App& app)
{
  auto options = std::make_shared<SeriesOptions>();
  CLI::App* command = app.add_subcommand(
    "series", "Bytes of a time series over one mesh, and time to step through it");
  command->add_option("IN", options->In, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("FOLDER", options->Folder, "Where the files go")->required();
  command->add_option("--steps", options->Steps)->check(CLI::Range(1, 100000));
  command->add_flag("--moving", options->Moving, "The points move, too");
  command->add_option("--error", options->Error,
    "Of the array, relative to its range, and of points, relative to the longest side");
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  command->callback([options] { TimeSeries(*options); });
}
}
