// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// study-picture: from a file to a picture without a window, by one ray caster in two ways: from a
// mesh that is decompressed as a whole before, and while it is decompressed.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchScene.h"

#include "gatunParallel.h"
#include "vtkGatunRayCaster.h"
#include "vtkGatunReader.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <memory>

namespace bench
{
namespace
{

struct StudyPictureOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  bool Whole = false;
};

Seen Look(vtkImageData* image)
{
  auto* const pixels = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  const vtkIdType count = pixels->GetNumberOfTuples();
  vtkIdType covered = 0;
  double sum = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    covered += pixels->GetTypedComponent(i, 3) > 0 ? 1 : 0;
    for (int c = 0; c < 3; ++c)
    {
      sum += pixels->GetTypedComponent(i, c);
    }
  }
  if (covered == 0)
  {
    throw Failure("a picture is empty");
  }
  return { static_cast<double>(covered) / static_cast<double>(count),
    sum / (3 * static_cast<double>(count)) };
}

void Draw(vtkGatunRayCaster* caster, const Scene& scene, const StudyPictureOptions& options)
{
  vtkNew<vtkCamera> camera;
  vtkNew<vtkVolumeProperty> property;
  scene.SetUp(camera);
  scene.SetUp(property);
  caster->SetCamera(camera);
  caster->SetProperty(property);
  caster->SetArrayName(options.Array.c_str());
  caster->SetSize(options.Size, options.Size);
  caster->SetMemoryBudget(0);
  caster->Update();
  if (caster->GetErrorCode() != 0)
  {
    throw Failure(options.File, "cannot be drawn");
  }
}

/** Nothing is kept of what the reader decodes but the grid. */
Grid LoadWhole(const std::string& file)
{
  if (!file.ends_with(".gtn"))
  {
    return Load(file);
  }
  vtkNew<vtkGatunReader> reader;
  reader->SetMemoryBudget(0);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    throw Failure(file, "cannot be read");
  }
  return reader->GetOutput();
}

void DrawWhole(vtkGatunRayCaster* caster, const StudyPictureOptions& options)
{
  const Grid grid = LoadWhole(options.File);
  caster->SetInputData(grid);
  Draw(caster, MakeScene(grid, options.Array), options);
}

void DrawFile(vtkGatunRayCaster* caster, const StudyPictureOptions& options)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetMemoryBudget(0);
  reader->SetFileName(options.File.c_str());
  caster->SetInputConnection(reader->GetOutputPort());
  Draw(caster, MakeScene(gatun::FileReader(options.File), options.Array), options);
}

void TimePicture(const StudyPictureOptions& options)
{
  vtkNew<vtkGatunRayCaster> caster;
  const Cost cost =
    CostOf([&] { options.Whole ? DrawWhole(caster, options) : DrawFile(caster, options); });
  const Seen seen = Look(caster->GetOutput());
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["size"] = options.Size;
      json["whole"] = options.Whole;
      AddCost(json, cost);
      json["covered"] = seen.Covered;
      json["mean"] = seen.Mean;
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddStudyPicture(CLI::App& app)
{
  auto options = std::make_shared<StudyPictureOptions>();
  CLI::App* command = app.add_subcommand("study-picture",
    "Time and memory from a file to a picture by vtkGatunRayCaster, chunk by chunk");
  command->add_option("FILE", options->File, "A .gtn file; with --whole also a .vtu file")
    ->required();
  command->add_flag("--whole", options->Whole, "Load the whole mesh first");
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->callback([options] { TimePicture(*options); });
}
}
