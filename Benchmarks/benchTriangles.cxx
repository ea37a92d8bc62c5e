// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchTriangles.h"

#include "benchHarness.h"

#include "gatunParallel.h"

#include "vtkCellArray.h"
#include "vtkContourFilter.h"
#include "vtkDataSetReader.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLGenericDataObjectReader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace bench
{
namespace
{
using Vec = std::array<double, 3>;

constexpr const char* Values = "Values";

/** Puts points into an array of floats, and fields into the point data. */
Triangles MakeSurface(const std::vector<Vec>& points,
  const std::vector<std::array<vtkIdType, 3>>& cells, const std::vector<double>& values,
  int components)
{
  Triangles surface = Triangles::New();
  vtkNew<vtkPoints> places;
  for (const Vec& point : points)
  {
    places->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polys;
  for (const auto& cell : cells)
  {
    polys->InsertNextCell(3, cell.data());
  }
  vtkNew<vtkFloatArray> array;
  array->SetName(Values);
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(static_cast<float>(value));
  }
  surface->SetPoints(places);
  surface->SetPolys(polys);
  if (components == 1)
  {
    surface->GetPointData()->SetScalars(array);
  }
  else
  {
    surface->GetPointData()->SetTCoords(array);
  }
  return surface;
}

double Wave(const Vec& p)
{
  return std::sin(7 * p[0] + 2 * p[1]) * std::cos(5 * p[1] - 3 * p[2]) + 0.5 * std::sin(11 * p[2]);
}

/** An icosahedron whose triangles are divided into four, again and again. */
Triangles MakeSphere(std::size_t count)
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  solid->Update();
  std::vector<Vec> points;
  const auto add = [&](const Vec& p)
  {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    points.push_back({ p[0] / length, p[1] / length, p[2] / length });
    return static_cast<vtkIdType>(points.size() - 1);
  };
  for (vtkIdType i = 0; i < solid->GetOutput()->GetNumberOfPoints(); ++i)
  {
    Vec p{};
    solid->GetOutput()->GetPoint(i, p.data());
    add(p);
  }
  std::vector<std::array<vtkIdType, 3>> cells;
  for (vtkIdType i = 0; i < solid->GetOutput()->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    solid->GetOutput()->GetCellPoints(i, size, ids);
    cells.push_back({ ids[0], ids[1], ids[2] });
  }
  while (2 * cells.size() < count)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
    const auto getMiddle = [&](vtkIdType a, vtkIdType b)
    {
      const auto [found, isNew] = middles.emplace(std::minmax(a, b), 0);
      if (isNew)
      {
        const Vec& p = points[static_cast<std::size_t>(a)];
        const Vec& q = points[static_cast<std::size_t>(b)];
        found->second = add({ p[0] + q[0], p[1] + q[1], p[2] + q[2] });
      }
      return found->second;
    };
    std::vector<std::array<vtkIdType, 3>> divided;
    for (const auto& [a, b, c] : cells)
    {
      const auto ab = getMiddle(a, b);
      const auto bc = getMiddle(b, c);
      const auto ca = getMiddle(c, a);
      divided.insert(
        divided.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
    }
    cells.swap(divided);
  }
  std::vector<double> values(points.size());
  std::transform(points.begin(), points.end(), values.begin(), Wave);
  return MakeSurface(points, cells, values, 1);
}

/** The triangles of a lattice of points. */
std::vector<std::array<vtkIdType, 3>> MakeLattice(int columns, int rows)
{
  std::vector<std::array<vtkIdType, 3>> cells;
  for (vtkIdType row = 0; row + 1 < rows; ++row)
  {
    for (vtkIdType column = 0; column + 1 < columns; ++column)
    {
      const vtkIdType at = row * columns + column;
      cells.push_back({ at, at + 1, at + columns + 1 });
      cells.push_back({ at, at + columns + 1, at + columns });
    }
  }
  return cells;
}

Triangles MakeTerrain(std::size_t count)
{
  const int side = static_cast<int>(std::sqrt(static_cast<double>(count) / 2)) + 1;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-1, 1);
  std::vector<Vec> points;
  std::vector<double> values;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const double u = x / (side - 1.0);
      const double v = y / (side - 1.0);
      double height = 0;
      for (int octave = 0; octave < 5; ++octave)
      {
        const double f = 6.0 * (1 << octave);
        height +=
          0.1 / (1 << octave) * std::sin(f * u + 1.3 * octave) * std::cos(f * v + octave * u);
      }
      points.push_back({ u, v, height + 1e-4 * noise(random) });
      values.push_back(Wave({ u, v, 2 * u * v }));
    }
  }
  return MakeSurface(points, MakeLattice(side, side), values, 1);
}

Triangles MakeTorus(std::size_t count)
{
  const int side = static_cast<int>(std::sqrt(static_cast<double>(count) / 2)) + 1;
  std::vector<Vec> points;
  std::vector<double> values;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const double u = x / (side - 1.0);
      const double v = y / (side - 1.0);
      // The first and the last ones coincide.
      const double a = 2 * std::numbers::pi * (x == side - 1 ? 0 : u);
      const double b = 2 * std::numbers::pi * (y == side - 1 ? 0 : v);
      const double radius = 1 + 0.4 * std::cos(b) + 0.05 * std::cos(6 * a);
      points.push_back({ radius * std::cos(a), radius * std::sin(a), 0.4 * std::sin(b) });
      values.push_back(u);
      values.push_back(v);
    }
  }
  return MakeSurface(points, MakeLattice(side, side), values, 2);
}

/** Three corners of a triangle. */
struct Corners
{
  std::array<vtkIdType, 3> Ids;
  std::array<Vec, 3> Points;
};

Corners GetCorners(vtkPolyData* surface, vtkIdType cell)
{
  Corners corners;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  surface->GetCellPoints(cell, size, ids);
  if (size != 3)
  {
    throw Failure("not all cells are triangles");
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners.Ids[i] = ids[i];
    surface->GetPoint(ids[i], corners.Points[i].data());
  }
  return corners;
}

double GetArea(const Corners& c)
{
  Vec a{};
  Vec b{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    a[i] = c.Points[1][i] - c.Points[0][i];
    b[i] = c.Points[2][i] - c.Points[0][i];
  }
  const Vec n{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  return std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
}

/** Of a place on a triangle; never outside, however thin the triangle is. */
std::array<double, 3> GetWeights(const Corners& corners, const Vec& place)
{
  std::array<double, 3> weights{};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    Corners part = corners;
    part.Points[i] = place;
    sum += weights[i] = GetArea(part);
  }
  for (double& weight : weights)
  {
    weight = sum > 0 ? weight / sum : 1.0 / 3;
  }
  return weights;
}

std::vector<double> Interpolate(
  vtkDataArray* array, const Corners& corners, const std::array<double, 3>& weights)
{
  std::vector<double> values;
  for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
  {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      sum += weights[i] * array->GetComponent(corners.Ids[i], c);
    }
    values.push_back(sum);
  }
  return values;
}
}

//------------------------------------------------------------------------------
Triangles MakeTriangles(const std::string& name, std::size_t count)
{
  if (name == "sphere")
  {
    return MakeSphere(count);
  }
  if (name == "terrain")
  {
    return MakeTerrain(count);
  }
  if (name == "torus")
  {
    return MakeTorus(count);
  }
  throw Failure("there is no surface " + name);
}

//------------------------------------------------------------------------------
Triangles LoadTriangles(
  const std::string& file, const std::string& array, const std::string& isoArray, double value)
{
  vtkSmartPointer<vtkDataSet> data;
  if (file.ends_with(".vtk"))
  {
    vtkNew<vtkDataSetReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    data = reader->GetOutput();
  }
  else
  {
    vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    data = vtkDataSet::SafeDownCast(reader->GetOutput());
  }
  if (!data)
  {
    throw Failure(file + " has no mesh");
  }
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
  if (!isoArray.empty())
  {
    vtkNew<vtkContourFilter> contour;
    contour->SetInputData(data);
    contour->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, isoArray.c_str());
    contour->SetValue(0, value);
    contour->Update();
    surface = contour->GetOutput();
  }
  else if (!surface)
  {
    vtkNew<vtkDataSetSurfaceFilter> boundary;
    boundary->SetInputData(data);
    boundary->Update();
    surface = boundary->GetOutput();
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  Triangles result = Triangles::New();
  result->CopyStructure(triangles->GetOutput());
  vtkDataArray* const values = triangles->GetOutput()->GetPointData()->GetArray(array.c_str());
  if (values)
  {
    vtkNew<vtkFloatArray> copy;
    copy->DeepCopy(values);
    copy->SetName(Values);
    result->GetPointData()->SetScalars(copy);
  }
  return result;
}

//------------------------------------------------------------------------------
struct TriangleComparison::Places
{
  std::vector<Vec> Points;
  std::vector<std::vector<double>> Fields;
};

//------------------------------------------------------------------------------
TriangleComparison::TriangleComparison(vtkPolyData* original, std::size_t samples, bool isPeriodic)
  : Original(original)
  , Samples(samples)
  , IsPeriodic(isPeriodic)
{
}

//------------------------------------------------------------------------------
TriangleComparison::Places TriangleComparison::Sample(vtkPolyData* surface) const
{
  vtkDataArray* const array = surface->GetPointData()->GetArray(Values);
  Places places;
  const auto cells = surface->GetNumberOfCells();
  std::vector<double> areas;
  double whole = 0;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    areas.push_back(whole += GetArea(GetCorners(surface, cell)));
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::size_t cell = 0;
  for (std::size_t i = 0; i < this->Samples && whole > 0; ++i)
  {
    const double at =
      whole * (static_cast<double>(i) + uniform(random)) / static_cast<double>(this->Samples);
    while (cell + 1 < areas.size() && areas[cell] < at)
    {
      ++cell;
    }
    const Corners corners = GetCorners(surface, static_cast<vtkIdType>(cell));
    double u = uniform(random);
    double v = uniform(random);
    if (u + v > 1)
    {
      u = 1 - u;
      v = 1 - v;
    }
    const std::array<double, 3> weights{ 1 - u - v, u, v };
    Vec point{};
    for (std::size_t j = 0; j < 9; ++j)
    {
      point[j % 3] += weights[j / 3] * corners.Points[j / 3][j % 3];
    }
    places.Points.push_back(point);
    places.Fields.push_back(Interpolate(array, corners, weights));
  }
  // The points themselves are where surfaces are farthest from others.
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Vec point{};
    surface->GetPoint(i, point.data());
    places.Points.push_back(point);
  }
  return places;
}

namespace
{
struct Sums
{
  double Largest = 0; // squared
  double Squares = 0;
  double FieldSquares = 0;
  std::size_t Fields = 0;
};

/** From places to a surface. */
Sums Measure(const std::vector<Vec>& points, const std::vector<std::vector<double>>& fields,
  vtkPolyData* surface, bool isPeriodic)
{
  vtkNew<vtkStaticCellLocator> locator;
  surface->BuildCells();
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkDataArray* const array = surface->GetPointData()->GetArray(Values);
  constexpr std::size_t parts = 16;
  std::array<Sums, parts> sums;
  gatun::ParallelFor(parts,
    [&](std::size_t part)
    {
      vtkNew<vtkGenericCell> cell;
      for (std::size_t i = part * points.size() / parts; i < (part + 1) * points.size() / parts;
           ++i)
      {
        Vec nearest{};
        vtkIdType id = -1;
        int sub = 0;
        double square = 0;
        locator->FindClosestPoint(points[i].data(), nearest.data(), cell, id, sub, square);
        sums[part].Largest = std::max(sums[part].Largest, square);
        if (i >= fields.size())
        {
          continue;
        }
        sums[part].Squares += square;
        if (!array || fields[i].empty())
        {
          continue;
        }
        // Not that of the cell at hand, which the locator looked at last.
        const Corners corners = GetCorners(surface, id);
        const auto values = Interpolate(array, corners, GetWeights(corners, nearest));
        for (std::size_t c = 0; c < values.size(); ++c)
        {
          double error = values[c] - fields[i][c];
          error -= isPeriodic ? std::round(error) : 0;
          sums[part].FieldSquares += error * error;
          ++sums[part].Fields;
        }
      }
    });
  Sums all;
  for (const Sums& part : sums)
  {
    all.Largest = std::max(all.Largest, part.Largest);
    all.Squares += part.Squares;
    all.FieldSquares += part.FieldSquares;
    all.Fields += part.Fields;
  }
  return all;
}
}

//------------------------------------------------------------------------------
TriangleDeviation TriangleComparison::Compare(vtkPolyData* simplified) const
{
  const Places forth = this->Sample(this->Original);
  const Places back = this->Sample(simplified);
  const Sums to = Measure(forth.Points, forth.Fields, simplified, this->IsPeriodic);
  const Sums from = Measure(back.Points, back.Fields, this->Original, this->IsPeriodic);
  const double diagonal = this->Original->GetLength();
  TriangleDeviation deviation;
  deviation.Forth = std::sqrt(to.Largest) / diagonal;
  deviation.Back = std::sqrt(from.Largest) / diagonal;
  deviation.Hausdorff = std::max(deviation.Forth, deviation.Back);
  deviation.MeanSquare =
    std::sqrt((to.Squares + from.Squares) / (2.0 * static_cast<double>(this->Samples))) / diagonal;
  double range[2] = { 0, 1 };
  if (vtkDataArray* const array = this->Original->GetPointData()->GetArray(Values))
  {
    array->GetRange(range, 0);
  }
  deviation.FieldRms = to.Fields + from.Fields > 0
    ? std::sqrt(
        (to.FieldSquares + from.FieldSquares) / static_cast<double>(to.Fields + from.Fields)) /
      (range[1] - range[0])
    : std::numeric_limits<double>::quiet_NaN();
  return deviation;
}
}
