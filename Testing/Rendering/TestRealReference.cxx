// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Real meshes, from all sides and from within: pictures against the slow reference.

#include "gatunMemoryRaySource.h"
#include "gatunRayCaster.h"
#include "gatunRayReference.h"

#include "vtkDataArray.h"
#include "vtkDelaunay3D.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

using namespace gatun;
using namespace gatun::test;

namespace
{

constexpr int Skipped = 125;

std::array<double, 4> Color(double s)
{
  return { s, 1 - std::abs(2 * s - 1), 1 - s, s < 0.25 ? 0 : (s - 0.25) * 0.6 };
}

/** The first point array of a grid, from 0 to 1. */
ReferenceMesh ToReference(vtkUnstructuredGrid* grid)
{
  vtkDataArray* const values = grid->GetPointData()->GetArray(0);
  ReferenceMesh mesh;
  double range[2];
  values->GetRange(range, 0);
  const double width = range[1] > range[0] ? range[1] - range[0] : 1;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Vec& point = mesh.Points.emplace_back();
    grid->GetPoint(i, point.data());
    mesh.Values.push_back((values->GetComponent(i, 0) - range[0]) / width);
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(i, count, ids);
    auto& tet = mesh.Tets.emplace_back();
    std::transform(
      ids, ids + 4, tet.begin(), [](vtkIdType id) { return static_cast<std::uint32_t>(id); });
  }
  return mesh;
}

ReferenceMesh Read(const std::string& file)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return ToReference(reader->GetOutput());
}

/** Random points in a ball. */
ReferenceMesh MakeDelaunay()
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(-1, 1);
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> values;
  while (points->GetNumberOfPoints() < 4000)
  {
    const Vec p{ any(random), any(random), any(random) };
    if (Dot(p, p) < 1)
    {
      points->InsertNextPoint(p.data());
      values->InsertNextValue(std::sin(4 * p[0]) * std::cos(3 * p[1]) + p[2]);
    }
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->AddArray(values);
  vtkNew<vtkDelaunay3D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  return ToReference(delaunay->GetOutput());
}

/** Pixels that differ, and by how much all do on average. */
struct Difference
{
  std::size_t Pixels = 0;
  std::size_t Bad = 0;
  double Most = 0;
  double Sum = 0;
};

void Compare(const ReferenceMesh& mesh, RaySource& source, const Viewer& viewer, double unit,
  Difference& difference)
{
  Reference reference;
  reference.Color = Color;
  reference.Breaks = { 0.25, 0.5 };
  reference.Unit = unit;
  const auto expected = reference.Render(mesh, viewer);
  RayCaster caster(
    viewer.GetView(), RayTable(RayMode::Composite, Color, { 0, 1 }, viewer.SampleDistance, unit));
  caster.Draw(source);
  std::vector<float> colors(4 * expected.size());
  caster.Finish(colors.data());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    double most = 0;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const double d = std::abs(colors[4 * i + c] - expected[i][c]);
      most = std::max(most, d);
      difference.Sum += d / 4;
    }
    difference.Bad += most <= 1.5 / 255 ? 0 : 1;
    difference.Most = std::max(difference.Most, most);
  }
  difference.Pixels += expected.size();
}

bool IsRight(const std::string& name, const ReferenceMesh& mesh)
{
  Vec low = mesh.Points[0];
  Vec high = low;
  for (const Vec& p : mesh.Points)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  const double size = std::sqrt(Dot(high - low, high - low));
  MeshInput input;
  input.Points = mesh.Points.size();
  input.CoordinateType = ScalarType::Float64;
  input.Coordinates = mesh.Points.data();
  input.Cells = mesh.Tets.size();
  input.Connectivity = mesh.Tets.data();
  input.WideIds = false;
  MemoryRaySource source(input,
    { Association::Point, ScalarType::Float64, 1, 0, mesh.Values.data() }, nullptr,
    std::uint64_t{ 1 } << 30, 8192);

  bool right = true;
  for (const bool parallel : { false, true })
  {
    Difference difference;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 10; ++i)
    {
      const Vec direction = i < 3 ? Vec{ i == 0 ? 1.0 : 0, i == 1 ? 1.0 : 0, i == 2 ? 1.0 : 0 }
                                  : Vec{ any(random), any(random), any(random) };
      const Vec middle = 0.5 * (low + high);
      const double away = i % 4 == 3 ? 0.1 : 1.5; // now and then from within
      auto viewer =
        Viewer::LookAt(middle + away * size * Normalize(direction), middle, parallel, 0.8 * size);
      viewer.SampleDistance = size / 200;
      Compare(mesh, source, viewer, size / 20, difference);
    }
    const auto pixels = static_cast<double>(difference.Pixels);
    std::cout << name << (parallel ? ", parallel: " : ", perspective: ") << difference.Bad << " of "
              << difference.Pixels << " pixels differ, mean difference " << difference.Sum / pixels
              << ", largest " << difference.Most << std::endl;
    right = right && difference.Bad == 0 && difference.Sum <= 0.05 / 255 * pixels;
  }
  return right;
}

} // anonymous namespace

//------------------------------------------------------------------------------
int TestRealReference(int, char*[])
{
  const char* const folder = std::getenv("GATUN_DATA_DIR");
  if (!folder)
  {
    std::cout << "GATUN_DATA_DIR is not set: there are no meshes to look at.\n";
    return Skipped;
  }
  bool right = IsRight("Delaunay", MakeDelaunay());
  for (const std::string name : { "bluntfin_tets", "comb_tets", "kiefer_bracket_tets" })
  {
    right = IsRight(name, Read(std::string(folder) + "/" + name + ".vtu")) && right;
  }
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
