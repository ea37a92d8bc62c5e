// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// simplify-surface: triangles are simplified by gatun::BuildMergeTree, to any degree at once, and
// by peers: vtkQuadricDecimation, vtkDecimatePro and meshoptimizer.

#include "benchCases.h"
#include "benchTriangles.h"

#include "gatunParallel.h"
#include "gatunSurfaceMergeBuilder.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDecimatePro.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuadricDecimation.h"

#if BENCH_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <algorithm>
#include <memory>

namespace bench
{
namespace
{
struct SimplifySurfaceOptions
{
  std::string Name;
  std::string Array;
  std::string IsoArray;
  double Value = 0;
  std::size_t Triangles = 200000;
  std::vector<std::string> Ways
  {
    "gatun", "quadric", "shape", "pro"
#if BENCH_HAS_MESHOPTIMIZER
      ,
      "meshopt"
#endif
  };
  std::vector<double> Parts{ 0.5, 0.25, 0.1, 0.02 };
  std::size_t Samples = 50000;
  int Threads = 1;
};

std::vector<std::array<std::uint32_t, 3>> GetCells(vtkPolyData* surface)
{
  std::vector<std::array<std::uint32_t, 3>> cells;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    surface->GetCellPoints(i, size, ids);
    cells.push_back({ static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]),
      static_cast<std::uint32_t>(ids[2]) });
  }
  return cells;
}

/** A surface with some of the triangles of another one, and all of its points. */
Triangles Keep(vtkPolyData* surface, const std::vector<std::array<std::uint32_t, 3>>& cells)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  Triangles result = Triangles::New();
  std::vector<vtkIdType> places(static_cast<std::size_t>(surface->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> kept;
  for (const auto& cell : cells)
  {
    vtkIdType ids[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (places[cell[i]] < 0)
      {
        places[cell[i]] = kept->InsertNextId(cell[i]);
      }
      ids[i] = places[cell[i]];
    }
    polys->InsertNextCell(3, ids);
  }
  points->SetDataType(surface->GetPoints()->GetDataType());
  surface->GetPoints()->GetPoints(kept, points);
  result->SetPoints(points);
  result->SetPolys(polys);
  result->GetPointData()->CopyAllocate(surface->GetPointData(), kept->GetNumberOfIds());
  for (vtkIdType i = 0; i < kept->GetNumberOfIds(); ++i)
  {
    result->GetPointData()->CopyData(surface->GetPointData(), kept->GetId(i), i);
  }
  return result;
}

/** Gatun's way: the order of the merges, and then any number of triangles. */
class Tree
{
public:
  explicit Tree(vtkPolyData* surface)
    : Surface(surface)
    , Points(static_cast<std::size_t>(surface->GetNumberOfPoints()))
    , Cells(GetCells(surface))
  {
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      surface->GetPoint(static_cast<vtkIdType>(i), this->Points[i].data());
    }
    gatun::SurfaceMergeInput input{ this->Points, this->Cells, {} };
    if (vtkDataArray* const array = surface->GetPointData()->GetArray(0))
    {
      const int components = array->GetNumberOfComponents();
      this->Values.resize(static_cast<std::size_t>(components));
      for (int c = 0; c < components; ++c)
      {
        auto& values = this->Values[static_cast<std::size_t>(c)];
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        {
          values.push_back(array->GetComponent(i, c));
        }
        input.Fields.push_back({ values, 1.0 });
      }
    }
    std::vector<Operation> operations{ { "build",
      [&] { this->Merges = gatun::BuildMergeTree(input); } } };
    RunInterleaved(operations, 1);
    this->Seconds = operations[0].Seconds[0];
    this->CpuSeconds =
      operations[0].CpuSeconds.empty() ? this->Seconds : operations[0].CpuSeconds[0];
  }

  Triangles Simplify(std::size_t triangles, double& seconds) const
  {
    std::size_t low = 0; // too many triangles
    std::size_t high = this->Merges.GetMerges().size();
    while (low + 1 < high)
    {
      const std::size_t middle = low + (high - low) / 2;
      (this->Make(middle).size() <= triangles ? high : low) = middle;
    }
    high = this->Merges.CountWholeMerges(high);
    std::vector<std::array<std::uint32_t, 3>> cells;
    seconds = SecondsOf([&] { cells = this->Make(high); });
    this->Error = this->Merges.GetLargestError(high);
    return Keep(this->Surface, cells);
  }

  double Seconds = 0;
  double CpuSeconds = 0;
  mutable double Error = 0;

private:
  std::vector<std::array<std::uint32_t, 3>> Make(std::size_t merges) const
  {
    const auto ancestors = this->Merges.FindAncestors(merges);
    std::vector<std::array<std::uint32_t, 3>> cells;
    for (auto cell : this->Cells)
    {
      for (auto& corner : cell)
      {
        corner = ancestors[corner];
      }
      if (cell[0] != cell[1] && cell[1] != cell[2] && cell[2] != cell[0])
      {
        cells.push_back(cell);
      }
    }
    return cells;
  }

  vtkPolyData* Surface;
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<std::uint32_t, 3>> Cells;
  std::vector<std::vector<double>> Values;
  gatun::MergeTree Merges;
};

Triangles SimplifyByQuadrics(vtkPolyData* surface, double part, bool withFields)
{
  vtkNew<vtkQuadricDecimation> filter;
  filter->SetInputData(surface);
  filter->SetTargetReduction(1 - part);
  filter->SetAttributeErrorMetric(withFields);
  filter->Update();
  Triangles result = filter->GetOutput();
  return result;
}

Triangles SimplifyByDistance(vtkPolyData* surface, double part)
{
  vtkNew<vtkDecimatePro> filter;
  filter->SetInputData(surface);
  filter->SetTargetReduction(1 - part);
  filter->Update();
  Triangles result = filter->GetOutput();
  return result;
}

Triangles SimplifyByMeshoptimizer([[maybe_unused]] vtkPolyData* surface,
  [[maybe_unused]] double part, [[maybe_unused]] double& seconds)
{
#if BENCH_HAS_MESHOPTIMIZER
  const auto cells = GetCells(surface);
  std::vector<unsigned int> indices;
  for (const auto& cell : cells)
  {
    indices.insert(indices.end(), cell.begin(), cell.end());
  }
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  std::vector<float> points(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    double point[3];
    surface->GetPoint(static_cast<vtkIdType>(i), point);
    std::copy(point, point + 3, points.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  std::vector<unsigned int> result(indices.size());
  seconds = SecondsOf(
    [&]
    {
      const auto target = static_cast<std::size_t>(part * static_cast<double>(cells.size())) * 3;
      result.resize(meshopt_simplify(result.data(), indices.data(), indices.size(), points.data(),
        count, 3 * sizeof(float), target, 1e9f, 0, nullptr));
    });
  std::vector<std::array<std::uint32_t, 3>> left;
  for (std::size_t i = 0; i < result.size(); i += 3)
  {
    left.push_back({ result[i], result[i + 1], result[i + 2] });
  }
  return Keep(surface, left);
#else
  throw Failure("meshoptimizer (libmeshoptimizer-dev) was not there when this was built");
#endif
}

Triangles Make(const SimplifySurfaceOptions& options)
{
  if (options.Name.find('.') == std::string::npos)
  {
    return MakeTriangles(options.Name, options.Triangles);
  }
  return LoadTriangles(options.Name, options.Array, options.IsoArray, options.Value);
}

void AddResult(Json::Value& json, const std::string& way, double part, double seconds,
  vtkPolyData* result, const TriangleComparison& comparison)
{
  const TriangleDeviation deviation = comparison.Compare(result);
  Json::Value mesh;
  mesh["way"] = way;
  mesh["part"] = part;
  mesh["seconds"] = seconds;
  mesh["triangles"] = static_cast<std::uint64_t>(result->GetNumberOfCells());
  mesh["hausdorff"] = deviation.Hausdorff;
  mesh["forth"] = deviation.Forth;
  mesh["back"] = deviation.Back;
  mesh["distanceRms"] = deviation.MeanSquare;
  if (deviation.FieldRms >= 0)
  {
    mesh["fieldRms"] = deviation.FieldRms;
  }
  json.append(mesh);
}

void Run(const SimplifySurfaceOptions& options)
{
  const Triangles surface = Make(options);
  const TriangleComparison comparison(
    surface, options.Samples, options.Name.find("torus") != std::string::npos);
  PrintJson(
    [&](Json::Value& json)
    {
      json["surface"] = options.Name;
      json["triangles"] = static_cast<std::uint64_t>(surface->GetNumberOfCells());
      json["points"] = static_cast<std::uint64_t>(surface->GetNumberOfPoints());
      json["meshes"] = Json::arrayValue;
      for (const std::string& way : options.Ways)
      {
        std::unique_ptr<Tree> tree;
        if (way == "gatun")
        {
          gatun::WithNumberOfThreads(
            options.Threads, [&] { tree = std::make_unique<Tree>(surface); });
          json["buildSeconds"] = tree->Seconds;
          json["buildCpuSeconds"] = tree->CpuSeconds;
          json["rate"] = 1e-6 * static_cast<double>(surface->GetNumberOfCells()) / tree->Seconds;
        }
        for (const double part : options.Parts)
        {
          Triangles result;
          double inner = -1;
          const double seconds = SecondsOf(
            [&]
            {
              const auto triangles =
                static_cast<std::size_t>(part * static_cast<double>(surface->GetNumberOfCells()));
              result = way == "gatun" ? tree->Simplify(triangles, inner)
                : way == "meshopt"    ? SimplifyByMeshoptimizer(surface, part, inner)
                : way == "pro"        ? SimplifyByDistance(surface, part)
                                      : SimplifyByQuadrics(surface, part, way == "quadric");
            });
          AddResult(json["meshes"], way, part, inner < 0 ? seconds : inner, result, comparison);
          if (tree)
          {
            json["meshes"][json["meshes"].size() - 1]["estimate"] = tree->Error;
          }
        }
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSimplifySurface(CLI::App& app)
{
  auto options = std::make_shared<SimplifySurfaceOptions>();
  CLI::App* command = app.add_subcommand("simplify-surface",
    "Triangles simplified by Gatun and by peers: time, two-sided Hausdorff distance, field RMS");
  command
    ->add_option("NAME", options->Name,
      "sphere, terrain, torus, or a file: .vtp, .vtu (its boundary), or any with an isovalue")
    ->required();
  command->add_option("--triangles", options->Triangles, "About how many, of those that are made");
  command->add_option("--array", options->Array, "The point array that counts, of a file");
  command->add_option("--iso-array", options->IsoArray, "The array of an isosurface");
  command->add_option("--value", options->Value, "The isovalue");
  command
    ->add_option("--ways", options->Ways,
      "gatun; quadric: vtkQuadricDecimation with the field; shape: without; pro: vtkDecimatePro; "
      "meshopt")
    ->delimiter(',');
  command->add_option("--parts", options->Parts, "Parts of the triangles")->delimiter(',');
  command->add_option("--samples", options->Samples, "Places on each surface, besides its points");
  command->add_option("--threads", options->Threads, "Of Gatun")->check(CLI::Range(1, 1024));
  command->callback([options] { Run(*options); });
}
}
