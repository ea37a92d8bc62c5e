// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// surface-draw: time and memory from the file of a surface to its first image.

#include "benchCases.h"
#include "benchSurfacePipeline.h"

#include "gatunParallel.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <memory>

namespace bench
{
namespace
{
struct SurfaceDrawOptions
{
  std::string File;
  std::string Array;
  double Zoom = 1;
  int Budget = 512;
  int Size = 1000;
  int Frames = 5;
  bool IsMoving = false;
};

SurfacePipeline MakePipeline(const SurfaceDrawOptions& options)
{
  SurfacePipeline made = MakeSurfacePipeline(options.File, options.Budget);
  if (auto* const own = made.GetOwnMapper())
  {
    own->SetJustInTime(options.IsMoving);
  }
  made.Mapper->SetScalarVisibility(!options.Array.empty());
  made.Mapper->SetScalarModeToUsePointFieldData();
  made.Mapper->SelectColorArray(options.Array.c_str());
  return made;
}

void Measure(const SurfaceDrawOptions& options)
{
  // What every image takes is there before.
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(options.Size, options.Size);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkPolyDataMapper> first;
  first->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(first);
  renderer->AddActor(actor);
  window->Render();

  const auto render = [&]
  {
    window->Render();
    window->WaitForCompletion();
  };
  SurfacePipeline pipeline;
  if (options.IsMoving)
  {
    window->SetDesiredUpdateRate(10);
  }
  const Cost cost = CostOf(
    [&]
    {
      pipeline = MakePipeline(options);
      actor->SetMapper(pipeline.Mapper);
      renderer->ResetCamera();
      renderer->GetActiveCamera()->Zoom(options.Zoom);
      render();
    });
  if (pipeline.HasFailed())
  {
    throw Failure(options.File, "cannot be drawn");
  }
  Cost whole{};
  if (options.IsMoving)
  {
    window->SetDesiredUpdateRate(0.001);
    whole = CostOf(render);
  }
  std::vector<double> frames;
  for (int i = 0; i < options.Frames; ++i)
  {
    renderer->GetActiveCamera()->Azimuth(1);
    frames.push_back(SecondsOf(render));
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["fileBytes"] = FileSize(options.File);
      AddCost(json["first"], cost);
      if (options.IsMoving)
      {
        AddCost(json["whole"], whole);
      }
      AddList(json, "frames", frames);
      if (auto* const own = pipeline.GetOwnMapper())
      {
        json["bufferBytes"] = static_cast<std::uint64_t>(own->GetBufferBytes());
        json["decodedChunks"] = static_cast<std::uint64_t>(own->GetNumberOfDecodedChunks());
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSurfaceDraw(CLI::App& app)
{
  auto options = std::make_shared<SurfaceDrawOptions>();
  CLI::App* const command = app.add_subcommand("surface-draw",
    "Time and memory from a surface's file to its first image, and for the next ones");
  command->add_option("FILE", options->File, "A .gtn or .vtp file with a surface")->required();
  command->add_option("--array", options->Array, "Point array that gives colors");
  command->add_option("--zoom", options->Zoom, "Magnification")->check(CLI::Range(0.01, 1e6));
  command->add_option("--budget", options->Budget, "Memory for buffers of chunks in MiB")
    ->check(CLI::Range(0, 1 << 30));
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(1, 8192));
  command->add_option("--frames", options->Frames, "Images after the first")
    ->check(CLI::Range(0, 1000));
  command->add_flag("--moving", options->IsMoving,
    "Draw the first image as part of an interaction, just in time, and then the whole");
  command->callback([options] { Measure(*options); });
}
}
