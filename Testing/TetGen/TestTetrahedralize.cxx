// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes of surfaces whose volume is known: the volume is right, every tetrahedron has a positive
// one, the surface is kept, and the properties do what they say.

#include "vtkGatunTetrahedralize.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTetra.h"
#include "vtkTimerLog.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <set>
#include <string>

namespace
{

struct Corners
{
  double P[4][3];
};

Corners CornersOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  Corners corners;
  vtkIdType size;
  const vtkIdType* ids;
  grid->GetCells()->GetCellAtId(cell, size, ids);
  for (int i = 0; i < 4; ++i)
  {
    grid->GetPoint(ids[i], corners.P[i]);
  }
  return corners;
}

double VolumeOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  Corners c = CornersOf(grid, cell);
  return vtkTetra::ComputeVolume(c.P[0], c.P[1], c.P[2], c.P[3]);
}

double TotalVolume(vtkUnstructuredGrid* grid)
{
  double sum = 0;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    sum += VolumeOf(grid, i);
  }
  return sum;
}

bool Check(bool good, const std::string& what)
{
  if (!good)
  {
    std::cerr << "not so: " << what << "\n";
  }
  return good;
}

bool CheckNear(double value, double expected, const std::string& what)
{
  return Check(std::abs(value - expected) <= 1e-6 * std::abs(expected),
    what + " is " + std::to_string(expected) + ", not " + std::to_string(value));
}

bool CheckAllPositive(vtkUnstructuredGrid* grid)
{
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (grid->GetCellType(i) != VTK_TETRA || !(VolumeOf(grid, i) > 0))
    {
      return Check(false, "every cell is a tetrahedron of positive volume");
    }
  }
  return Check(grid->GetNumberOfCells() > 0, "there are cells");
}

vtkSmartPointer<vtkPolyData> Cube(double size)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(size);
  cube->SetYLength(size);
  cube->SetZLength(size);
  cube->Update();
  return cube->GetOutput();
}

vtkSmartPointer<vtkPolyData> Sphere(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(sphere->GetOutputPort());
  clean->Update();
  return clean->GetOutput();
}

double VolumeInside(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  return mass->GetVolume();
}

bool TestCube()
{
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputData(Cube(2));
  mesher->Update();
  vtkUnstructuredGrid* grid = mesher->GetOutput();
  if (!CheckAllPositive(grid) || !CheckNear(TotalVolume(grid), 8, "the cube's volume"))
  {
    return false;
  }

  const vtkIdType coarse = grid->GetNumberOfCells();
  mesher->SetMaximumVolume(0.01);
  mesher->Update();
  // TetGen moves points after it has divided the cells that are too large.
  vtkIdType large = 0;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    large += VolumeOf(grid, i) > 0.01 ? 1 : 0;
    if (VolumeOf(grid, i) > 0.015)
    {
      return Check(false, "no cell is much larger than allowed");
    }
  }
  if (100 * large > grid->GetNumberOfCells())
  {
    return Check(false, "nearly all cells are as small as asked for");
  }
  const double* bounds = grid->GetBounds();
  return Check(grid->GetNumberOfCells() > coarse, "a volume limit makes more cells") &&
    CheckAllPositive(grid) && CheckNear(TotalVolume(grid), 8, "the fine cube's volume") &&
    Check(std::all_of(bounds, bounds + 6, [](double b) { return std::abs(b) == 1; }),
      "the cube keeps its bounds");
}

bool TestSphere()
{
  vtkSmartPointer<vtkPolyData> sphere = Sphere(1.5);
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputData(sphere);
  mesher->SetQuality(1.3);
  mesher->SetMinDihedral(12);
  mesher->Update();
  vtkUnstructuredGrid* grid = mesher->GetOutput();
  const double volume = TotalVolume(grid);
  return CheckAllPositive(grid) && CheckNear(volume, VolumeInside(sphere), "the volume inside") &&
    Check(volume < 4. / 3 * vtkMath::Pi() * std::pow(1.5, 3), "a ball is larger");
}

using Triangle = std::array<std::array<double, 3>, 3>;

std::set<Triangle> TrianglesOf(vtkPolyData* surface)
{
  std::set<Triangle> triangles;
  vtkIdType size;
  const vtkIdType* ids;
  for (surface->GetPolys()->InitTraversal(); surface->GetPolys()->GetNextCell(size, ids);)
  {
    Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(ids[i], triangle[i].data());
    }
    std::sort(triangle.begin(), triangle.end());
    triangles.insert(triangle);
  }
  return triangles;
}

bool TestSurfaceKept()
{
  vtkSmartPointer<vtkPolyData> sphere = Sphere(1);
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputData(sphere);
  mesher->SetMaximumVolume(0.003);
  mesher->PreserveSurfaceOn();
  mesher->Update();
  vtkNew<vtkDataSetSurfaceFilter> skin;
  skin->SetInputConnection(mesher->GetOutputPort());
  skin->Update();
  if (!Check(TrianglesOf(skin->GetOutput()) == TrianglesOf(sphere), "the same triangles outside"))
  {
    return false;
  }

  // Otherwise the surface's points remain, as the first of the mesh.
  mesher->PreserveSurfaceOff();
  mesher->Update();
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    sphere->GetPoint(i, a);
    mesher->GetOutput()->GetPoint(i, b);
    if (!std::equal(a, a + 3, b))
    {
      return Check(false, "the surface's points come first, unchanged");
    }
  }
  return true;
}

// A ball in a cavity in a cube.
bool TestCavity()
{
  vtkSmartPointer<vtkPolyData> cavity = Sphere(0.8);
  vtkSmartPointer<vtkPolyData> ball = Sphere(0.4);
  vtkNew<vtkAppendPolyData> all;
  all->AddInputData(Cube(2));
  all->AddInputData(cavity);
  all->AddInputData(ball);
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputConnection(all->GetOutputPort());
  mesher->Update();
  return CheckAllPositive(mesher->GetOutput()) &&
    CheckNear(TotalVolume(mesher->GetOutput()), 8 - VolumeInside(cavity) + VolumeInside(ball),
      "the volume of a ball in a cavity");
}

bool TestPrecision()
{
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputData(Cube(1));
  mesher->Update();
  if (!Check(mesher->GetOutput()->GetPoints()->GetDataType() == VTK_FLOAT, "float as the input"))
  {
    return false;
  }
  mesher->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  mesher->Update();
  return Check(mesher->GetOutput()->GetPoints()->GetDataType() == VTK_DOUBLE, "double as asked");
}

void Abort(vtkObject* caller, unsigned long, void*, void*)
{
  static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
}

// A mesh that would take minutes.
bool TestAbort()
{
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(Abort);
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputData(Cube(1));
  mesher->SetMaximumVolume(1e-8);
  mesher->AddObserver(vtkCommand::ProgressEvent, observer);
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  mesher->Update();
  timer->StopTimer();
  return Check(timer->GetElapsedTime() < 5, "abort is quick") &&
    Check(mesher->GetOutput()->GetNumberOfCells() == 0, "nothing comes of an aborted mesh");
}

} // anonymous namespace

int TestTetrahedralize(int, char*[])
{
  return TestCube() && TestSphere() && TestSurfaceKept() && TestCavity() && TestPrecision() &&
      TestAbort()
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
