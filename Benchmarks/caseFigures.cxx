// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Figures 13, 14 and 17 to 19 of the dissertation. fly: from a file to an image without a window,
// chunk by chunk, or from a mesh that is decompressed (and simplified) as a whole before.
// simplified: time and error of images by the ratio of simplification.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchScene.h"

#include "gatunCoarseRaySource.h"
#include "gatunFileRaySource.h"
#include "gatunMergeTree.h"
#include "gatunParallel.h"
#include "gatunRayCaster.h"
#include "gatunSharedFile.h"
#include "vtkGatunDetailPolicy.h"
#include "vtkGatunRayCaster.h"
#include "vtkGatunReader.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace bench
{
namespace
{
struct FigureOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 256;
  double Ratio = 0;
  std::vector<double> Ratios{ 0, 0.5, 0.75, 0.9, 0.98 };
  bool Whole = false;
  int Rounds = 3;
};

std::size_t CountMerges(double ratio, std::uint64_t points, std::uint64_t merges)
{
  return std::min(
    merges, static_cast<std::uint64_t>(std::llround(ratio * static_cast<double>(points))));
}

void DrawByCaster(vtkGatunRayCaster* caster, const Scene& scene, const FigureOptions& options)
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

/** The tetrahedra that are left after so many merges. The points of the grid are those of the file
 * in its order. */
void SimplifyCells(vtkUnstructuredGrid* grid, const FigureOptions& options)
{
  const gatun::MergeTree tree = gatun::FileReader(options.File).GetMergeTree();
  const auto ancestors = tree.FindAncestors(
    CountMerges(options.Ratio, tree.GetNumberOfPoints(), tree.GetMerges().size()));
  vtkNew<vtkCellArray> left;
  left->AllocateExact(grid->GetNumberOfCells(), 4 * grid->GetNumberOfCells());
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(i, count, ids);
    gatun::MergeTree::Tet tet{};
    std::transform(
      ids, ids + 4, tet.begin(), [](vtkIdType id) { return static_cast<std::uint32_t>(id); });
    if (gatun::Simplify(tet, ancestors))
    {
      left->InsertNextCell({ tet[0], tet[1], tet[2], tet[3] });
    }
  }
  grid->SetCells(VTK_TETRA, left);
}

/** The generic method of the dissertation. Nothing is kept of what the reader decodes but the grid.
 */
void DrawWhole(vtkGatunRayCaster* caster, const FigureOptions& options)
{
  Grid grid;
  if (options.File.ends_with(".gtn"))
  {
    vtkNew<vtkGatunReader> reader;
    reader->SetMemoryBudget(0);
    reader->SetFileName(options.File.c_str());
    reader->RestoreOrderOff();
    reader->Update();
    grid = reader->GetOutput();
  }
  else
  {
    grid = Load(options.File);
  }
  if (options.Ratio > 0)
  {
    SimplifyCells(grid, options);
  }
  caster->SetInputData(grid);
  DrawByCaster(caster, MakeScene(grid, options.Array), options);
}

void DrawFile(vtkGatunRayCaster* caster, const FigureOptions& options)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetMemoryBudget(0);
  reader->SetFileName(options.File.c_str());
  caster->SetInputConnection(reader->GetOutputPort());
  caster->GetDetailPolicy()->SetSimplificationRatio(options.Ratio);
  DrawByCaster(caster, MakeScene(gatun::FileReader(options.File), options.Array), options);
}

/** The mean opacity of an image, so that an empty one does not pass for a fast one. */
double GetMeanOpacity(vtkImageData* image)
{
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  double sum = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    sum += pixels->GetComponent(i, 3);
  }
  if (sum <= 0)
  {
    throw Failure("an image is empty");
  }
  return sum / static_cast<double>(pixels->GetNumberOfTuples());
}

void MeasureFly(const FigureOptions& options)
{
  vtkNew<vtkGatunRayCaster> caster;
  const Cost cost =
    CostOf([&] { options.Whole ? DrawWhole(caster, options) : DrawFile(caster, options); });
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      AddCost(json, cost);
      json["tets"] = caster->GetStatistics()->GetValueByName(0, "DrawnTetrahedra").ToDouble();
      json["mean"] = GetMeanOpacity(caster->GetOutput());
    });
}

/** One image of a simplified mesh, and the seconds of drawing, without decoding. */
struct SimplifiedImage
{
  std::vector<float> Pixels;
  std::vector<double> Seconds;
  std::uint64_t Tets = 0;
};

void DrawSimplified(SimplifiedImage& image, const std::shared_ptr<const gatun::FileReader>& file,
  double ratio, gatun::RayMode mode, const FigureOptions& options)
{
  const gatun::RayValues values{ FindPointArray(*file, options.Array), 0, 0 };
  const Scene scene = MakeScene(*file, options.Array);
  const gatun::RayView view = scene.MakeView(options.Size);
  gatun::RayCaster caster(view, scene.MakeTable(view, mode));
  if (ratio > 0)
  {
    gatun::SharedFile meshes(file);
    const auto place =
      meshes.Find(CountMerges(ratio, file->GetNumberOfPoints(), file->GetNumberOfMerges()));
    gatun::CoarseRaySource source(meshes.MakeView(place.File, false), *place.Tree,
      gatun::MergeCut(*place.Tree, place.Merges), values);
    caster.Draw(source);
  }
  else
  {
    gatun::FileRaySource source(file, values, 0);
    caster.Draw(source);
  }
  image.Pixels.resize(4 * static_cast<std::size_t>(options.Size * options.Size));
  caster.Finish(image.Pixels.data());
  const gatun::RayStatistics known = caster.GetStatistics();
  image.Tets = known.Tets;
  image.Seconds.push_back(known.OrderTime + known.SetUpTime + known.DrawTime + known.FinishTime);
}

/** The root mean square difference of the colors, where either image shows anything. */
double GetDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); i += 4)
  {
    if (a[i + 3] > 0 || b[i + 3] > 0)
    {
      ++count;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double error = static_cast<double>(a[i + c]) - static_cast<double>(b[i + c]);
        sum += error * error;
      }
    }
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, 3 * count)));
}

void MeasureSimplified(const FigureOptions& options)
{
  const auto file = std::make_shared<const gatun::FileReader>(options.File);
  std::vector<std::array<SimplifiedImage, 2>> images(options.Ratios.size());
  std::vector<Operation> operations;
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    for (const auto mode : { gatun::RayMode::Composite, gatun::RayMode::Sampled })
    {
      SimplifiedImage& image = images[i][mode == gatun::RayMode::Composite ? 0 : 1];
      operations.push_back({ "image",
        [&, i, mode] { DrawSimplified(image, file, options.Ratios[i], mode, options); } });
    }
  }
  RunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["ratios"] = Json::arrayValue;
      for (std::size_t i = 0; i < images.size(); ++i)
      {
        Json::Value entry;
        entry["ratio"] = options.Ratios[i];
        entry["tets"] = images[i][0].Tets;
        entry["rms"] = GetDifference(images[0][0].Pixels, images[i][0].Pixels);
        AddList(entry, "integral", images[i][0].Seconds);
        AddList(entry, "samples", images[i][1].Seconds);
        json["ratios"].append(entry);
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddFigures(CLI::App& app)
{
  auto options = std::make_shared<FigureOptions>();
  const auto add = [&](const char* name, const char* about, void (*run)(const FigureOptions&))
  {
    CLI::App* command = app.add_subcommand(name, about);
    command->add_option("FILE", options->File, "A .gtn file; with --whole also a .vtu file")
      ->required();
    command->add_option("--array", options->Array, "The point array to show");
    command->add_option("--size", options->Size, "Width and height in pixels")
      ->check(CLI::Range(16, 8192));
    command->callback([options, run] { run(*options); });
    return command;
  };
  CLI::App* fly =
    add("fly", "Time and memory from a file to an image by vtkGatunRayCaster", MeasureFly);
  fly->add_flag("--whole", options->Whole, "Decompress the whole mesh first");
  fly->add_option("--ratio", options->Ratio, "Part of the points to merge away; needs a hierarchy")
    ->check(CLI::Range(0.0, 1.0));
  CLI::App* simplified =
    add("simplified", "Time and error of images of simplified meshes, by integrals and by samples",
      MeasureSimplified);
  simplified->add_option("--ratios", options->Ratios, "Parts of the points; the first should be 0")
    ->delimiter(',');
  simplified->add_option("--rounds", options->Rounds)->check(CLI::Range(1, 1000));
}
}
