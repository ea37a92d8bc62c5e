// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// instructions: time for pictures of a mesh in memory, by instruction set, in turns.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchScene.h"

#include "gatunParallel.h"
#include "vtkGatunRayCaster.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <memory>

namespace bench
{
namespace
{

struct InstructionsOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  int Rounds = 7;
};

void TimeInstructions(const InstructionsOptions& options)
{
  const Grid grid = Load(options.File);
  const Scene scene = MakeScene(grid, options.Array);
  vtkNew<vtkCamera> camera;
  vtkNew<vtkVolumeProperty> property;
  scene.SetUp(property);
  vtkNew<vtkGatunRayCaster> caster;
  caster->SetInputData(grid);
  caster->SetArrayName(options.Array.c_str());
  caster->SetProperty(property);
  caster->SetCamera(camera);
  caster->SetSize(options.Size, options.Size);

  std::vector<Operation> operations;
  for (const auto& [name, instructions] : {
         std::pair{ "portable", vtkGatunRayCaster::PORTABLE_INSTRUCTIONS },
         std::pair{ "AVX2", vtkGatunRayCaster::AVX2_INSTRUCTIONS },
         std::pair{ "AVX-512", vtkGatunRayCaster::AVX512_INSTRUCTIONS },
       })
  {
    const auto draw = [&, instructions, picture = 0]() mutable
    {
      caster->SetInstructions(instructions);
      scene.SetUp(camera, TurnOfPictures * ++picture);
      caster->Update();
      if (caster->GetErrorCode() != 0)
      {
        throw Failure(options.File, "cannot be drawn");
      }
    };
    operations.push_back({ name, draw });
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      json["size"] = options.Size;
      json["instructions"] = Json::arrayValue;
      for (const Operation& operation : operations)
      {
        Json::Value entry;
        entry["name"] = operation.Name;
        AddTimes(entry, operation);
        json["instructions"].append(entry);
      }
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddInstructions(CLI::App& app)
{
  auto options = std::make_shared<InstructionsOptions>();
  CLI::App* command = app.add_subcommand("instructions",
    "Time of later pictures by vtkGatunRayCaster with each instruction set. A set that the "
    "processor does not have is replaced by the next simpler one");
  command->add_option("FILE", options->File, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->add_option("--rounds", options->Rounds, "Pictures by each")->check(CLI::Range(1, 1000));
  command->callback([options] { TimeInstructions(*options); });
}
}
