// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The mesh that TetGen makes, where the project is built with it.

#include "benchMeshes.h"

#include "benchHarness.h"

#if BENCH_HAS_TETGEN
#include "vtkGatunTetrahedralize.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>
#endif

namespace bench
{
#if BENCH_HAS_TETGEN
namespace
{

using Point = std::array<double, 3>;
using Triangle = std::array<vtkIdType, 3>;

/** The unit sphere: an octahedron, each triangle of it cut into squares * squares small ones. */
vtkSmartPointer<vtkPolyData> MakeSphere(int squares)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> triangles;
  std::map<std::array<int, 3>, vtkIdType> known; // points are in two triangles and more
  const auto id = [&](const std::array<int, 3>& at)
  {
    const auto [place, isNew] = known.try_emplace(at, points->GetNumberOfPoints());
    if (isNew)
    {
      // Evenly spaced angles rather than lengths, so that the triangles are of much the same size.
      Point p;
      double square = 0;
      for (unsigned c = 0; c < 3; ++c)
      {
        p[c] = std::sin(1.5707963267948966 * at[c] / squares);
        square += p[c] * p[c];
      }
      const double length = std::sqrt(square);
      points->InsertNextPoint(p[0] / length, p[1] / length, p[2] / length);
    }
    return place->second;
  };
  for (int octant = 0; octant < 8; ++octant)
  {
    const auto at = [&](int i, int j)
    {
      return id({ octant & 1 ? -i : i, octant & 2 ? -j : j,
        octant & 4 ? i + j - squares : squares - i - j });
    };
    for (int i = 0; i < squares; ++i)
    {
      for (int j = 0; i + j < squares; ++j)
      {
        triangles->InsertNextCell({ at(i, j), at(i + 1, j), at(i, j + 1) });
        if (i + j + 1 < squares)
        {
          triangles->InsertNextCell({ at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
        }
      }
    }
  }
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->SetPoints(points);
  sphere->SetPolys(triangles);
  return sphere;
}

double Field(const double* p)
{
  const double x = p[0] - 0.2;
  const double y = p[1] + 0.1;
  const double square = x * x + y * y + p[2] * p[2];
  return 0.9 * std::exp(-2.5 * square) +
    0.3 * std::sin(4 * p[0] + 1) * std::cos(5 * p[1] - 3 * p[2]);
}

} // anonymous namespace

//------------------------------------------------------------------------------
bool HasDelaunay()
{
  return true;
}

//------------------------------------------------------------------------------
Grid MakeDelaunay(int tets)
{
  // The mean tetrahedron has about 0.4 of the largest volume allowed.
  const double volume = 4.18879 / tets;
  // Edges on the sphere about as long as those inside.
  const double edge = std::cbrt(volume * 8.5);
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputData(MakeSphere(std::max(2, static_cast<int>(1.5707963 / edge))));
  mesher->SetMaximumVolume(volume / 0.415);
  mesher->SetQuality(2); // TetGen's own default, with the fewest points for the tetrahedra
  mesher->Update();
  Grid grid = mesher->GetOutput();
  if (grid->GetNumberOfCells() == 0)
  {
    throw Failure("TetGen made nothing");
  }
  vtkNew<vtkFloatArray> density;
  density->SetName("Density");
  density->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    density->SetValue(i, static_cast<float>(Field(grid->GetPoint(i))));
  }
  grid->GetPointData()->AddArray(density);
  return grid;
}
#else
//------------------------------------------------------------------------------
bool HasDelaunay()
{
  return false;
}

//------------------------------------------------------------------------------
Grid MakeDelaunay(int)
{
  throw Failure("built without TetGen");
}
#endif
}
