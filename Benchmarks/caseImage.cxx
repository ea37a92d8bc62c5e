// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// image: time and memory from a file to its first image in a window. frames: time of further images
// of a mesh in memory, by Gatun's mapper and by VTK's ray caster in turns.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchWindow.h"

#include "gatunParallel.h"
#include "vtkGatunReader.h"

#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory>

namespace bench
{
namespace
{
struct ImageOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  int Budget = 512;
  int Rounds = 5;
};

/** Straight from the file, as its reader is what the mapper is connected to. */
void ShowFile(VolumeWindow& window, const ImageOptions& options)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(options.File.c_str());
  reader->SetMemoryBudget(options.Budget);
  const Mapper mapper = MakeMapper(true, options.Array, options.Budget);
  mapper->SetInputConnection(reader->GetOutputPort());
  window.SetVolume(mapper, MakeScene(gatun::FileReader(options.File), options.Array));
  window.Render();
}

void ShowGrid(
  VolumeWindow& window, bool isGatun, vtkUnstructuredGrid* grid, const ImageOptions& options)
{
  const Mapper mapper = MakeMapper(isGatun, options.Array, options.Budget);
  mapper->SetInputData(grid);
  window.SetVolume(mapper, MakeScene(grid, options.Array));
  window.Render();
}

void MeasureImage(const ImageOptions& options)
{
  VolumeWindow window(options.Size);
  const Cost cost = CostOf(
    [&]
    {
      if (options.File.ends_with(".gtn"))
      {
        ShowFile(window, options);
      }
      else
      {
        ShowGrid(window, false, Load(options.File), options);
      }
    });
  const double mean = window.GetMean();
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      AddCost(json, cost);
      json["mean"] = mean;
    });
}

void MeasureFrames(const ImageOptions& options)
{
  const Grid grid = Load(options.File);
  std::vector<std::unique_ptr<VolumeWindow>> windows;
  std::vector<Operation> operations;
  std::array<int, 2> frames{};
  for (const bool isGatun : { true, false })
  {
    windows.push_back(std::make_unique<VolumeWindow>(options.Size));
    ShowGrid(*windows.back(), isGatun, grid, options);
    VolumeWindow& window = *windows.back();
    int& frame = frames[isGatun ? 0 : 1];
    operations.push_back(
      { isGatun ? "gatun" : "vtk", [&window, &frame] { window.Render(TurnOfImages * ++frame); } });
  }
  RunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      json["size"] = options.Size;
      for (std::size_t i = 0; i < operations.size(); ++i)
      {
        Json::Value& mapper = json["mappers"][operations[i].Name];
        AddList(mapper, "seconds", operations[i].Seconds);
        mapper["mean"] = windows[i]->GetMean();
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddImage(CLI::App& app)
{
  auto options = std::make_shared<ImageOptions>();
  const auto add = [&](const char* name, const char* about)
  {
    CLI::App* command = app.add_subcommand(name, about);
    command->add_option("FILE", options->File, "A .vtu or .gtn file of tetrahedra")->required();
    command->add_option("--array", options->Array, "The point array to show");
    command->add_option("--size", options->Size, "Width and height in pixels")
      ->check(CLI::Range(16, 8192));
    command->add_option("--budget", options->Budget, "Gatun's memory budget, in MiB")
      ->check(CLI::Range(0, 1048576));
    return command;
  };
  add("image",
    "Time and memory from a file to its first image: .gtn by Gatun's mapper, .vtu by "
    "vtkUnstructuredGridVolumeRayCastMapper; needs a display")
    ->callback([options] { MeasureImage(*options); });
  CLI::App* frames =
    add("frames", "Time of later images of a mesh in memory by both mappers; needs a display");
  frames->add_option("--rounds", options->Rounds, "Images")->check(CLI::Range(1, 1000));
  frames->callback([options] { MeasureFrames(*options); });
}
}
