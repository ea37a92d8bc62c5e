// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// simplify-gatun, simplify-quadric: a mesh is made coarser by vtkGatunSimplify, to any degree at
// once, or by vtkUnstructuredGridQuadricDecimation, to one. simplify-compare: what became of it.

#include "benchCases.h"
#include "benchDeviation.h"
#include "benchFiles.h"

#include "gatunMergeBuilder.h"
#include "gatunParallel.h"
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

struct SimplifyOptions
{
  std::string File;
  std::string Array = "Density";
  std::vector<std::uint64_t> Tets;
  std::vector<std::string> Others;
  std::string Out;
  double Part = 0.5;
  std::size_t Samples = 200000;
  int Rounds = 1;
  std::vector<int> Threads;
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
    if (CountCells(filter->GetUnstructuredGridOutput()) <= tets)
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

void SimplifyByGatun(const SimplifyOptions& options)
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
    [&](Json::Value& json)
    {
      json["tets"] = CountCells(grid);
      json["points"] = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
      json["seconds"] = build;
      json["before"] = memory.GetBefore();
      json["peak"] = peak;
      json["meshes"] = Json::arrayValue;
      for (std::size_t i = 0; i < options.Tets.size(); ++i)
      {
        const double seconds = SimplifyToTets(filter, grid->GetNumberOfPoints(), options.Tets[i]);
        auto* const output = filter->GetUnstructuredGridOutput();
        Json::Value meshJson;
        meshJson["tets"] = CountCells(output);
        meshJson["points"] = static_cast<std::uint64_t>(output->GetNumberOfPoints());
        meshJson["seconds"] = seconds;
        json["meshes"].append(meshJson);
        WriteMesh(output, i < options.Others.size() ? options.Others[i] : std::string());
      }
    });
}

void SimplifyByQuadrics(const SimplifyOptions& options)
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
    [&](Json::Value& json)
    {
      json["part"] = options.Part;
      json["tets"] = CountCells(output);
      json["points"] = static_cast<std::uint64_t>(output->GetNumberOfPoints());
      json["seconds"] = seconds;
      json["before"] = memory.GetBefore();
      json["peak"] = peak;
    });
}

/** Only the list of merges, without the filter around it, by each number of threads in turn. */
void Build(const SimplifyOptions& options)
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
  std::vector<int> threads = options.Threads;
  if (threads.empty())
  {
    threads.push_back(gatun::GetNumberOfThreads());
  }
  std::vector<Operation> operations;
  for (const int count : threads)
  {
    const auto build = [&tree, &input] { tree = gatun::BuildMergeTree(input); };
    operations.push_back(
      { std::to_string(count), [count, build] { gatun::WithNumberOfThreads(count, build); } });
  }
  const PeakMemory memory;
  RunInterleaved(operations, options.Rounds);
  const std::uint64_t peak = PeakMemory::GetPeak();
  std::size_t gone = 0;
  const double ancestors =
    SecondsOf([&] { gone = tree.FindAncestors(tree.GetMerges().size() / 2).size(); });
  PrintJson(
    [&](Json::Value& json)
    {
      json["tets"] = CountCells(grid);
      json["points"] = std::uint64_t{ gone };
      json["merges"] = std::uint64_t{ tree.GetMerges().size() };
      AddList(json, "seconds", operations.front().Seconds);
      json["threads"] = Json::arrayValue;
      for (const Operation& operation : operations)
      {
        auto sorted = operation.Seconds;
        std::sort(sorted.begin(), sorted.end());
        Json::Value run;
        run["threads"] = std::stoi(operation.Name);
        run["rate"] = 1e-6 * static_cast<double>(tets.size()) / sorted[sorted.size() / 2];
        AddTimes(run, operation);
        json["threads"].append(run);
      }
      json["ancestors"] = ancestors;
      json["before"] = memory.GetBefore();
      json["peak"] = peak;
    });
}

void AddComparison(Json::Value& json, const Samples& samples, vtkUnstructuredGrid* grid,
  const SimplifyOptions& options)
{
  const Deviation deviation = Compare(samples, grid, options.Array);
  const Shapes shapes = LookAtShapes(grid);
  json["tets"] = CountCells(grid);
  json["points"] = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
  json["rms"] = deviation.Rms;
  json["largest"] = deviation.Largest;
  json["rmsInside"] = deviation.RmsInside;
  json["outside"] = std::uint64_t{ deviation.Outside };
  json["boundaryMean"] = deviation.BoundaryMean;
  json["boundaryLargest"] = deviation.BoundaryLargest;
  json["volume"] = shapes.Volume;
  json["worst"] = shapes.Worst;
  json["firstPercentile"] = shapes.FirstPercentile;
  json["median"] = shapes.Median;
  json["flat"] = std::uint64_t{ shapes.Flat };
  json["inverted"] = std::uint64_t{ shapes.Inverted };
}

void CompareAll(const SimplifyOptions& options)
{
  const Grid grid = Load(options.File);
  const Samples samples = MakeSamples(grid, options.Array, options.Samples);
  PrintJson(
    [&](Json::Value& json)
    {
      json["samples"] = std::uint64_t{ samples.Places.size() };
      AddComparison(json["original"], samples, grid, options);
      json["meshes"] = Json::arrayValue;
      for (const auto& file : options.Others)
      {
        Json::Value meshJson;
        AddComparison(meshJson, samples, Load(file), options);
        json["meshes"].append(meshJson);
      }
    });
}

CLI::App* AddCase(CLI::App& app, const std::shared_ptr<SimplifyOptions>& options, const char* name,
  const char* about, void (*run)(const SimplifyOptions&))
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
  auto options = std::make_shared<SimplifyOptions>();
  CLI::App* gatun = AddCase(app, options, "simplify-gatun",
    "Time and memory of vtkGatunSimplify: the first update, and then to other sizes",
    SimplifyByGatun);
  gatun->add_option("--tets", options->Tets, "At most so many tetrahedra, one mesh after the other")
    ->delimiter(',');
  gatun->add_option("--out", options->Others, "Where these meshes are written, .vtu");
  CLI::App* build =
    AddCase(app, options, "simplify-build", "Time and memory of finding the list of merges", Build);
  build->add_option("--rounds", options->Rounds, "How often")->check(CLI::Range(1, 1000));
  build
    ->add_option("--threads", options->Threads,
      "Numbers of threads that take turns; each gives a rate in millions of tetrahedra a second")
    ->delimiter(',')
    ->check(CLI::Range(1, 1024));
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
