// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// simplify-gatun, simplify-quadric: a mesh is made coarser by vtkGatunSimplify, to any degree at
// once, or by vtkUnstructuredGridQuadricDecimation, to one. simplify-compare: what became of it.

#include "benchCases.h"
#include "benchDeviation.h"
#include "benchFiles.h"

#include "gatunMergeBuilder.h"
#include "vtkGatunSimplify.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridQuadricDecimation.h"

#include <algorithm>
#include <memory>

namespace bench
{
namespace
{

struct Options
{
  std::string File;
  std::string Array = "Density";
  std::vector<std::uint64_t> Tets;
  std::vector<std::string> Others;
  std::string Out;
  double Part = 0.5;
  std::size_t Samples = 200000;
  int Rounds = 1;
};

void WriteMesh(vtkUnstructuredGrid* grid, const std::string& file)
{
  if (!file.empty())
  {
    Write({ "vtu-raw", false, false }, grid, file);
  }
}

std::uint64_t CountCells(vtkUnstructuredGrid* grid)
{
  return static_cast<std::uint64_t>(grid->GetNumberOfCells());
}

void UpdateChecked(vtkGatunSimplify* filter)
{
  filter->Update();
  if (filter->GetErrorCode() != 0)
  {
    throw Failure("the mesh cannot be simplified");
  }
}

/** The most points with no more than so many tetrahedra. Takes the last update's seconds. */
double SimplifyToTets(vtkGatunSimplify* filter, vtkIdType points, std::uint64_t tets)
{
  vtkIdType low = 0;
  vtkIdType high = points;
  double seconds = 0;
  const auto update = [&](vtkIdType number)
  {
    filter->SetSimplificationNumberOfPoints(number);
    seconds = SecondsOf([&] { UpdateChecked(filter); });
  };
  while (low < high)
  {
    const vtkIdType middle = low + (high - low + 1) / 2;
    update(middle);
    if (CountCells(filter->GetOutput()) <= tets)
    {
      low = middle;
    }
    else
    {
      high = middle - 1;
    }
  }
  update(low);
  return seconds;
}

void SimplifyByGatun(const Options& options)
{
  const Grid grid = KeepPointArray(Load(options.File), options.Array);
  vtkNew<vtkGatunSimplify> filter;
  filter->SetInputData(grid);
  filter->SetArrayWeight(options.Array.c_str(), 1);
  filter->SetSimplificationTarget(vtkGatunSimplify::TARGET_NUMBER_OF_POINTS);
  filter->SetSimplificationNumberOfPoints(grid->GetNumberOfPoints());
  const PeakMemory memory;
  const double build = SecondsOf([&] { UpdateChecked(filter); });
  const std::uint64_t peak = PeakMemory::GetPeak();
  PrintJson(
    [&](gtn::Json& json)
    {
      json.Add("tets", CountCells(grid));
      json.Add("points", static_cast<std::uint64_t>(grid->GetNumberOfPoints()));
      json.Add("seconds", build);
      json.Add("before", memory.GetBefore());
      json.Add("peak", peak);
      json.BeginArray("meshes");
      for (std::size_t i = 0; i < options.Tets.size(); ++i)
      {
        const double seconds = SimplifyToTets(filter, grid->GetNumberOfPoints(), options.Tets[i]);
        auto* const output = filter->GetOutput();
        json.BeginObject();
        json.Add("tets", CountCells(output));
        json.Add("points", static_cast<std::uint64_t>(output->GetNumberOfPoints()));
        json.Add("seconds", seconds);
        json.EndObject();
        WriteMesh(output, i < options.Others.size() ? options.Others[i] : std::string());
      }
      json.EndArray();
    });
}

void SimplifyByQuadrics(const Options& options)
{
  const Grid grid = KeepPointArray(Load(options.File), options.Array);
  grid->GetPointData()->SetActiveScalars(options.Array.c_str());
  vtkNew<vtkUnstructuredGridQuadricDecimation> filter;
  filter->SetInputData(grid);
  filter->SetScalarsName(options.Array.c_str());
  filter->SetTargetReduction(1 - options.Part);
  const PeakMemory memory;
  const double seconds = SecondsOf([&] { filter->Update(); });
  const std::uint64_t peak = PeakMemory::GetPeak();
  auto* const output = filter->GetOutput();
  if (CountCells(output) > 0)
  {
    // It loses the name.
    output->GetPointData()->GetArray(0)->SetName(options.Array.c_str());
    WriteMesh(output, options.Out);
  }
  PrintJson(
    [&](gtn::Json& json)
    {
      json.Add("part", options.Part);
      json.Add("tets", CountCells(output));
      json.Add("points", static_cast<std::uint64_t>(output->GetNumberOfPoints()));
      json.Add("seconds", seconds);
      json.Add("before", memory.GetBefore());
      json.Add("peak", peak);
    });
}

/** Only the list of merges, without the filter around it. */
void Build(const Options& options)
{
  const Grid grid = KeepPointArray(Load(options.File), options.Array);
  vtkDataArray* const array = grid->GetPointData()->GetArray(0);
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  std::vector<double> values(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    grid->GetPoint(static_cast<vtkIdType>(i), points[i].data());
    values[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  }
  std::vector<gatun::MergeTree::Tet> tets(CountCells(grid));
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(static_cast<vtkIdType>(i), count, ids);
    std::transform(
      ids, ids + 4, tets[i].begin(), [](vtkIdType id) { return static_cast<std::uint32_t>(id); });
  }
  const gatun::MergeInput input{ points, tets, { { values, 1 } } };
  gatun::MergeTree tree;
  std::vector<double> seconds;
  const PeakMemory memory;
  for (int round = 0; round < options.Rounds; ++round)
  {
    seconds.push_back(SecondsOf([&] { tree = gatun::BuildMergeTree(input); }));
  }
  const std::uint64_t peak = PeakMemory::GetPeak();
  std::size_t gone = 0;
  const double ancestors =
    SecondsOf([&] { gone = tree.FindAncestors(tree.GetMerges().size() / 2).size(); });
  PrintJson(
    [&](gtn::Json& json)
    {
      json.Add("tets", CountCells(grid));
      json.Add("points", std::uint64_t{ gone });
      json.Add("merges", std::uint64_t{ tree.GetMerges().size() });
      AddList(json, "seconds", seconds);
      json.Add("ancestors", ancestors);
      json.Add("before", memory.GetBefore());
      json.Add("peak", peak);
    });
}

void AddComparison(
  gtn::Json& json, const Samples& samples, vtkUnstructuredGrid* grid, const Options& options)
{
  const Deviation deviation = Compare(samples, grid, options.Array);
  const Shapes shapes = LookAtShapes(grid);
  json.Add("tets", CountCells(grid));
  json.Add("points", static_cast<std::uint64_t>(grid->GetNumberOfPoints()));
  json.Add("rms", deviation.Rms);
  json.Add("largest", deviation.Largest);
  json.Add("rmsInside", deviation.RmsInside);
  json.Add("outside", std::uint64_t{ deviation.Outside });
  json.Add("boundaryMean", deviation.BoundaryMean);
  json.Add("boundaryLargest", deviation.BoundaryLargest);
  json.Add("volume", shapes.Volume);
  json.Add("worst", shapes.Worst);
  json.Add("firstPercentile", shapes.FirstPercentile);
  json.Add("median", shapes.Median);
  json.Add("flat", std::uint64_t{ shapes.Flat });
  json.Add("inverted", std::uint64_t{ shapes.Inverted });
}

void CompareAll(const Options& options)
{
  const Grid grid = Load(options.File);
  const Samples samples = MakeSamples(grid, options.Array, options.Samples);
  PrintJson(
    [&](gtn::Json& json)
    {
      json.Add("samples", std::uint64_t{ samples.Places.size() });
      json.BeginObject("original");
      AddComparison(json, samples, grid, options);
      json.EndObject();
      json.BeginArray("meshes");
      for (const auto& file : options.Others)
      {
        json.BeginObject();
        AddComparison(json, samples, Load(file), options);
        json.EndObject();
      }
      json.EndArray();
    });
}

CLI::App* AddCase(CLI::App& app, const std::shared_ptr<Options>& options, const char* name,
  const char* about, void (*run)(const Options&))
{
  CLI::App* command = app.add_subcommand(name, about);
  command->add_option("FILE", options->File, "A .gtn or .vtu file of tetrahedra")->required();
  command->add_option("--array", options->Array, "The point array that counts");
  command->callback([options, run] { run(*options); });
  return command;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddSimplify(CLI::App& app)
{
  auto options = std::make_shared<Options>();
  CLI::App* gatun = AddCase(app, options, "simplify-gatun",
    "Time and memory of vtkGatunSimplify: the first update, and then to other sizes",
    SimplifyByGatun);
  gatun->add_option("--tets", options->Tets, "At most so many tetrahedra, one mesh after the other")
    ->delimiter(',');
  gatun->add_option("--out", options->Others, "Where these meshes are written, .vtu");
  CLI::App* build =
    AddCase(app, options, "simplify-build", "Time and memory of finding the list of merges", Build);
  build->add_option("--rounds", options->Rounds, "How often")->check(CLI::Range(1, 1000));
  CLI::App* quadric = AddCase(app, options, "simplify-quadric",
    "Time and memory of vtkUnstructuredGridQuadricDecimation", SimplifyByQuadrics);
  quadric->add_option("--part", options->Part, "The part of the tetrahedra that is to be left")
    ->check(CLI::Range(0.0, 1.0));
  quadric->add_option("--out", options->Out, "Where the mesh is written, .vtu");
  CLI::App* compare = AddCase(app, options, "simplify-compare",
    "How far simplified meshes are from the one that they were made of", CompareAll);
  compare->add_option("OTHERS", options->Others, "Simplified meshes");
  compare->add_option("--samples", options->Samples, "How many places to look at")
    ->check(CLI::Range(100, 100000000));
}
}
