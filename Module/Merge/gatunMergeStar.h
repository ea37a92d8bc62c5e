// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeStar_h
#define gatunMergeStar_h

#include "gatunMergeFields.h"
#include "gatunMergeLanes.h"
#include "gatunMergeMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A point with an edge to the current one. */
struct MergeNeighbor
{
  std::uint32_t Point;
  std::uint32_t Tets; // with both points; they vanish by a merge
  bool OnBoundary;    // whether the edge is
  glm::dvec3 Offset;  // from the current point
};

/** A boundary face of the current point. */
struct MergeFace
{
  std::uint32_t First, Second; // as places among the neighbors
  glm::dvec3 Normal;           // its length is twice the area
};

/** The change of a field by a merge as a quadratic function of the offset and the value of the
 * neighbor: the sum of Weight * (error - dot(slope, offset))^2 over all tetrahedra. Error is the
 * deviation of the value from the gradient at the point, and slopes are relative to that
 * gradient. Tetrahedra that vanish add nothing, as their field meets the value. */
struct MergeQuadric
{
  double Weight = 0;
  glm::dvec3 Linear{ 0 };
  glm::dvec3 Squares{ 0 };  // of xx, yy, zz
  glm::dvec3 Products{ 0 }; // of xy, yz, zx

  /** The rounding errors of a bound, relative to the sum of the absolute values of its terms. */
  static constexpr double Margin = 1e-10;

  /** Returns no more than the sum, in spite of rounding. */
  double GetBound(double error, const glm::dvec3& offset) const;

  /** Its sums, with a lane for every other tetrahedron. */
  struct Sums
  {
    Double2 Weight = Splat2(0);
    Triple<Double2> Linear{ Splat2(0), Splat2(0), Splat2(0) };
    Triple<Double2> Squares{ Splat2(0), Splat2(0), Splat2(0) };
    Triple<Double2> Products{ Splat2(0), Splat2(0), Splat2(0) };

    GATUN_INLINE void Add(Double2 weight, const Triple<Double2>& slope)
    {
      const Triple<Double2> weighted = weight * slope;
      this->Weight = this->Weight + weight;
      this->Linear = this->Linear + weighted;
      this->Squares = this->Squares +
        Triple<Double2>{ weighted.X * slope.X, weighted.Y * slope.Y, weighted.Z * slope.Z };
      this->Products = this->Products +
        Triple<Double2>{ weighted.X * slope.Y, weighted.Y * slope.Z, weighted.Z * slope.X };
    }

    MergeQuadric GetSum() const;
  };
};

/** Four tetrahedra of the current point, as functions of the position of that point: six times the
 * volume is dot(Normal, offset) + Volume, and positive at offset 0. The rest is filled with copies
 * of the last one without weight. */
struct MergeTets
{
  std::array<Triple<Double2>, 2> Normal;
  std::array<Double2, 2> Volume;
  std::array<Double2, 2> Least;  // larger volumes are fine; infinite for flat ones and copies
  std::array<Double2, 2> Weight; // of changes in it
  std::array<UInt4, 3> Corners;  // as places among the neighbors
  Int4 Present;                  // a mask: not for copies
};

/** The gradients of a field in four tetrahedra, relative to that at the point. */
using MergeSlopes = std::array<Triple<Double2>, 2>;

/** The surroundings of a point. NumberOfFields is that of the input, or 0 for any. */
template <std::size_t NumberOfFields>
class MergeStar
{
public:
  using Vec = glm::dvec3;
  using Sample = MergeFields::Sample;

  MergeStar(const MergeMesh& mesh, const MergeFields& fields, MergeMetric metric);

  std::size_t GetFields() const { return NumberOfFields > 0 ? NumberOfFields : this->Fields; }
  void Gather(std::uint32_t point);

  /** Returns the place of a point among the neighbors, or None. */
  std::uint32_t GetPlace(std::uint32_t neighbor) const
  {
    return neighbor == MergeMesh::None ? MergeMesh::None : this->Places[neighbor] - 1;
  }

  const MergeMesh& Mesh;
  const MergeFields& Given;

  const std::size_t Fields;

  // The weight of a tetrahedron is a part of six times its volume, plus a constant.
  const double PerVolume;
  const double PerTet;

  // Around the current point.
  std::vector<MergeNeighbor> Neighbors;
  std::vector<Sample> Around; // of each neighbor, all fields, relative to the gradient at the point
  std::size_t NumberOfTets = 0;
  std::vector<MergeTets> Tets;        // in blocks
  std::vector<MergeSlopes> Slopes;    // of each block, all fields
  std::vector<MergeQuadric> Quadrics; // of each field
  std::vector<MergeFace> Faces;
  double Coarser = 1; // the volume of the tetrahedra now, relative to that in the given mesh

private:
  void GatherCorners(std::uint32_t point);
  void GatherNeighbors(std::uint32_t point);
  void GatherTets();
  void GatherFaces(std::uint32_t point);

  struct Corner
  {
    std::uint32_t Point;
    std::uint32_t Tets; // with both points
  };

  std::vector<std::uint32_t> Places; // of each point of the mesh, plus one; 0 if it is none
  std::vector<Corner> Corners;       // scratch
  double Before = 0;                 // volume around the point in the given mesh
  std::vector<MergeQuadric::Sums> Sums;
};

extern template class MergeStar<0>;
extern template class MergeStar<1>;
}

#endif
