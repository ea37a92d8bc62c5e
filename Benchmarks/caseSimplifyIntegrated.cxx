// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// simplify-integrated: from a file with a hierarchy to the picture of a simplified mesh; chunk by
// chunk, or decompressing the mesh, simplifying it, and drawing what is left, one after the other.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchHarness.h"
#include "benchScene.h"

#include "gatunCoarseRaySource.h"
#include "gatunFileReader.h"
#include "gatunMergeCut.h"
#include "gatunMergeTree.h"
#include "gatunSimplifiedFile.h"
#include "gatunSimplifyTarget.h"
#include "vtkGatunRayCaster.h"
#include "vtkGatunReader.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace bench
{
namespace
{
struct SimplifyIntegratedOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  double Ratio = 0.5;
  bool Whole = false;
};

/** Seconds of the parts of the work, where there are parts. */
struct Stages
{
  double Decompress = 0;
  double Simplify = 0;
  double Render = 0;
};

double Draw(vtkGatunRayCaster* caster, const SimplifyIntegratedOptions& options)
{
  const Scene scene = MakeScene(gatun::FileReader(options.File), options.Array);
  vtkNew<vtkCamera> camera;
  vtkNew<vtkVolumeProperty> property;
  scene.SetUp(camera);
  scene.SetUp(property);
  caster->SetCamera(camera);
  caster->SetProperty(property);
  caster->SetArrayName(options.Array.c_str());
  caster->SetSize(options.Size, options.Size);
  caster->SetMemoryBudget(0);
  const double seconds = SecondsOf([&] { caster->Update(); });
  if (caster->GetErrorCode() != 0)
  {
    throw Failure(options.File, "cannot be drawn");
  }
  return seconds;
}

template <typename Id>
vtkSmartPointer<vtkTypeInt64Array> SimplifyCells(
  const Id* ids, vtkIdType tets, const std::vector<std::uint32_t>& ancestors)
{
  auto left = vtkSmartPointer<vtkTypeInt64Array>::New();
  left->SetNumberOfValues(4 * tets);
  vtkTypeInt64* next = left->GetPointer(0);
  for (vtkIdType i = 0; i < tets; ++i, ids += 4)
  {
    gatun::MergeTree::Tet tet{};
    std::transform(ids, ids + 4, tet.begin(), [](Id id) { return static_cast<std::uint32_t>(id); });
    if (gatun::Simplify(tet, ancestors))
    {
      next = std::copy(tet.begin(), tet.end(), next);
    }
  }
  left->Resize(next - left->GetPointer(0));
  return left;
}

/** The reader's points are those of the file in its order, so that its tree is theirs. */
Grid Simplify(vtkUnstructuredGrid* grid, const SimplifyIntegratedOptions& options)
{
  const gatun::MergeTree tree = gatun::FileReader(options.File).GetMergeTree();
  const auto ancestors =
    tree.FindAncestors(gatun::CountMerges({ gatun::SimplifyTarget::Ratio, options.Ratio },
      tree.GetNumberOfPoints(), tree.GetMerges().size(), {}));
  vtkCellArray* const cells = grid->GetCells();
  const vtkIdType tets = cells->GetNumberOfCells();
  const auto left = cells->IsStorage64Bit()
    ? SimplifyCells(cells->GetConnectivityArray64()->GetPointer(0), tets, ancestors)
    : SimplifyCells(cells->GetConnectivityArray32()->GetPointer(0), tets, ancestors);
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(left->GetNumberOfValues() / 4 + 1);
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->SetValue(i, 4 * i);
  }
  vtkNew<vtkCellArray> simpleCells;
  simpleCells->SetData(offsets, left);
  auto simple = Grid::New();
  simple->SetPoints(grid->GetPoints());
  simple->SetCells(VTK_TETRA, simpleCells);
  simple->GetPointData()->ShallowCopy(grid->GetPointData());
  return simple;
}

Stages DrawWhole(vtkGatunRayCaster* caster, const SimplifyIntegratedOptions& options)
{
  Stages stages;
  Grid grid;
  stages.Decompress = SecondsOf(
    [&]
    {
      vtkNew<vtkGatunReader> reader;
      reader->SetMemoryBudget(0);
      reader->SetFileName(options.File.c_str());
      reader->RestoreOrderOff();
      reader->Update();
      if (reader->GetErrorCode() != 0)
      {
        throw Failure(options.File, "cannot be read");
      }
      grid = reader->GetOutput();
    });
  stages.Simplify = SecondsOf([&] { grid = Simplify(grid, options); });
  caster->SetInputData(grid);
  stages.Render = Draw(caster, options);
  return stages;
}

void DrawFile(vtkGatunRayCaster* caster, const SimplifyIntegratedOptions& options)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetMemoryBudget(0);
  reader->SetFileName(options.File.c_str());
  caster->SetInputConnection(reader->GetOutputPort());
  caster->SetSimplificationRatio(options.Ratio);
  Draw(caster, options);
}

/** The seconds in which the merges of a simplified mesh are read and distributed to chunks. */
double TimeMerges(const SimplifyIntegratedOptions& options)
{
  const auto file = std::make_shared<gatun::FileReader>(options.File);
  const auto merges = gatun::CountMerges({ gatun::SimplifyTarget::Ratio, options.Ratio },
    file->GetNumberOfPoints(), file->GetNumberOfMerges(), {});
  const gatun::RayValues values{ FindPointArray(*file, options.Array), 0, 0 };
  return SecondsOf(
    [&]
    {
      gatun::SimplifiedFile meshes(file);
      const auto place = meshes.Find(merges);
      if (place.Merges > 0)
      {
        const gatun::CoarseRaySource source(
          place.File, *place.Tree, gatun::MergeCut(*place.Tree, place.Merges), values, 0);
      }
    });
}

void TimePicture(const SimplifyIntegratedOptions& options)
{
  vtkNew<vtkGatunRayCaster> caster;
  Stages stages;
  const Cost cost = CostOf(
    [&]
    {
      if (options.Whole)
      {
        stages = DrawWhole(caster, options);
      }
      else
      {
        DrawFile(caster, options);
      }
    });
  const auto tets = caster->GetStatistic(vtkGatunRayCaster::NumberOfTetrahedra);
  PrintJson(
    [&](Json::Value& json)
    {
      json["ratio"] = options.Ratio;
      json["whole"] = options.Whole;
      AddCost(json, cost);
      json["tets"] = tets;
      if (options.Whole)
      {
        json["decompress"] = stages.Decompress;
        json["simplify"] = stages.Simplify;
        json["render"] = stages.Render;
      }
      else
      {
        json["simplify"] =
          caster->GetStatistic(vtkGatunRayCaster::SimplifyTime) + TimeMerges(options);
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSimplifyIntegrated(CLI::App& app)
{
  auto options = std::make_shared<SimplifyIntegratedOptions>();
  CLI::App* command = app.add_subcommand(
    "simplify-integrated", "The picture of a simplified mesh, straight from its file");
  command->add_option("FILE", options->File, "A .gtn file with a hierarchy")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->add_option("--ratio", options->Ratio, "Part of the points to merge away")
    ->check(CLI::Range(0., 1.));
  command->add_flag(
    "--whole", options->Whole, "Decompress, simplify, and draw, one after the other");
  command->callback([options] { TimePicture(*options); });
}
}
