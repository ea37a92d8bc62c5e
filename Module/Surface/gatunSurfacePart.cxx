// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSurfacePart.h"

#include "gatunParallel.h"
#include "gatunVector.h"
#include "gatunWithType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::uint64_t TetsPerPart = 1u << 16;

/** Converts an interpolated number to the type of the array. Integers are rounded, halves away from
 * zero, as in VTK. */
template <typename T>
T Convert(double value)
{
  if constexpr (std::is_integral_v<T>)
  {
    // The largest 64-bit numbers are rounded up beyond the range of the type.
    constexpr double end = static_cast<double>(std::numeric_limits<T>::max() / 2 + 1) * 2;
    // Not std::round: that of MinGW makes 1 of the largest number below a half.
    const double inner = std::trunc(value);
    const double whole = std::abs(value - inner) < 0.5 ? inner : inner + std::copysign(1., value);
    return whole >= end ? std::numeric_limits<T>::max() : static_cast<T>(whole);
  }
  else
  {
    return static_cast<T>(value);
  }
}

template <typename T>
void InterpolateTuples(
  const T* from, std::size_t components, std::span<const Crossing> points, T* to)
{
  for (const Crossing& point : points)
  {
    const T* const low = from + components * point.Low;
    const T* const high = from + components * point.High;
    for (std::size_t c = 0; c < components; ++c)
    {
      *to++ = Convert<T>(
        static_cast<double>(low[c]) * (1 - point.Part) + static_cast<double>(high[c]) * point.Part);
    }
  }
}

PageArray<std::uint8_t> Interpolate(const TupleView& array, std::span<const Crossing> points)
{
  PageArray<std::uint8_t> out(points.size() * array.GetTupleSize());
  WithType(array.Type, array.Values,
    [&]<typename T>(const T* from)
    { InterpolateTuples(from, array.Components, points, reinterpret_cast<T*>(out.data())); });
  return out;
}

PageArray<std::uint8_t> Gather(const TupleView& array, std::span<const std::uint32_t> tuples)
{
  const std::size_t size = array.GetTupleSize();
  PageArray<std::uint8_t> out(tuples.size() * size);
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    std::memcpy(out.data() + i * size,
      static_cast<const std::uint8_t*>(array.Values) + tuples[i] * size, size);
  }
  return out;
}

glm::dvec3 GetPoint(const TupleView& points, std::size_t point)
{
  const auto get = [&](auto zero)
  {
    const auto* const x = static_cast<const decltype(zero)*>(points.Values) + 3 * point;
    return glm::dvec3{ x[0], x[1], x[2] };
  };
  return points.Type == ScalarType::Float32 ? get(float{}) : get(double{});
}

/** Writes the coordinates of crossings. At the end of an edge they are exactly those of the point
 * there, so that they are the same for all edges of the point. */
template <typename T>
void Locate(const TupleView& points, std::span<const Crossing> crossings, T* to)
{
  for (const Crossing& crossing : crossings)
  {
    const glm::dvec3 low = GetPoint(points, crossing.Low);
    const glm::dvec3 high = GetPoint(points, crossing.High);
    const glm::dvec3 place = crossing.Part == 1 ? high : low + crossing.Part * (high - low);
    for (int axis = 0; axis < 3; ++axis)
    {
      *to++ = static_cast<T>(place[axis]);
    }
  }
}

/** A tetrahedron: its corners, and its edges from the first corner to the others. */
struct Tetrahedron
{
  std::array<std::size_t, 4> Ids;
  std::array<glm::dvec3, 3> Edges;

  Tetrahedron(const SurfaceInput& input, std::uint32_t cell)
  {
    for (unsigned i = 0; i < 4; ++i)
    {
      const auto place = 4 * std::size_t{ cell } + i;
      const auto* const ids = input.Mesh.Connectivity;
      this->Ids[i] = input.Mesh.WideIds
        ? static_cast<std::size_t>(static_cast<const std::int64_t*>(ids)[place])
        : static_cast<std::size_t>(static_cast<const std::int32_t*>(ids)[place]);
    }
    const glm::dvec3 first = GetPoint(input.Points, this->Ids[0]);
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Edges[i] = GetPoint(input.Points, this->Ids[i + 1]) - first;
    }
  }

  /** Whether the volume is negative. */
  bool IsLeftHanded() const
  {
    return glm::dot(this->Edges[0], glm::cross(this->Edges[1], this->Edges[2])) < 0;
  }
};

/** Six times the volume of a tetrahedron times the gradient of its values. */
glm::dvec3 GetGradient(const SurfaceInput& input, std::uint32_t cell)
{
  const Tetrahedron tet(input, cell);
  std::array<double, 4> s;
  for (unsigned i = 0; i < 4; ++i)
  {
    s[i] = input.Mesh.WideValues ? static_cast<const double*>(input.Mesh.Values)[tet.Ids[i]]
                                 : static_cast<const float*>(input.Mesh.Values)[tet.Ids[i]];
  }
  const auto& [a, b, c] = tet.Edges;
  // The gradient is this divided by six times the volume, which has the sign of the orientation.
  const double sign = tet.IsLeftHanded() ? -1 : 1;
  return sign *
    ((s[1] - s[0]) * glm::cross(b, c) + (s[2] - s[0]) * glm::cross(c, a) +
      (s[3] - s[0]) * glm::cross(a, b));
}

/** Turns the triangles of left-handed tetrahedra over, so that all fronts face lower values. */
void TurnLeftHanded(const SurfaceInput& input, MarchedSurface& surface)
{
  bool turn = false;
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    if (i == 0 || surface.Cells[i] != surface.Cells[i - 1])
    {
      turn = Tetrahedron(input, surface.Cells[i]).IsLeftHanded();
    }
    if (turn)
    {
      std::swap(surface.Triangles[i][1], surface.Triangles[i][2]);
    }
  }
}

std::vector<std::array<double, 3>> AddGradients(
  const SurfaceInput& input, const MarchedSurface& surface)
{
  std::vector<std::array<double, 3>> sums(surface.Points.size(), std::array<double, 3>{});
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const glm::dvec3 gradient = GetGradient(input, surface.Cells[i]);
    // The second triangle of a section with four corners adds only to its own point.
    const bool second = i > 0 && surface.Cells[i] == surface.Cells[i - 1];
    for (const std::uint32_t point : surface.Triangles[i])
    {
      const auto& before = surface.Triangles[i - (second ? 1 : 0)];
      if (!second || std::find(before.begin(), before.end(), point) == before.end())
      {
        sums[point] = ToArray(ToVector(sums[point]) + gradient);
      }
    }
  }
  return sums;
}
}

//------------------------------------------------------------------------------
SurfacePart MakeSurfacePart(
  const SurfaceInput& input, const SurfaceOptions& options, std::uint64_t first, std::uint64_t last)
{
  MarchedSurface marched = March(input.Mesh, first, last, options.Values);
  TurnLeftHanded(input, marched);
  SurfacePart part;
  part.NumberOfPoints = marched.Points.size();
  part.Points.resize(3 * SizeOf(options.CoordinateType) * marched.Points.size());
  if (options.CoordinateType == ScalarType::Float32)
  {
    Locate(input.Points, marched.Points, reinterpret_cast<float*>(part.Points.data()));
  }
  else
  {
    Locate(input.Points, marched.Points, reinterpret_cast<double*>(part.Points.data()));
  }
  for (const TupleView& array : input.PointArrays)
  {
    part.PointArrays.push_back(Interpolate(array, marched.Points));
  }
  for (const TupleView& array : input.CellArrays)
  {
    part.CellArrays.push_back(Gather(array, marched.Cells));
  }
  if (options.Normals)
  {
    part.Gradients = AddGradients(input, marched);
  }
  part.Triangles.assign(marched.Triangles.begin(), marched.Triangles.end());
  return part;
}

//------------------------------------------------------------------------------
std::vector<SurfacePart> MakeSurfaceParts(const SurfaceInput& input, const SurfaceOptions& options,
  std::uint64_t tets, const std::function<bool(double)>& progress)
{
  const auto count = static_cast<std::size_t>((tets + TetsPerPart - 1) / TetsPerPart);
  std::vector<SurfacePart> parts(count);
  ParallelFor(
    count,
    [&](std::size_t i)
    {
      parts[i] = MakeSurfacePart(
        input, options, i * TetsPerPart, std::min<std::uint64_t>(tets, (i + 1) * TetsPerPart));
    },
    progress);
  return parts;
}

//------------------------------------------------------------------------------
void SetMarchValues(MarchInput& mesh, const TupleView& array, std::size_t tuples, int component,
  std::vector<double>& converted)
{
  const int wanted = array.Components == 1 ? 0 : component;
  if (array.Components == 1 && IsFloating(array.Type))
  {
    mesh.Values = array.Values;
    mesh.WideValues = array.Type == ScalarType::Float64;
    return;
  }
  converted.resize(tuples);
  WithComponent(array.Type, array.Values, array.Components, wanted,
    [&](auto&& getValue)
    {
      for (std::size_t i = 0; i < tuples; ++i)
      {
        converted[i] = getValue(i);
      }
    });
  mesh.Values = converted.data();
  mesh.WideValues = true;
}
}
