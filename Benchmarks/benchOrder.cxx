// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Other orders of meshes, other cells and fewer arrays.

#include "benchHarness.h"
#include "benchMeshes.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace bench
{
namespace
{
using Random = std::mt19937_64;

std::vector<vtkIdType> MakeOrder(vtkIdType count, Random& random)
{
  std::vector<vtkIdType> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), vtkIdType{ 0 });
  for (std::size_t i = order.size(); i > 1; --i)
  {
    std::swap(order[i - 1], order[static_cast<std::size_t>(random() % i)]);
  }
  return order;
}

void CopyArrays(
  vtkDataSetAttributes* from, vtkDataSetAttributes* to, const std::vector<vtkIdType>& order)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* source = from->GetAbstractArray(i);
    const auto array = vtkSmartPointer<vtkAbstractArray>::Take(source->NewInstance());
    array->SetName(source->GetName());
    array->SetNumberOfComponents(source->GetNumberOfComponents());
    array->SetNumberOfTuples(source->GetNumberOfTuples());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      array->SetTuple(static_cast<vtkIdType>(k), order[k], source);
    }
    to->AddArray(array);
  }
}

/** The grid with its points and cells in another order. */
Grid Reorder(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& points,
  const std::vector<vtkIdType>& cells)
{
  std::vector<vtkIdType> places(points.size());
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(grid->GetPoints()->GetDataType());
  coordinates->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    places[static_cast<std::size_t>(points[i])] = id;
    coordinates->SetPoint(id, grid->GetPoint(points[i]));
  }
  std::vector<Tet> tets;
  tets.reserve(cells.size());
  for (const vtkIdType cell : cells)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(cell, count, ids);
    Tet tet;
    for (unsigned i = 0; i < 4; ++i)
    {
      tet[i] = places[static_cast<std::size_t>(ids[i])];
    }
    tets.push_back(tet);
  }
  auto result = Grid::New();
  result->SetPoints(coordinates);
  SetTets(result, tets);
  CopyArrays(grid->GetPointData(), result->GetPointData(), points);
  CopyArrays(grid->GetCellData(), result->GetCellData(), cells);
  result->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return result;
}

/** What is to be in order, by its keys; equal ones stay as they are. */
template <typename Key>
std::vector<vtkIdType> SortedBy(const std::vector<Key>& keys)
{
  std::vector<vtkIdType> order(keys.size());
  std::iota(order.begin(), order.end(), vtkIdType{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&keys](vtkIdType a, vtkIdType b)
    { return keys[static_cast<std::size_t>(a)] < keys[static_cast<std::size_t>(b)]; });
  return order;
}

/** Where on a Morton curve a point is: bits of x, y and z in turns. */
std::uint64_t MortonKey(const double* point, const double* box)
{
  constexpr unsigned bits = 21;
  std::uint64_t key = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const double length = box[2 * axis + 1] - box[2 * axis];
    const double part = length > 0 ? (point[axis] - box[2 * axis]) / length : 0;
    const auto place = static_cast<std::uint64_t>(part * ((1U << bits) - 1));
    for (unsigned bit = 0; bit < bits; ++bit)
    {
      key |= (place >> bit & 1) << (3 * bit + axis);
    }
  }
  return key;
}

} // anonymous namespace

//------------------------------------------------------------------------------
Grid Permute(vtkUnstructuredGrid* grid)
{
  Random random(20260101);
  const std::vector<vtkIdType> points = MakeOrder(grid->GetNumberOfPoints(), random);
  const std::vector<vtkIdType> cells = MakeOrder(grid->GetNumberOfCells(), random);
  return Reorder(grid, points, cells);
}

//------------------------------------------------------------------------------
Grid SortAlongCurve(vtkUnstructuredGrid* grid)
{
  double box[6];
  grid->GetBounds(box);
  std::vector<std::uint64_t> ofPoints(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < ofPoints.size(); ++i)
  {
    ofPoints[i] = MortonKey(grid->GetPoint(static_cast<vtkIdType>(i)), box);
  }
  std::vector<std::uint64_t> ofCells(static_cast<std::size_t>(grid->GetNumberOfCells()));
  for (std::size_t i = 0; i < ofCells.size(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(static_cast<vtkIdType>(i), count, ids);
    const auto getKey = [&](vtkIdType corner)
    { return ofPoints[static_cast<std::size_t>(ids[corner])]; };
    ofCells[i] = std::min({ getKey(0), getKey(1), getKey(2), getKey(3) });
  }
  return Reorder(grid, SortedBy(ofPoints), SortedBy(ofCells));
}

//------------------------------------------------------------------------------
Grid Triangulate(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfCells() > 0 && grid->IsHomogeneous() && grid->GetCellType(0) == VTK_TETRA)
  {
    return grid;
  }
  vtkNew<vtkDataSetTriangleFilter> filter;
  filter->SetInputData(grid);
  filter->TetrahedraOnlyOn();
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
Grid KeepPointArray(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* array = grid->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw Failure("there is no point array " + name);
  }
  auto result = Grid::New();
  result->CopyStructure(grid);
  result->GetPointData()->AddArray(array);
  return result;
}
}
