// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// simplify-picture: pictures of simplified meshes next to that of the one that they were made of,
// as volumes; and how long the drawing takes, with samples all along the rays, and with one a
// tetrahedron.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchPixels.h"
#include "benchScene.h"

#include "vtkGatunRayCaster.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace bench
{
namespace
{

struct SimplifyPictureOptions
{
  std::vector<std::string> Files;
  std::string Array = "Density";
  std::vector<std::string> Out;
  std::vector<int> Sizes{ 512 };
  int Rounds = 1;
  double Turn = 0;
};

/** Draws a mesh by a scene, which is always that of the first one. */
void Draw(vtkUnstructuredGrid* grid, const Scene& scene, const SimplifyPictureOptions& options,
  int size, vtkGatunRayCaster::BlendModes mode, Pixels& pixels)
{
  vtkNew<vtkCamera> camera;
  vtkNew<vtkVolumeProperty> property;
  scene.SetUp(camera, options.Turn);
  scene.SetUp(property);
  vtkNew<vtkGatunRayCaster> caster;
  caster->SetInputData(grid);
  caster->SetCamera(camera);
  caster->SetProperty(property);
  caster->SetArrayName(options.Array.c_str());
  caster->SetSize(size, size);
  caster->SetMemoryBudget(0);
  caster->SetBlendMode(mode);
  caster->Update();
  if (caster->GetErrorCode() != 0)
  {
    throw Failure("a mesh cannot be drawn");
  }
  auto* const values =
    vtkFloatArray::SafeDownCast(caster->GetOutput()->GetPointData()->GetScalars());
  pixels.assign(values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues());
}

struct Difference
{
  double Rms = 0; ///< of the colors, where either picture shows anything, on black
  double Largest = 0;
  double Covered = 0; ///< share of the pixels
};

Difference Compare(const Pixels& a, const Pixels& b)
{
  Difference difference;
  double sum = 0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < a.size(); i += 4)
  {
    if (a[i + 3] > 0 || b[i + 3] > 0)
    {
      ++covered;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double error =
          std::abs(static_cast<double>(a[i + c]) - static_cast<double>(b[i + c]));
        sum += error * error;
        difference.Largest = std::max(difference.Largest, error);
      }
    }
  }
  difference.Rms = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, 3 * covered)));
  difference.Covered = static_cast<double>(covered) / (static_cast<double>(a.size()) / 4);
  return difference;
}

void ComparePictures(const SimplifyPictureOptions& options)
{
  std::vector<Grid> grids;
  for (const auto& file : options.Files)
  {
    grids.push_back(KeepPointArray(Load(file), options.Array));
  }
  const Scene scene = MakeScene(grids.front(), options.Array);
  PrintJson(
    [&](Json::Value& json)
    {
      json["sizes"] = Json::arrayValue;
      for (const int size : options.Sizes)
      {
        std::vector<Pixels> pictures(grids.size());
        std::vector<Operation> operations;
        for (std::size_t i = 0; i < grids.size(); ++i)
        {
          operations.push_back({ "volume", [&, i] {
                                  Draw(grids[i], scene, options, size,
                                    vtkGatunRayCaster::COMPOSITE_BLEND, pictures[i]);
                                } });
        }
        RunInterleaved(operations, options.Rounds);
        Json::Value sizeJson;
        sizeJson["size"] = size;
        sizeJson["meshes"] = Json::arrayValue;
        for (std::size_t i = 0; i < grids.size(); ++i)
        {
          const Difference difference = Compare(pictures[0], pictures[i]);
          Json::Value meshJson;
          meshJson["tets"] = static_cast<std::uint64_t>(grids[i]->GetNumberOfCells());
          meshJson["rms"] = difference.Rms;
          meshJson["largest"] = difference.Largest;
          meshJson["covered"] = difference.Covered;
          AddList(meshJson, "volumeSeconds", operations[i].Seconds);
          sizeJson["meshes"].append(meshJson);
          if (i < options.Out.size() && size == options.Sizes.front())
          {
            WritePicture(pictures[i], size, options.Out[i]);
          }
        }
        json["sizes"].append(sizeJson);
      }
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddSimplifyPicture(CLI::App& app)
{
  auto options = std::make_shared<SimplifyPictureOptions>();
  CLI::App* command = app.add_subcommand("simplify-picture",
    "Pictures of meshes by vtkGatunRayCaster, and how far they are from that of the first mesh");
  command->add_option("FILES", options->Files, "Meshes, .gtn or .vtu")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Sizes, "Widths and heights in pixels")
    ->delimiter(',')
    ->check(CLI::Range(16, 8192));
  command->add_option("--turn", options->Turn, "Degrees that the camera goes around the mesh");
  command->add_option("--rounds", options->Rounds, "How often")->check(CLI::Range(1, 1000));
  command->add_option("--out", options->Out, "Where the pictures of the first size go, .png");
  command->callback([options] { ComparePictures(*options); });
}
}
