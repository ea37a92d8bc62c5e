// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// detail-flight: pictures on the way into a mesh in a file, each of which is to take no longer than
// a budget: their times, and what was read and held in memory for them.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchWindow.h"

#include "gatunFileReader.h"
#include "gatunParallel.h"
#include "vtkGatunReader.h"
#include "vtkGatunVolumeMapper.h"

#include "vtkNew.h"

#include <memory>
#include <string>
#include <vector>

namespace bench
{
namespace
{
struct DetailFlightOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  int Memory = 256;
  int Frames = 60;
  double Budget = 0.1;
  bool Uniform = false;
  bool OnlyPoints = false;
};

void Fly(const DetailFlightOptions& options)
{
  VolumeWindow window(options.Size);
  const PeakMemory memory;
  const Scene scene = MakeScene(gatun::FileReader(options.File), options.Array);
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(options.File.c_str());
  reader->SetMemoryBudget(options.Memory);
  vtkNew<vtkGatunVolumeMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray(options.Array.c_str());
  mapper->JustInTimeOn();
  mapper->SetViewDependent(!options.Uniform);
  mapper->SetTimeBudget(options.Budget);
  mapper->SetAutoAdjustSampleDistances(!options.OnlyPoints);
  window.SetVolume(mapper, scene);
  window.SetUpdateRate(1 / options.Budget);
  std::vector<double> seconds;
  std::vector<double> points;
  std::vector<double> distances;
  std::vector<double> bytes;
  for (int i = 0; i < options.Frames; ++i)
  {
    const double part = static_cast<double>(i) / static_cast<double>(options.Frames);
    seconds.push_back(SecondsOf([&] { window.RenderOnApproach(part); }));
    if (mapper->GetErrorCode() != 0)
    {
      throw Failure(options.File, "cannot be drawn");
    }
    points.push_back(static_cast<double>(mapper->GetNumberOfDrawnPoints()));
    distances.push_back(mapper->GetImageSampleDistance());
    bytes.push_back(static_cast<double>(mapper->GetBytesRead()));
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["size"] = options.Size;
      json["budget"] = options.Budget;
      json["memory"] = options.Memory;
      json["uniform"] = options.Uniform;
      json["onlyPoints"] = options.OnlyPoints;
      json["fileBytes"] = Json::UInt64{ FileSize(options.File) };
      json["before"] = Json::UInt64{ memory.GetBefore() };
      json["peak"] = Json::UInt64{ PeakMemory::GetPeak() };
      AddList(json, "seconds", seconds);
      AddList(json, "points", points);
      AddList(json, "distances", distances);
      AddList(json, "bytesRead", bytes);
    });
}
}

//------------------------------------------------------------------------------
void AddDetailFlight(CLI::App& app)
{
  auto options = std::make_shared<DetailFlightOptions>();
  CLI::App* command = app.add_subcommand("detail-flight",
    "Times of pictures on the way into a mesh in a file, bytes read and memory; needs a display");
  command->add_option("FILE", options->File, "A .gtn file with a hierarchy")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->add_option("--memory", options->Memory, "The memory budget, in MiB")
    ->check(CLI::Range(0, 1048576));
  command->add_option("--frames", options->Frames, "Pictures on the way")
    ->check(CLI::Range(1, 100000));
  command->add_option("--budget", options->Budget, "Seconds for each picture")
    ->check(CLI::Range(0.001, 1000.0));
  command->add_flag("--uniform", options->Uniform, "Simplify everywhere alike");
  command->add_flag(
    "--only-points", options->OnlyPoints, "A ray for each pixel: fewer points alone");
  command->callback([options] { Fly(*options); });
}
}
