// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurfaceSamples_h
#define gatunSurfaceSamples_h

// Meshes with arrays, and all that is on their isosurfaces.

#include "gatunSurface.h"
#include "gatunTestMeshes.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace gatun::test
{
using Vector = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

inline constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/** A mesh with arrays, as surfaces are made of. */
struct Sample
{
  explicit Sample(const TestMesh& mesh)
    : Mesh(mesh)
  {
    this->Values.resize(mesh.GetPoints());
    this->Cells.resize(mesh.GetTets());
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      this->Cells[i] = static_cast<std::int32_t>(i) - 100;
    }
  }

  template <typename ValueOf>
  void Fill(ValueOf&& valueOf)
  {
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      this->Values[i] = valueOf(this->Point(i));
    }
  }

  Vector Point(std::size_t i) const
  {
    const double* x = &this->Mesh.Coordinates[3 * i];
    return { x[0], x[1], x[2] };
  }

  SurfaceInput Get() const
  {
    SurfaceInput input;
    input.Mesh.Points = this->Mesh.GetPoints();
    input.Mesh.Connectivity = this->Mesh.Ids.data();
    input.Mesh.Values = this->Values.data();
    input.Points = { this->Mesh.Coordinates.data(), ScalarType::Float64, 3 };
    input.PointArrays = { { this->Values.data(), ScalarType::Float64, 1 },
      { this->Mesh.Coordinates.data(), ScalarType::Float64, 3 } };
    input.CellArrays = { { this->Cells.data(), ScalarType::Int32, 1 } };
    return input;
  }

  TestMesh Mesh;
  std::vector<double> Values;
  std::vector<std::int32_t> Cells;
};

/** All there is on a surface. */
template <typename T>
struct Content
{
  explicit Content(const Surface& surface, bool arrays = true, bool normals = false)
    : Points(3 * surface.GetNumberOfPoints())
    , Triangles(surface.GetTriangles())
  {
    surface.FillPoints(this->Points.data());
    if (arrays)
    {
      this->Values.resize(surface.GetNumberOfPoints());
      this->Vectors.resize(3 * surface.GetNumberOfPoints());
      this->Cells.resize(surface.GetNumberOfTriangles());
      surface.FillPointArray(0, 8, this->Values.data());
      surface.FillPointArray(1, 24, this->Vectors.data());
      surface.FillCellArray(0, 4, this->Cells.data());
    }
    if (normals)
    {
      this->Normals.resize(3 * surface.GetNumberOfPoints());
      surface.FillNormals(this->Normals.data());
    }
  }

  bool operator==(const Content&) const = default;

  std::array<T, 3> Point(std::size_t i) const
  {
    return { this->Points[3 * i], this->Points[3 * i + 1], this->Points[3 * i + 2] };
  }

  Vector Normal(std::size_t i) const
  {
    return { this->Normals[3 * i], this->Normals[3 * i + 1], this->Normals[3 * i + 2] };
  }

  std::vector<T> Points;
  std::vector<Triangle> Triangles;
  std::vector<double> Values;
  std::vector<double> Vectors;
  std::vector<std::int32_t> Cells;
  std::vector<float> Normals;
};

inline Surface Make(const Sample& sample, const SurfaceOptions& options)
{
  return Surface(
    MakeSurfaceParts(sample.Get(), options, sample.Mesh.GetTets()), options.CoordinateType);
}

inline double Wave(const Vector& x)
{
  return std::sin(0.4 * x[0]) * std::cos(0.3 * x[1]) + 0.1 * x[2];
}

/** Puts several parts together from a list of points and triangles. */
template <typename T>
SurfacePart MakePart(const std::vector<std::array<T, 3>>& points,
  const std::vector<Triangle>& triangles, double value, const Vector& gradient = {})
{
  SurfacePart part;
  part.NumberOfPoints = points.size();
  part.Points.resize(3 * sizeof(T) * points.size());
  if (!points.empty())
  {
    std::memcpy(part.Points.data(), points.data(), part.Points.size());
  }
  const auto bytesOf = [](const auto& values)
  {
    const auto* const first = reinterpret_cast<const std::uint8_t*>(values.data());
    return PageArray<std::uint8_t>(first, first + values.size() * sizeof(values[0]));
  };
  std::vector<double> values(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    values[i] = value + static_cast<double>(i);
  }
  part.PointArrays = { bytesOf(values), bytesOf(std::vector<double>(3 * points.size(), value)) };
  std::vector<std::int32_t> cells(triangles.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i] = static_cast<std::int32_t>(value) + static_cast<std::int32_t>(i);
  }
  part.CellArrays = { bytesOf(cells) };
  part.Triangles.assign(triangles.begin(), triangles.end());
  part.Gradients.assign(points.size(), gradient);
  return part;
}
}

#endif
