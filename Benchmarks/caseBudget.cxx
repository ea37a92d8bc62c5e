// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// budget: how well pictures keep to a time while the camera goes along a path, and how long it
// takes until the picture is complete when it stops.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchWindow.h"

#include "gatunParallel.h"
#include "vtkGatunVolumeMapper.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace bench
{
namespace
{

constexpr double AtRest = 1e-4; // pictures a second

struct BudgetOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  int Memory = 512;
  int Frames = 60; // of each phase
  std::vector<double> Budgets{ 0.033, 0.1, 0.5 };
  bool OnlyRays = false;
};

/** A part of the path. */
struct Phase
{
  const char* Name;
  double Step; // degrees a picture
};

constexpr std::array<Phase, 2> Phases{ { { "fast", 7 }, { "slow", 0.4 } } };

/** What was measured of pictures, one after the other. */
struct Track
{
  std::vector<double> Seconds;
  std::vector<double> Points;
  std::vector<double> Distances; // of rays
};

class PathRun
{
public:
  PathRun(const BudgetOptions& options, vtkUnstructuredGrid* grid)
    : Settings(options)
    , Window(options.Size)
    , View(MakeScene(grid, options.Array))
  {
    for (vtkGatunVolumeMapper* const mapper : { this->Drawn.Get(), this->Plain.Get() })
    {
      mapper->SetInputData(grid);
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectScalarArray(options.Array.c_str());
    }
    this->Plain->SetMemoryBudget(0);
    this->Drawn->SetMemoryBudget(options.Memory);
    this->Drawn->SetJustInTime(!options.OnlyRays);
    this->Window.SetVolume(this->Drawn, this->View);
  }

  /** Seconds of the first picture, and until it is known how to simplify the mesh. */
  void Prepare(Json::Value& json)
  {
    json["first"] = SecondsOf([&] { this->Draw(0, AtRest); });
    json["prepare"] = SecondsOf([&] { this->Drawn->PrepareSimplification(); });
    json["whole"] = SecondsOf([&] { this->Draw(0, AtRest); });
  }

  void Follow(Json::Value& json, double budget)
  {
    // Another volume: nothing has been learnt of it.
    this->Window.SetVolume(this->Drawn, this->View);
    this->Drawn->SetTimeBudget(budget);
    double turn = 0;
    Json::Value entry;
    entry["budget"] = budget;
    for (const Phase& phase : Phases)
    {
      Track track;
      for (int i = 0; i < this->Settings.Frames; ++i)
      {
        turn += phase.Step;
        track.Seconds.push_back(SecondsOf([&] { this->Draw(turn, 1 / budget); }));
        track.Points.push_back(static_cast<double>(this->Drawn->GetNumberOfDrawnPoints()));
        track.Distances.push_back(this->Drawn->GetImageSampleDistance());
      }
      AddList(entry[phase.Name], "seconds", track.Seconds);
      AddList(entry[phase.Name], "points", track.Points);
      AddList(entry[phase.Name], "distances", track.Distances);
    }
    entry["rest"] = SecondsOf([&] { this->Draw(turn, AtRest); });
    entry["difference"] = this->CompareToFull(turn);
    json.append(entry);
  }

private:
  void Draw(double turn, double rate)
  {
    this->Window.SetUpdateRate(rate);
    this->Window.Render(turn);
  }

  /** How far the picture at rest is from that of a mapper that simplifies nothing, 0 to 255. */
  int CompareToFull(double turn)
  {
    const auto now = this->Window.GetPixels();
    this->Window.SetVolume(this->Plain, this->View);
    this->Draw(turn, AtRest);
    const auto full = this->Window.GetPixels();
    int most = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
    {
      most = std::max(most, std::abs(now[i] - full[i]));
    }
    return most;
  }

  const BudgetOptions& Settings;
  vtkNew<vtkGatunVolumeMapper> Drawn;
  vtkNew<vtkGatunVolumeMapper> Plain;
  VolumeWindow Window;
  Scene View;
};

void TimePath(const BudgetOptions& options)
{
  const Grid grid = Load(options.File);
  PathRun run(options, grid);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      json["points"] = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
      json["size"] = options.Size;
      json["memory"] = options.Memory;
      json["onlyRays"] = options.OnlyRays;
      run.Prepare(json);
      json["paths"] = Json::arrayValue;
      for (const double budget : options.Budgets)
      {
        run.Follow(json["paths"], budget);
      }
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddBudget(CLI::App& app)
{
  auto options = std::make_shared<BudgetOptions>();
  CLI::App* command = app.add_subcommand("budget",
    "Times of pictures that are to take no longer than a budget while the camera turns, fast and "
    "slowly, and rests; needs a display");
  command->add_option("FILE", options->File, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->add_option("--memory", options->Memory, "The memory budget, in MiB")
    ->check(CLI::Range(0, 1048576));
  command->add_option("--frames", options->Frames, "Pictures of each part of the path")
    ->check(CLI::Range(1, 100000));
  command->add_option("--budgets", options->Budgets, "Seconds, one path each")->delimiter(',');
  command->add_flag("--only-rays", options->OnlyRays, "Simplify nothing: fewer rays alone");
  command->callback([options] { TimePath(*options); });
}
}
