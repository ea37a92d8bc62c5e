// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// render: time for pictures of a mesh in memory, by Gatun's mapper and by VTK's, in turns.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchHits.h"
#include "benchWindow.h"

#include "gatunParallel.h"

#include "vtkCamera.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"

#include <algorithm>
#include <memory>

namespace bench
{
namespace
{

struct RenderOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  bool Orthographic = false;
  std::vector<std::string> Mappers = GetMapperNames();
  int Rounds = 5;
  int SlowRounds = 2;
  int FirstRounds = 2;
};

/** The median over all rounds of how many times faster the first mapper is than another. */
double GetGain(const std::vector<double>& first, const std::vector<double>& other)
{
  std::vector<double> gains;
  for (std::size_t i = 0; i < std::min(first.size(), other.size()); ++i)
  {
    gains.push_back(other[i] / first[i]);
  }
  if (gains.empty())
  {
    return 0;
  }
  std::sort(gains.begin(), gains.end());
  return gains[gains.size() / 2];
}

/** A mapper at work. */
struct Contender
{
  std::string Name;
  std::unique_ptr<VolumeWindow> Window = {};
  std::vector<double> FirstFrames = {}; ///< seconds, each in a window of its own
  Seen FirstPicture = {};
  int Pictures = 0; ///< later ones

  bool IsSlow() const { return this->Name == "zsweep" || this->Name == "projected"; }
};

void DrawFirst(
  Contender& contender, vtkUnstructuredGrid* grid, const Scene& scene, const RenderOptions& options)
{
  contender.Window.reset(); // so that not both are in memory
  contender.Window = std::make_unique<VolumeWindow>(options.Size);
  contender.FirstFrames.push_back(SecondsOf(
    [&]
    {
      const Mapper mapper = MakeMapper(contender.Name, options.Array, 512);
      mapper->SetInputData(grid);
      contender.Window->SetVolume(mapper, scene);
      contender.Window->Render();
    }));
  contender.FirstPicture = contender.Window->Look();
}

void Print(const RenderOptions& options, vtkUnstructuredGrid* grid, std::uint64_t hits,
  const std::vector<Contender>& contenders, const std::vector<Operation>& operations)
{
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      json["size"] = options.Size;
      json["orthographic"] = options.Orthographic;
      json["hits"] = hits;
      json["mappers"] = Json::arrayValue;
      for (std::size_t i = 0; i < contenders.size(); ++i)
      {
        Json::Value mapperJson;
        mapperJson["mapper"] = contenders[i].Name;
        mapperJson["covered"] = contenders[i].FirstPicture.Covered;
        mapperJson["mean"] = contenders[i].FirstPicture.Mean;
        AddList(mapperJson, "firstFrames", contenders[i].FirstFrames);
        AddList(mapperJson, "seconds", operations[i].Seconds);
        mapperJson["gain"] = GetGain(operations[0].Seconds, operations[i].Seconds);
        json["mappers"].append(mapperJson);
      }
    });
}

void TimeRendering(const RenderOptions& options)
{
  const Grid grid = Load(options.File);
  Scene scene = MakeScene(grid, options.Array);
  scene.Orthographic = options.Orthographic;
  vtkNew<vtkCamera> camera;
  scene.SetUp(camera);
  const std::uint64_t hits = CountHits(grid, camera, options.Size);

  const VolumeWindow loadsOpenGL(16);
  std::vector<Contender> contenders;
  for (const std::string& name : options.Mappers)
  {
    contenders.push_back({ name });
  }
  for (int round = 0; round < options.FirstRounds; ++round)
  {
    for (std::size_t i = 0; i < contenders.size(); ++i)
    {
      DrawFirst(contenders[round % 2 == 0 ? i : contenders.size() - 1 - i], grid, scene, options);
    }
  }
  std::vector<Operation> operations;
  for (Contender& contender : contenders)
  {
    operations.push_back({ contender.Name,
      [&contender] { contender.Window->Render(TurnOfPictures * ++contender.Pictures); },
      contender.IsSlow() ? options.SlowRounds : options.Rounds });
  }
  RunInterleaved(operations, options.Rounds);
  Print(options, grid, hits, contenders, operations);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddRender(CLI::App& app)
{
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand(
    "render", "Time of first and later pictures by volume mappers; needs a display");
  command->add_option("FILE", options->File, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->add_flag("--orthographic", options->Orthographic, "Not in perspective");
  command->add_option("--mappers", options->Mappers, "Which, in place of all of them")
    ->delimiter(',')
    ->check(CLI::IsMember(GetMapperNames()));
  command->add_option("--rounds", options->Rounds, "Later pictures")->check(CLI::Range(1, 1000));
  command->add_option("--slow-rounds", options->SlowRounds, "Those by zsweep and projected")
    ->check(CLI::Range(1, 1000));
  command->add_option("--first-rounds", options->FirstRounds, "First pictures, each anew")
    ->check(CLI::Range(1, 1000));
  command->callback([options] { TimeRendering(*options); });
}
}
