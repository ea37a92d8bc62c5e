// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurfaceQuadrics_h
#define gatunSurfaceQuadrics_h

#include "gatunLargeArray.h"
#include "gatunMergeInput.h"
#include "gatunMergeTriangles.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * Quadrics of the points of a surface. That of a point is the weighted sum, over the triangles of
 * the given mesh that have been merged into it, of the square distances to their planes and to the
 * linear fields on them. It is a function of a position and of the values of the fields.
 *
 * Positions are relative to the diagonal of the mesh, and values to their range. The weight of a
 * triangle is its share of the area. Each quadric has its origin at the position and the values of
 * its point, where the triangles of the point have no error, so that rounding does not matter.
 *
 * Based on: Garland, Heckbert: Surface simplification using quadric error metrics. SIGGRAPH 1997.
 * Garland, Heckbert: Simplifying surfaces with color and texture using quadric error metrics.
 * Visualization 1998. Hoppe: New quadric metric for simplifying meshes with appearance attributes.
 * Visualization 1999.
 */
class SurfaceQuadrics
{
public:
  using Vec = glm::dvec3;

  SurfaceQuadrics(const MergeTriangles& mesh, const SurfaceMergeInput& input,
    const SurfaceMergeSettings& settings);

  /** Returns the position of a point, relative to the diagonal. */
  Vec GetPosition(std::uint32_t point) const
  {
    const double* const spot = this->GetSpot(point);
    return { spot[0], spot[1], spot[2] };
  }

  /** The weighted square error of a point after it has been merged into another one, at the other
   * end of an edge. */
  double GetError(std::uint32_t point, std::uint32_t into, const Vec& offset) const;

  /** The sum of the weights of the triangles of a point. It is 1 for the whole mesh. */
  double GetWeight(std::uint32_t point) const { return this->At(point)[Weight]; }

  void Prefetch(std::uint32_t point) const
  {
    __builtin_prefetch(this->At(point));
    __builtin_prefetch(this->At(point) + 8);
  }
  void PrefetchSpot(std::uint32_t point) const { __builtin_prefetch(this->GetSpot(point)); }

  /** Adds the quadric of a point to that of another one. */
  void Add(std::uint32_t point, std::uint32_t into, const Vec& offset);

private:
  // With n the normal of a triangle, e its error, g and f those of a field: places of the sums of
  // n n + g g (symmetric), n e + g f, e e + f f, 1, and then of each field, of g and f.
  enum Sum : std::size_t
  {
    Square = 0,
    Mixed = 6,
    Constant = 9,
    Weight = 10,
    Slopes = 11
  };

  double* At(std::uint32_t point) { return this->Sums.data() + point * this->Stride; }
  const double* At(std::uint32_t point) const { return this->Sums.data() + point * this->Stride; }
  const double* GetSpot(std::uint32_t point) const
  {
    return this->Spots.data() + point * (3 + this->Fields);
  }
  Vec GetPlace(const MergeTriangles& mesh, std::uint32_t place) const
  {
    return this->GetPosition(mesh.GetFirstPoint(place));
  }
  const double* GetValues(std::uint32_t point) const { return this->GetSpot(point) + 3; }
  void FindPositions(const SurfaceMergeInput& input);
  void FindValues(const SurfaceMergeInput& input, double weight);
  void AddTriangles(const MergeTriangles& mesh, double shapeWeight);
  void AddEdges(const MergeTriangles& mesh, double shapeWeight, double featureAngle);
  void AddPlane(std::uint32_t point, const Vec& normal, double weight);

  std::size_t Fields;
  std::size_t Stride;
  double PerArea = 0;
  LargeArray<double> Spots; // position and values of each point
  LargeArray<double> Sums;  // of each point
};
}

#endif
