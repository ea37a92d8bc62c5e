// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// surface-frames: the frames of a camera path over a surface, within a time budget.

#include "benchCases.h"
#include "benchSurfacePipeline.h"

#include "gatunParallel.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkQuadricClustering.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace bench
{
namespace
{
struct SurfaceFramesOptions
{
  std::string File;
  double Budget = 0.1;
  double Resolution = 0.5;
  int Memory = 512;
  int Size = 1000;
  int Frames = 200;
  bool AtRest = false;
};

/** Whole: the mapper of the surface. Moving: what draws during the interaction. */
struct Pipeline
{
  SurfacePipeline Whole;
  vtkSmartPointer<vtkPolyDataMapper> Moving;
};

Pipeline MakePipeline(const SurfaceFramesOptions& options)
{
  Pipeline made{ MakeSurfacePipeline(options.File, options.Memory), nullptr };
  if (auto* const own = made.Whole.GetOwnMapper())
  {
    own->JustInTimeOn();
    own->SetTimeBudget(options.Budget);
    made.Moving = own;
  }
  made.Whole.Mapper->ScalarVisibilityOff();
  return made;
}

/** The level of detail that ParaView makes of surfaces, and its seconds. */
double MakeLevel(const SurfaceFramesOptions& options, Pipeline& pipeline)
{
  if (pipeline.Moving)
  {
    return 0;
  }
  // As vtkGeometryRepresentation does.
  auto decimation = vtkSmartPointer<vtkQuadricClustering>::New();
  decimation->SetUseInputPoints(1);
  decimation->SetCopyCellData(1);
  decimation->SetUseInternalTriangles(0);
  decimation->AutoAdjustNumberOfDivisionsOff();
  const int divisions = static_cast<int>(150 * options.Resolution) + 10;
  decimation->SetNumberOfDivisions(divisions, divisions, divisions);
  decimation->SetInputConnection(pipeline.Whole.Reader->GetOutputPort());
  const double seconds = SecondsOf([&] { decimation->Update(); });
  pipeline.Moving = vtkSmartPointer<vtkPolyDataMapper>::New();
  pipeline.Moving->SetInputConnection(decimation->GetOutputPort());
  pipeline.Moving->ScalarVisibilityOff();
  return seconds;
}

/** A turn around the surface with a glance from near, at a time from 0 to 1. */
void Place(vtkRenderer* renderer, double time)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetPosition(0, -1, 0.4);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(30);
  camera->Azimuth(360 * time);
  renderer->ResetCamera();
  camera->Dolly(1 + 2 * std::pow(std::sin(vtkMath::Pi() * time), 4));
  renderer->ResetCameraClippingRange();
}

void Measure(const SurfaceFramesOptions& options)
{
  constexpr double ratio = 1.25;
  constexpr double rateAtRest = 0.001;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(options.Size, options.Size);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkActor> actor;
  renderer->AddActor(actor);
  window->Render();
  const auto render = [&]
  {
    window->Render();
    window->WaitForCompletion();
  };
  Pipeline pipeline = MakePipeline(options);
  auto* const own = pipeline.Whole.GetOwnMapper();
  double rest = 0;
  double level = 0;
  actor->SetMapper(pipeline.Whole.Mapper);
  if (options.AtRest || !own)
  {
    window->SetDesiredUpdateRate(rateAtRest);
    rest = SecondsOf(
      [&]
      {
        Place(renderer, 0);
        render();
      });
    level = MakeLevel(options, pipeline);
  }
  actor->SetMapper(pipeline.Moving);
  window->SetDesiredUpdateRate(1 / options.Budget);
  std::vector<double> frames;
  std::vector<double> points;
  for (int i = 0; i < options.Frames; ++i)
  {
    // The frame contains the look at the bounds, as in an interaction.
    frames.push_back(SecondsOf(
      [&]
      {
        Place(renderer, static_cast<double>(i) / options.Frames);
        render();
      }));
    points.push_back(static_cast<double>(
      own ? own->GetNumberOfDrawnPoints() : pipeline.Moving->GetInput()->GetNumberOfPoints()));
  }
  if (pipeline.Whole.HasFailed())
  {
    throw Failure(options.File, "cannot be drawn");
  }
  window->SetDesiredUpdateRate(rateAtRest);
  const double refined = SecondsOf(render);
  const auto within = std::count_if(frames.begin(), frames.end(),
    [&](double seconds) { return seconds <= ratio * options.Budget; });
  std::vector<double> sorted = points;
  std::sort(sorted.begin(), sorted.end());
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["budget"] = options.Budget;
      json["restSeconds"] = rest;
      json["levelSeconds"] = level;
      json["refinedSeconds"] = refined;
      json["withinShare"] = static_cast<double>(within) / static_cast<double>(options.Frames);
      json["medianPoints"] = sorted[sorted.size() / 2];
      AddList(json, "frames", frames);
      AddList(json, "points", points);
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSurfaceFrames(CLI::App& app)
{
  auto options = std::make_shared<SurfaceFramesOptions>();
  CLI::App* const command = app.add_subcommand("surface-frames",
    "Times of the frames of a camera path over a surface: a .gtn file just in time, or a .vtp file "
    "with ParaView's level of detail");
  command->add_option("FILE", options->File, "A .gtn file with base meshes, or a .vtp file")
    ->required();
  command->add_option("--budget", options->Budget, "Seconds for a frame")
    ->check(CLI::Range(1e-4, 10.0));
  command->add_option("--resolution", options->Resolution, "ParaView's LOD resolution")
    ->check(CLI::Range(0.0, 1.0));
  command->add_option("--memory", options->Memory, "Memory for buffers of chunks in MiB")
    ->check(CLI::Range(0, 1 << 30));
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(1, 8192));
  command->add_option("--frames", options->Frames, "Number of frames")
    ->check(CLI::Range(1, 100000));
  command->add_flag("--rest", options->AtRest, "Draw the whole surface first");
  command->callback([options] { Measure(*options); });
}
}
