// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSurfaceQuadrics.h"

#include "gatunMergeRange.h"
#include "gatunTypes.h"
#include "gatunVector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gatun
{
namespace
{
/** The square of a distance counts so many times, beside the squares of the changes of fields: the
 * 32nd part of the diagonal is as much as the range of a field. */
constexpr double DistanceWeight = 1000;

/** Weights of planes that hold edges in place, beside those of triangles, for the square of the
 * length of the edge. */
constexpr double BorderWeight = 5;
constexpr double EdgeWeight = 0.5; // of features and seams

/** Fields on triangles that are thinner than this part of their longest edge have no gradient that
 * means anything. */
constexpr double ThinnestWithGradient = 1e-3;

/** Adds v v, times a weight, to the upper half of a symmetric matrix. */
void AddSquare(double* square, const glm::dvec3& v, double weight)
{
  const glm::dvec3 w = weight * v;
  square[0] += w.x * v.x;
  square[1] += w.x * v.y;
  square[2] += w.x * v.z;
  square[3] += w.y * v.y;
  square[4] += w.y * v.z;
  square[5] += w.z * v.z;
}

glm::dvec3 Multiply(const double* square, const glm::dvec3& v)
{
  return { square[0] * v.x + square[1] * v.y + square[2] * v.z,
    square[1] * v.x + square[3] * v.y + square[4] * v.z,
    square[2] * v.x + square[4] * v.y + square[5] * v.z };
}

glm::dvec3 Load(const double* v)
{
  return { v[0], v[1], v[2] };
}
}

//------------------------------------------------------------------------------
SurfaceQuadrics::SurfaceQuadrics(
  const MergeTriangles& mesh, const SurfaceMergeInput& input, const SurfaceMergeSettings& settings)
  : Fields(input.Fields.size())
  , Stride(Slopes + 4 * this->Fields)
  , Spots(input.Points.size() * (3 + this->Fields))
  , Sums(input.Points.size() * this->Stride, 0.0)
{
  // Twice, so that halves of both are as much as one of them.
  const double fieldWeight = 2 * (1 - settings.ShapeWeight);
  const double shapeWeight = this->Fields > 0 ? 2 * settings.ShapeWeight * DistanceWeight : 1;
  this->FindPositions(input);
  this->FindValues(input, fieldWeight);
  this->AddTriangles(mesh, shapeWeight);
  this->AddEdges(mesh, shapeWeight, settings.FeatureAngle);
}

//------------------------------------------------------------------------------
void SurfaceQuadrics::FindPositions(const SurfaceMergeInput& input)
{
  Bounds box;
  const auto include = [&](std::uint32_t point)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double x = input.Points[point][axis];
      if (std::isfinite(x))
      {
        box[axis].Include(x);
      }
    }
  };
  for (const auto& cell : input.Cells)
  {
    std::for_each(cell.begin(), cell.end(), include);
  }
  const Vec low(box[0].Min, box[1].Min, box[2].Min);
  const double diagonal = glm::length(Vec(box[0].Max, box[1].Max, box[2].Max) - low);
  const double scale = diagonal > 0 && std::isfinite(diagonal) ? 1 / diagonal : 0;
  for (std::size_t point = 0; point < input.Points.size(); ++point)
  {
    const Vec place = scale * (ToVector(input.Points[point]) - low);
    double* const spot = this->Spots.data() + point * (3 + this->Fields);
    spot[0] = place.x;
    spot[1] = place.y;
    spot[2] = place.z;
  }
}

//------------------------------------------------------------------------------
void SurfaceQuadrics::FindValues(const SurfaceMergeInput& input, double weight)
{
  const auto scales = FindFieldScales(input.Fields);
  const double root = std::sqrt(weight);
  for (std::size_t f = 0; f < this->Fields; ++f)
  {
    const auto& values = input.Fields[f].Values;
    for (std::size_t point = 0; point < values.size(); ++point)
    {
      this->Spots[point * (3 + this->Fields) + 3 + f] = root * scales[f] * values[point];
    }
  }
}

//------------------------------------------------------------------------------
void SurfaceQuadrics::AddPlane(std::uint32_t point, const Vec& normal, double weight)
{
  AddSquare(this->At(point), normal, weight);
}

//------------------------------------------------------------------------------
void SurfaceQuadrics::AddTriangles(const MergeTriangles& mesh, double shapeWeight)
{
  double area = 0;
  for (std::uint32_t cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const auto& c = mesh.GetCell(cell);
    if (c[0] != MergeTriangles::None)
    {
      const Vec origin = this->GetPlace(mesh, c[0]);
      const double twice = glm::length(
        glm::cross(this->GetPlace(mesh, c[1]) - origin, this->GetPlace(mesh, c[2]) - origin));
      area += std::isfinite(twice) ? twice / 2 : 0;
    }
  }
  this->PerArea = area > 0 ? 1 / area : 0;
  std::vector<Vec> slopes(this->Fields);
  for (std::uint32_t cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const auto& c = mesh.GetCell(cell);
    if (c[0] == MergeTriangles::None)
    {
      continue;
    }
    const Vec origin = this->GetPlace(mesh, c[0]);
    const Vec a = this->GetPlace(mesh, c[1]) - origin;
    const Vec b = this->GetPlace(mesh, c[2]) - origin;
    const Vec cross = glm::cross(a, b);
    const double twice = glm::length(cross);
    const double longest = std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(b - a, b - a) });
    if (twice == 0)
    {
      continue;
    }
    const Vec normal = cross / twice;
    const double weight = twice / 6 * this->PerArea; // a third for each corner
    const double* const v0 = this->GetValues(mesh.GetPoint(cell, 0));
    const double* const v1 = this->GetValues(mesh.GetPoint(cell, 1));
    const double* const v2 = this->GetValues(mesh.GetPoint(cell, 2));
    const bool hasSlopes = !(twice < ThinnestWithGradient * longest);
    for (std::size_t f = 0; f < this->Fields; ++f)
    {
      slopes[f] = hasSlopes
        ? ((v1[f] - v0[f]) * glm::cross(b, normal) + (v2[f] - v0[f]) * glm::cross(normal, a)) /
          twice
        : Vec(0);
    }
    for (unsigned corner = 0; corner < 3; ++corner)
    {
      double* const sums = this->At(mesh.GetPoint(cell, corner));
      AddSquare(sums, normal, shapeWeight * weight);
      sums[Weight] += weight;
      for (std::size_t f = 0; f < this->Fields; ++f)
      {
        AddSquare(sums, slopes[f], weight);
        double* const slope = sums + Slopes + 4 * f;
        slope[0] += weight * slopes[f].x;
        slope[1] += weight * slopes[f].y;
        slope[2] += weight * slopes[f].z;
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Planes through edges, perpendicular to their triangles. */
void SurfaceQuadrics::AddEdges(const MergeTriangles& mesh, double shapeWeight, double featureAngle)
{
  const double least = std::cos(featureAngle * std::numbers::pi / 180);
  struct Edge
  {
    std::uint32_t Other, Cell;
    unsigned Corner; // the one at the place
    bool operator<(const Edge& e) const
    {
      return this->Other != e.Other ? this->Other < e.Other : this->Cell < e.Cell;
    }
  };
  const auto getNormal = [&](std::uint32_t cell)
  {
    const auto& c = mesh.GetCell(cell);
    const Vec n = glm::cross(this->GetPlace(mesh, c[1]) - this->GetPlace(mesh, c[0]),
      this->GetPlace(mesh, c[2]) - this->GetPlace(mesh, c[0]));
    const double length = glm::length(n);
    return length > 0 ? n / length : Vec(0);
  };
  std::vector<Edge> edges;
  for (std::uint32_t place = 0; place < mesh.GetNumberOfPlaces(); ++place)
  {
    edges.clear();
    for (const auto cell : mesh.GetRing(place))
    {
      const auto& c = mesh.GetCell(cell);
      const unsigned at = MergeTriangles::FindKnownCorner(c, place);
      for (const unsigned i : { (at + 1) % 3, (at + 2) % 3 })
      {
        if (c[i] > place)
        {
          edges.push_back({ c[i], cell, at });
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next)
    {
      for (next = i; next < edges.size() && edges[next].Other == edges[i].Other;)
      {
        ++next;
      }
      const auto getEnd = [&](const Edge& e) {
        return mesh.GetPoint(
          e.Cell, MergeTriangles::FindKnownCorner(mesh.GetCell(e.Cell), e.Other));
      };
      double weight = BorderWeight;
      if (next - i == 2)
      {
        const Edge& e = edges[i];
        const Edge& f = edges[i + 1];
        const bool isSeam = mesh.GetPoint(e.Cell, e.Corner) != mesh.GetPoint(f.Cell, f.Corner) ||
          getEnd(e) != getEnd(f);
        // Triangles with the same orientation pass their edge in opposite directions.
        const bool isAhead = mesh.GetCell(e.Cell)[(e.Corner + 1) % 3] == e.Other;
        const bool isAheadToo = mesh.GetCell(f.Cell)[(f.Corner + 1) % 3] == f.Other;
        const double cosine = glm::dot(getNormal(e.Cell), getNormal(f.Cell));
        const bool isFeature = (isAhead == isAheadToo ? -cosine : cosine) < least;
        weight = isSeam || isFeature ? EdgeWeight : 0;
      }
      for (; weight > 0 && i < next; ++i)
      {
        const Edge& e = edges[i];
        const Vec along = this->GetPlace(mesh, e.Other) - this->GetPlace(mesh, place);
        const double length = glm::length(along);
        const Vec normal = glm::cross(along, getNormal(e.Cell)) / length;
        if (length > 0 && std::isfinite(length))
        {
          const double w = shapeWeight * weight * length * length * this->PerArea;
          this->AddPlane(mesh.GetPoint(e.Cell, e.Corner), normal, w);
          this->AddPlane(getEnd(e), normal, w);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
double SurfaceQuadrics::GetError(std::uint32_t point, std::uint32_t into, const Vec& offset) const
{
  const double* const sums = this->At(point);
  double error =
    glm::dot(Multiply(sums, offset) + 2.0 * Load(sums + Mixed), offset) + sums[Constant];
  const double* const from = this->GetValues(point);
  const double* const to = this->GetValues(into);
  double squares = 0;
  for (std::size_t f = 0; f < this->Fields; ++f)
  {
    const double* const slope = sums + Slopes + 4 * f;
    const double step = to[f] - from[f];
    error -= 2 * step * (glm::dot(Load(slope), offset) + slope[3]);
    squares += step * step;
  }
  error += sums[Weight] * squares;
  return error < 0 ? 0 : error; // NaN stays
}

//------------------------------------------------------------------------------
void SurfaceQuadrics::Add(std::uint32_t point, std::uint32_t into, const Vec& offset)
{
  double* const from = this->At(point);
  double* const to = this->At(into);
  const double constant = this->GetError(point, into, offset);
  Vec mixed = Load(from + Mixed) + Multiply(from, offset);
  for (std::size_t f = 0; f < this->Fields; ++f)
  {
    double* const slope = from + Slopes + 4 * f;
    const double step = this->GetValues(into)[f] - this->GetValues(point)[f];
    mixed -= step * Load(slope);
    slope[3] += glm::dot(Load(slope), offset) - step * from[Weight];
  }
  from[Mixed] = mixed.x;
  from[Mixed + 1] = mixed.y;
  from[Mixed + 2] = mixed.z;
  from[Constant] = constant;
  for (std::size_t i = 0; i < this->Stride; ++i)
  {
    to[i] += from[i];
  }
}
}
