// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// simplify: a mesh is simplified by vtkUnstructuredGridQuadricDecimation and by vtkGatunSimplify to
// the same number of tetrahedra; the time of both, and the error of the field.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunParallel.h"
#include "vtkGatunSimplify.h"

#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridQuadricDecimation.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>

namespace bench
{
namespace
{
struct SimplifyOptions
{
  std::string File;
  std::string Array = "Density";
  std::vector<double> Parts{ 0.5, 0.1 };
  std::size_t Samples = 200000;
};

struct FieldSample
{
  std::array<double, 3> Place{};
  double Value = 0;
};

std::uint64_t CountCells(vtkUnstructuredGrid* grid)
{
  return static_cast<std::uint64_t>(grid->GetNumberOfCells());
}

std::array<vtkIdType, 4> GetTet(vtkUnstructuredGrid* grid, std::size_t cell)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  grid->GetCellPoints(static_cast<vtkIdType>(cell), count, ids);
  if (count != 4)
  {
    throw Failure("not all cells are tetrahedra");
  }
  return { ids[0], ids[1], ids[2], ids[3] };
}

double GetVolume(vtkUnstructuredGrid* grid, std::size_t cell)
{
  double p[4][3];
  const auto tet = GetTet(grid, cell);
  for (std::size_t i = 0; i < 4; ++i)
  {
    grid->GetPoint(tet[i], p[i]);
  }
  double e[3][3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      e[i][c] = p[i + 1][c] - p[0][c];
    }
  }
  return std::abs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
    e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
}

/** A random place in a tetrahedron, evenly distributed, and the field there. */
FieldSample MakeSample(
  vtkUnstructuredGrid* grid, std::size_t cell, vtkDataArray* array, std::mt19937_64& random)
{
  std::array<double, 4> weights;
  for (double& weight : weights)
  {
    weight = -std::log(1 - static_cast<double>(random() >> 11) * 0x1p-53);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  FieldSample sample;
  const auto tet = GetTet(grid, cell);
  for (std::size_t i = 0; i < 4; ++i)
  {
    double corner[3];
    grid->GetPoint(tet[i], corner);
    for (std::size_t c = 0; c < 3; ++c)
    {
      sample.Place[c] += weights[i] / sum * corner[c];
    }
    sample.Value += weights[i] / sum * array->GetTuple1(tet[i]);
  }
  return sample;
}

/** Samples spread evenly over the volume, the same ones in each run. */
std::vector<FieldSample> MakeSamples(
  vtkUnstructuredGrid* grid, vtkDataArray* array, std::size_t count)
{
  std::mt19937_64 random(29);
  std::vector<double> ends(static_cast<std::size_t>(grid->GetNumberOfCells()));
  double sum = 0;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    ends[i] = sum += GetVolume(grid, i);
  }
  std::vector<FieldSample> samples;
  for (std::size_t i = 0; samples.size() < count && i < ends.size(); ++i)
  {
    // One in each of so many equal parts of the volume.
    while (samples.size() < count &&
      (static_cast<double>(samples.size()) + 0.5) * sum < ends[i] * static_cast<double>(count))
    {
      samples.push_back(MakeSample(grid, i, array, random));
    }
  }
  return samples;
}

/** The root mean square difference of a grid's field from samples. A sample outside of the grid
 * gets the value of the nearest place in it. */
double GetFieldError(const std::vector<FieldSample>& samples, vtkUnstructuredGrid* grid)
{
  vtkDataArray* const array = grid->GetPointData()->GetArray(0);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(grid);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double sum = 0;
  for (const FieldSample& sample : samples)
  {
    std::array<double, 3> place = sample.Place;
    double parameters[3];
    double weights[4];
    int sub = 0;
    double distance = 0;
    vtkIdType id = locator->FindCell(place.data(), 0, cell, parameters, weights);
    if (id < 0)
    {
      std::array<double, 3> nearest;
      locator->FindClosestPoint(place.data(), nearest.data(), cell, id, sub, distance);
      cell->EvaluatePosition(nearest.data(), nullptr, sub, parameters, distance, weights);
    }
    // In a flat tetrahedron, the weights may be anything.
    double all = 0;
    double value = 0;
    for (int i = 0; i < 4; ++i)
    {
      const double weight = std::isfinite(weights[i]) ? std::clamp(weights[i], 0.0, 1.0) : 1.0;
      all += weight;
      value += weight * array->GetTuple1(cell->GetPointId(i));
    }
    sum += (value / all - sample.Value) * (value / all - sample.Value);
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

void UpdateChecked(vtkGatunSimplify* filter)
{
  filter->Update();
  if (filter->GetErrorCode() != 0)
  {
    throw Failure("the mesh cannot be simplified");
  }
}

/** The most points with no more than so many tetrahedra. Returns the seconds of
 * getting there from the whole mesh. */
double SimplifyToTets(vtkGatunSimplify* filter, vtkIdType points, std::uint64_t tets)
{
  vtkIdType low = 0;
  vtkIdType high = points;
  const auto update = [&](vtkIdType number)
  {
    filter->SetSimplificationNumberOfPoints(number);
    return SecondsOf([&] { UpdateChecked(filter); });
  };
  while (low < high)
  {
    const vtkIdType middle = low + (high - low + 1) / 2;
    update(middle);
    if (CountCells(filter->GetUnstructuredGridOutput()) <= tets)
    {
      low = middle;
    }
    else
    {
      high = middle - 1;
    }
  }
  update(points); // so that there is something to do
  return update(low);
}

void AddSimplified(Json::Value& json, double seconds, vtkUnstructuredGrid* grid,
  const std::vector<FieldSample>& samples, double range)
{
  json["seconds"] = seconds;
  json["tets"] = CountCells(grid);
  json["rms"] = GetFieldError(samples, grid) / range;
}

void MeasureSimplification(const SimplifyOptions& options)
{
  const Grid grid = KeepPointArray(Load(options.File), options.Array);
  grid->GetPointData()->SetActiveScalars(options.Array.c_str());
  vtkDataArray* const array = grid->GetPointData()->GetArray(0);
  double range[2];
  array->GetRange(range);
  const auto samples = MakeSamples(grid, array, options.Samples);
  vtkNew<vtkGatunSimplify> filter;
  filter->SetInputData(grid);
  filter->SetArrayWeight(options.Array.c_str(), 1);
  filter->SetSimplificationNumberOfPoints(grid->GetNumberOfPoints());
  const double build = SecondsOf([&] { UpdateChecked(filter); });
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["tets"] = CountCells(grid);
      json["buildSeconds"] = build;
      json["parts"] = Json::arrayValue;
      for (const double part : options.Parts)
      {
        vtkNew<vtkUnstructuredGridQuadricDecimation> peer;
        peer->SetInputData(grid);
        peer->SetScalarsName(options.Array.c_str());
        peer->SetTargetReduction(1 - part);
        const double seconds = SecondsOf([&] { peer->Update(); });
        Json::Value entry;
        entry["part"] = part;
        auto tets = static_cast<std::uint64_t>(part * static_cast<double>(CountCells(grid)));
        // It may leave the mesh as it is, without a message, or nothing.
        const std::uint64_t found = CountCells(peer->GetOutput());
        if (found > 0 && found < CountCells(grid))
        {
          tets = found;
          AddSimplified(entry["peer"], seconds, peer->GetOutput(), samples, range[1] - range[0]);
        }
        const double own = SimplifyToTets(filter, grid->GetNumberOfPoints(), tets);
        AddSimplified(
          entry["gatun"], own, filter->GetUnstructuredGridOutput(), samples, range[1] - range[0]);
        json["parts"].append(entry);
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSimplify(CLI::App& app)
{
  auto options = std::make_shared<SimplifyOptions>();
  CLI::App* command = app.add_subcommand("simplify",
    "Time and error of the field, by vtkUnstructuredGridQuadricDecimation and vtkGatunSimplify");
  command->add_option("FILE", options->File, "A .gtn or .vtu file of tetrahedra")->required();
  command->add_option("--array", options->Array, "The point array that counts");
  command->add_option("--parts", options->Parts, "Parts of the tetrahedra")->delimiter(',');
  command->add_option("--samples", options->Samples, "Where the field is compared")
    ->check(CLI::Range(100, 100000000));
  command->callback([options] { MeasureSimplification(*options); });
}
}
