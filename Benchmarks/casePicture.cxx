// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// picture: time from a file to its first picture in a window, and the memory that takes.

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

struct PictureOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  int Budget = 512;
};

/** Straight from the file, as its reader is what the mapper is connected to. */
void DrawFile(VolumeWindow& window, const PictureOptions& options)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(options.File.c_str());
  reader->SetMemoryBudget(options.Budget);
  const Mapper mapper = MakeMapper("gatun", options.Array, options.Budget);
  mapper->SetInputConnection(reader->GetOutputPort());
  window.SetVolume(mapper, MakeScene(gatun::FileReader(options.File), options.Array));
  window.Render();
}

void DrawGrid(VolumeWindow& window, const PictureOptions& options)
{
  const Grid grid = Load(options.File);
  const Mapper mapper = MakeMapper("bunyk", options.Array, options.Budget);
  mapper->SetInputData(grid);
  window.SetVolume(mapper, MakeScene(grid, options.Array));
  window.Render();
}

void TimePicture(const PictureOptions& options)
{
  const bool isGatun = options.File.ends_with(".gtn");
  VolumeWindow window(options.Size);
  const Cost cost =
    CostOf([&] { isGatun ? DrawFile(window, options) : DrawGrid(window, options); });
  const Seen seen = window.Look();
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["mapper"] = isGatun ? "gatun" : "bunyk";
      json["size"] = options.Size;
      json["budget"] = options.Budget;
      AddCost(json, cost);
      json["covered"] = seen.Covered;
      json["mean"] = seen.Mean;
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddPicture(CLI::App& app)
{
  auto options = std::make_shared<PictureOptions>();
  CLI::App* command = app.add_subcommand("picture",
    "Time and memory from a file to its first picture: .gtn by Gatun's mapper, .vtu by "
    "vtkUnstructuredGridVolumeRayCastMapper; needs a display");
  command->add_option("FILE", options->File, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->add_option("--budget", options->Budget, "Gatun's memory budget, in MiB")
    ->check(CLI::Range(0, 1048576));
  command->callback([options] { TimePicture(*options); });
}
}
