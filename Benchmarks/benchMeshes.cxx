// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Sizes of files made of these meshes are under version control: coordinates and values come from
// + - * / and sqrt in binary64 only, in one order, and from the engines of <random>, whose numbers
// the standard defines.

#include "benchMeshes.h"

#include "benchHarness.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
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
using Tet = std::array<vtkIdType, 4>;
using Point = std::array<double, 3>;

/** 0 to 1. */
double Uniform(Random& random)
{
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/** Much like sin(2 pi t). */
double Wave(double t)
{
  const double u = t - std::floor(t);
  const double half = u < 0.5 ? u : u - 0.5;
  const double arc = 16 * half * (0.5 - half);
  const double sine = arc * (0.775 + 0.225 * arc);
  return u < 0.5 ? sine : -sine;
}

/** From -1 to 1, steep at 0. */
double Step(double t)
{
  return t / std::sqrt(1 + t * t);
}

double Determinant(const Point& a, const Point& b, const Point& c, const Point& d)
{
  Point e[3];
  for (unsigned i = 0; i < 3; ++i)
  {
    e[0][i] = b[i] - a[i];
    e[1][i] = c[i] - a[i];
    e[2][i] = d[i] - a[i];
  }
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
    e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

void SetTets(vtkUnstructuredGrid* grid, const std::vector<Tet>& tets)
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(4 * tets.size()));
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(tets.size()) + 1);
  vtkIdType place = 0;
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    offsets->SetValue(static_cast<vtkIdType>(i), place);
    for (const vtkIdType id : tets[i])
    {
      connectivity->SetValue(place++, id);
    }
  }
  offsets->SetValue(static_cast<vtkIdType>(tets.size()), place);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  grid->SetCells(VTK_TETRA, cells);
}

/** A grid of points given in double, stored as float or double. */
Grid MakeGrid(const std::vector<Point>& points, std::vector<Tet> tets, bool doublePoints)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(doublePoints ? VTK_DOUBLE : VTK_FLOAT);
  coordinates->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    coordinates->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  grid->SetPoints(coordinates);
  for (Tet& tet : tets)
  {
    const auto at = [&](unsigned i) -> const Point&
    { return points[static_cast<std::size_t>(tet[i])]; };
    if (Determinant(at(0), at(1), at(2), at(3)) < 0)
    {
      std::swap(tet[2], tet[3]);
    }
  }
  SetTets(grid, tets);
  return grid;
}

vtkFloatArray* AddArray(vtkUnstructuredGrid* grid, const char* name, int components)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(grid->GetNumberOfPoints());
  grid->GetPointData()->AddArray(array);
  return array;
}

/** Place of a fraction of the way from the nose outwards: cells grow with the distance. */
double Stretch(double t)
{
  return t * (0.2 + 0.8 * t);
}

Point FlowPoint(double u, double v, double w)
{
  const double t = 2 * u - 1 + 0.05 * Wave(u);
  const double circle = 1 + t * t;
  const double radius = 0.2 + 2 * Stretch(w) + 0.05 * Wave(v) * w;
  return { -radius * (1 - t * t) / circle, radius * 2 * t / circle,
    2 * Stretch(v) + 0.03 * Wave(u + w) };
}

/** Density, momentum, energy and pressure, without noise. */
std::array<double, 6> Flow(const Point& p)
{
  const double radius = std::sqrt(p[0] * p[0] + p[1] * p[1]);
  const double shock = 0.5 + 0.5 * Step(12 * (1.1 + 0.1 * p[2] - radius));
  const double wave = 0.05 * Wave(0.6 * p[0] + 0.3 * p[2]) * Wave(0.5 * p[1]);
  const double density = 1 + 2.5 * shock * (1 + 0.3 * Step(2 * p[0])) + wave;
  const double x = (1 - 0.7 * shock) * density * (1 - 0.2 * Step(p[2]));
  const double y = 0.4 * shock * density * p[1] / (0.1 + radius);
  const double z = 0.1 * density * Wave(0.2 * p[2] + 0.1 * p[0]);
  const double pressure = 0.7 + 3 * shock * density * density / 12;
  const double energy = 2.5 * pressure + 0.5 * (x * x + y * y + z * z) / density;
  return { density, x, y, z, energy, pressure };
}

void AddFlow(vtkUnstructuredGrid* grid, const std::vector<Point>& points, bool allArrays)
{
  vtkFloatArray* density = AddArray(grid, "Density", 1);
  vtkFloatArray* momentum = allArrays ? AddArray(grid, "Momentum", 3) : nullptr;
  vtkFloatArray* energy = allArrays ? AddArray(grid, "Energy", 1) : nullptr;
  vtkFloatArray* pressure = allArrays ? AddArray(grid, "Pressure", 1) : nullptr;
  Random random(7);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    std::array<double, 6> values = Flow(points[i]);
    for (double& value : values)
    {
      value *= 1 + 1e-6 * (2 * Uniform(random) - 1);
    }
    density->SetValue(id, static_cast<float>(values[0]));
    if (allArrays)
    {
      for (int c = 0; c < 3; ++c)
      {
        momentum->SetTypedComponent(id, c, static_cast<float>(values[1 + c]));
      }
      energy->SetValue(id, static_cast<float>(values[4]));
      pressure->SetValue(id, static_cast<float>(values[5]));
    }
  }
}

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
Grid MakeFlow(const std::array<int, 3>& cells, bool allArrays)
{
  std::vector<Point> points;
  for (int k = 0; k <= cells[2]; ++k)
  {
    for (int j = 0; j <= cells[1]; ++j)
    {
      for (int i = 0; i <= cells[0]; ++i)
      {
        points.push_back(FlowPoint(static_cast<double>(i) / cells[0],
          static_cast<double>(j) / cells[1], static_cast<double>(k) / cells[2]));
      }
    }
  }
  constexpr int split[2][5][4] = { { { 0, 1, 3, 5 }, { 0, 3, 2, 6 }, { 0, 5, 6, 4 }, { 3, 6, 5, 7 },
                                     { 0, 3, 6, 5 } },
    { { 1, 0, 2, 4 }, { 1, 2, 3, 7 }, { 1, 4, 7, 5 }, { 2, 7, 4, 6 }, { 1, 2, 4, 7 } } };
  std::vector<Tet> tets;
  for (int k = 0; k < cells[2]; ++k)
  {
    for (int j = 0; j < cells[1]; ++j)
    {
      for (int i = 0; i < cells[0]; ++i)
      {
        for (const auto& corners : split[(i + j + k) % 2])
        {
          Tet tet;
          for (unsigned c = 0; c < 4; ++c)
          {
            const int x = i + (corners[c] & 1);
            const int y = j + (corners[c] >> 1 & 1);
            const int z = k + (corners[c] >> 2 & 1);
            tet[c] = (static_cast<vtkIdType>(z) * (cells[1] + 1) + y) * (cells[0] + 1) + x;
          }
          tets.push_back(tet);
        }
      }
    }
  }
  Grid grid = MakeGrid(points, std::move(tets), false);
  AddFlow(grid, points, allArrays);
  return grid;
}

//------------------------------------------------------------------------------
Grid MakeLattice(int cells, bool doublePoints)
{
  Random random(11);
  std::vector<Point> points;
  const auto add = [&](int i, int j, int k, double shift)
  {
    Point point;
    const double place[3] = { i + shift, j + shift, k + shift };
    for (unsigned c = 0; c < 3; ++c)
    {
      point[c] = (place[c] + 0.15 * (2 * Uniform(random) - 1)) / cells;
    }
    points.push_back(point);
  };
  const auto all = [&](int end, double shift)
  {
    for (int k = 0; k < end; ++k)
    {
      for (int j = 0; j < end; ++j)
      {
        for (int i = 0; i < end; ++i)
        {
          add(i, j, k, shift);
        }
      }
    }
  };
  all(cells + 1, 0);
  all(cells, 0.5);
  const vtkIdType corners = (cells + 1) * (cells + 1) * (cells + 1);
  const auto corner = [&](const std::array<int, 3>& at)
  { return (static_cast<vtkIdType>(at[2]) * (cells + 1) + at[1]) * (cells + 1) + at[0]; };
  const auto center = [&](const std::array<int, 3>& at)
  { return corners + (static_cast<vtkIdType>(at[2]) * cells + at[1]) * cells + at[0]; };
  std::vector<Tet> tets;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const unsigned right = (axis + 1) % 3;
    const unsigned up = (axis + 2) % 3;
    std::array<int, 3> at;
    for (at[2] = 0; at[2] < cells; ++at[2])
    {
      for (at[1] = 0; at[1] < cells; ++at[1])
      {
        for (at[0] = 0; at[0] < cells; ++at[0])
        {
          if (at[axis] == 0)
          {
            continue;
          }
          // Around the line between two centers go the four edges of the face that it crosses.
          std::array<int, 3> behind = at;
          --behind[axis];
          constexpr int turns[5][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 } };
          for (unsigned turn = 0; turn < 4; ++turn)
          {
            std::array<int, 3> from = at;
            std::array<int, 3> to = at;
            from[right] += turns[turn][0];
            from[up] += turns[turn][1];
            to[right] += turns[turn + 1][0];
            to[up] += turns[turn + 1][1];
            tets.push_back({ center(behind), center(at), corner(from), corner(to) });
          }
        }
      }
    }
  }
  Grid grid = MakeGrid(points, std::move(tets), doublePoints);
  AddFlow(grid, points, false);
  return grid;
}

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
