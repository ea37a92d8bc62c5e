// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Sizes of files made of these meshes are under version control: coordinates and values come from
// + - * / and sqrt in binary64 only, in one order, and from the engines of <random>, whose numbers
// the standard defines.

#include "benchMeshes.h"

#include "benchHarness.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace bench
{
namespace
{

using Random = std::mt19937_64;
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

/** Points given in double, stored as float or double. */
vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Point>& points, bool doublePoints)
{
  auto coordinates = vtkSmartPointer<vtkPoints>::New();
  coordinates->SetDataType(doublePoints ? VTK_DOUBLE : VTK_FLOAT);
  coordinates->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    coordinates->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return coordinates;
}

Grid MakeGrid(const std::vector<Point>& points, std::vector<Tet> tets, bool doublePoints)
{
  auto grid = Grid::New();
  grid->SetPoints(MakePoints(points, doublePoints));
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

void AddFlow(
  vtkUnstructuredGrid* grid, const std::vector<Point>& points, bool allArrays, int step = 0)
{
  vtkFloatArray* density = AddArray(grid, "Density", 1);
  vtkFloatArray* momentum = allArrays ? AddArray(grid, "Momentum", 3) : nullptr;
  vtkFloatArray* energy = allArrays ? AddArray(grid, "Energy", 1) : nullptr;
  vtkFloatArray* pressure = allArrays ? AddArray(grid, "Pressure", 1) : nullptr;
  Random random(7 + static_cast<std::uint64_t>(step));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    std::array<double, 6> values = Flow({ points[i][0] + 0.01 * step, points[i][1], points[i][2] });
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

void AddWarmth(vtkUnstructuredGrid* grid, const std::vector<Point>& points, int step)
{
  vtkFloatArray* warmth = AddArray(grid, "Warmth", 1);
  const Point center{ 0.5 * Wave(0.03 * step), 0.5 * Wave(0.02 * step + 0.25), 0.2 };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double distance = 0;
    for (unsigned c = 0; c < 3; ++c)
    {
      distance += (points[i][c] - center[c]) * (points[i][c] - center[c]);
    }
    const double warm = 1 / (1 + (10 - 0.1 * step) * distance);
    warmth->SetValue(static_cast<vtkIdType>(i),
      static_cast<float>(warm + 0.1 * Wave(0.8 * points[i][0] + 0.5 * points[i][1] - 0.05 * step)));
  }
}

/** The points of a structured grid around a nose. */
std::vector<Point> MakeFlowPoints(const std::array<int, 3>& cells)
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
  return points;
}

vtkIdType GetFlowPoint(const std::array<int, 3>& cells, int i, int j, int k)
{
  return (static_cast<vtkIdType>(k) * (cells[1] + 1) + j) * (cells[0] + 1) + i;
}

/** Makes cells of many types between the points of a structured grid, and of points within. */
class MixedMaker
{
public:
  explicit MixedMaker(const std::array<int, 3>& cells)
    : Cells(cells)
    , Points(MakeFlowPoints(cells))
  {
    this->Result->AllocateEstimate(static_cast<vtkIdType>(this->Points.size()), 8);
  }

  Grid Make(bool hexahedraOnly)
  {
    for (int k = 0; k < this->Cells[2]; ++k)
    {
      for (int j = 0; j < this->Cells[1]; ++j)
      {
        const int quarter = hexahedraOnly ? 0 : 4 * j / this->Cells[1];
        for (int i = 0; i < this->Cells[0]; ++i)
        {
          const bool split = !hexahedraOnly && (i / 8 + j / 8 + k / 8) % 3 == 0;
          if (quarter == 3 && i + 1 < this->Cells[0] && (i > 0 || j % 2 == 0))
          {
            this->AddBrick(i++, j, k);
          }
          else if (quarter == 2)
          {
            this->AddWedges(i, j, k, split);
          }
          else
          {
            this->AddHexahedron(i, j, k, split && quarter < 2);
          }
        }
      }
    }
    this->Result->SetPoints(MakePoints(this->Points, false));
    AddFlow(this->Result, this->Points, false);
    return this->Result;
  }

private:
  using Ids = std::vector<vtkIdType>;

  /** From the outside to the nose, so that cells are not inside out. */
  vtkIdType At(int i, int j, int k) const
  {
    return GetFlowPoint(this->Cells, i, j, this->Cells[2] - k);
  }

  void Add(int type, const Ids& ids)
  {
    this->Result->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  }

  void AddHexahedron(int i, int j, int k, bool split)
  {
    const Ids ids{ this->At(i, j, k), this->At(i + 1, j, k), this->At(i + 1, j + 1, k),
      this->At(i, j + 1, k), this->At(i, j, k + 1), this->At(i + 1, j, k + 1),
      this->At(i + 1, j + 1, k + 1), this->At(i, j + 1, k + 1) };
    this->AddCell(VTK_HEXAHEDRON, ids, split,
      { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 }, { 1, 5, 6, 2 }, { 2, 6, 7, 3 },
        { 3, 7, 4, 0 } });
  }

  void AddWedges(int i, int j, int k, bool split)
  {
    for (const bool upper : { false, true })
    {
      Ids ids;
      for (const int z : { k, k + 1 })
      {
        ids.push_back(this->At(i, j, z));
        ids.push_back(upper ? this->At(i, j + 1, z) : this->At(i + 1, j + 1, z));
        ids.push_back(upper ? this->At(i + 1, j + 1, z) : this->At(i + 1, j, z));
      }
      this->AddCell(VTK_WEDGE, ids, split,
        { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } });
    }
  }

  /** The cell, or pyramids and tetrahedra from its faces to a point in its middle. */
  void AddCell(
    int type, const Ids& ids, bool split, const std::vector<std::vector<unsigned>>& faces)
  {
    if (!split)
    {
      this->Add(type, ids);
      return;
    }
    Point middle{};
    for (const vtkIdType id : ids)
    {
      for (unsigned c = 0; c < 3; ++c)
      {
        middle[c] +=
          this->Points[static_cast<std::size_t>(id)][c] / static_cast<double>(ids.size());
      }
    }
    const auto apex = static_cast<vtkIdType>(this->Points.size());
    this->Points.push_back(middle);
    for (const auto& face : faces)
    {
      Ids corners;
      for (const unsigned corner : face)
      {
        corners.push_back(ids[corner]);
      }
      corners.push_back(apex);
      this->Add(face.size() == 4 ? VTK_PYRAMID : VTK_TETRA, corners);
    }
  }

  /** A prism over a hexagon, which is two cells wide, as a polyhedron. */
  void AddBrick(int i, int j, int k)
  {
    const int ring[6][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 0, 1 } };
    const auto corner = [&](int at, int z)
    { return this->At(i + ring[at % 6][0], j + ring[at % 6][1], k + z); };
    vtkNew<vtkIdList> faces;
    faces->InsertNextId(8);
    for (const int z : { 0, 1 })
    {
      faces->InsertNextId(6);
      for (int at = 0; at < 6; ++at)
      {
        faces->InsertNextId(corner(z == 1 ? at : 5 - at, z));
      }
    }
    for (int at = 0; at < 6; ++at)
    {
      faces->InsertNextId(4);
      for (const vtkIdType id :
        { corner(at, 0), corner(at + 1, 0), corner(at + 1, 1), corner(at, 1) })
      {
        faces->InsertNextId(id);
      }
    }
    this->Result->InsertNextCell(VTK_POLYHEDRON, faces);
  }

  std::array<int, 3> Cells;
  std::vector<Point> Points;
  Grid Result = Grid::New();
};

} // anonymous namespace

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
Grid MakeFlow(const std::array<int, 3>& cells, bool allArrays)
{
  const std::vector<Point> points = MakeFlowPoints(cells);
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
            tet[c] = GetFlowPoint(
              cells, i + (corners[c] & 1), j + (corners[c] >> 1 & 1), k + (corners[c] >> 2 & 1));
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
Grid MakeStep(vtkUnstructuredGrid* grid, int step, bool moves)
{
  std::vector<Point> points(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Point& p = points[i];
    grid->GetPoint(static_cast<vtkIdType>(i), p.data());
    if (moves)
    {
      p[2] += 0.02 * Wave(0.04 * step + 0.3 * p[0]) * Wave(0.2 * p[1]);
    }
  }
  auto result = Grid::New();
  result->CopyStructure(grid);
  result->SetPoints(MakePoints(points, false));
  if (grid->GetPointData()->HasArray("Momentum"))
  {
    AddFlow(result, points, true, step);
  }
  else
  {
    AddWarmth(result, points, step);
  }
  return result;
}

//------------------------------------------------------------------------------
Grid MakeHexahedra(const std::array<int, 3>& cells)
{
  return MixedMaker(cells).Make(true);
}

//------------------------------------------------------------------------------
Grid MakeMixed(const std::array<int, 3>& cells)
{
  return MixedMaker(cells).Make(false);
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
}
