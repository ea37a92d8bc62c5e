// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeCosts_h
#define gatunMergeCosts_h

#include "gatunLocalIndex.h"
#include "gatunMergeInput.h"
#include "gatunMergeMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** The best merge of a point into a neighbor; Into is None if there is none. */
struct MergeChoice
{
  std::uint32_t Into = MergeMesh::None;

  /** The change divided by the number of tetrahedra that vanish. */
  double Cost = 0;

  /** The square of the change of the fields and of the shape, integrated over the mesh, relative to
   * the ranges of the fields and to the volume. */
  double Change = 0;
};

/** What is around the current point. */
class MergeStar
{
protected:
  using Vec = glm::dvec3;

  /** A field at a point of the mesh: the value, divided by the range and times the square root of
   * the weight, and the gradient there in the given mesh. */
  struct Sample
  {
    double Value = 0;
    Vec Gradient{ 0 };
  };

  /** A point with an edge to the current one. */
  struct Neighbor
  {
    std::uint32_t Point;
    std::uint32_t Tets;      // with both points; they vanish by a merge
    bool OnBoundary = false; // whether the edge is
    Vec Offset;              // from the current point
  };

  /** A tetrahedron of the current point, as a function of the position of that point: six times the
   * volume is dot(Normal, offset) + Volume, and positive at offset 0. */
  struct StarTet
  {
    Vec Normal;
    double Volume;
    double Weight;                        // of changes in it
    std::array<std::uint32_t, 3> Corners; // as places among the neighbors
  };

  /** The change of a field by a merge as a quadratic function of the offset and the value of the
   * neighbor: the sum of Weight * (error - dot(slope, offset))^2 over all tetrahedra. Error is the
   * deviation of the value from the gradient at the point, and slopes are relative to that
   * gradient. Tetrahedra that vanish add nothing, as their field meets the value. */
  struct Quadric
  {
    double Weight = 0;
    Vec Linear{ 0 };
    Vec Squares{ 0 };  // of xx, yy, zz
    Vec Products{ 0 }; // of xy, yz, zx

    void Add(double weight, const Vec& slope);

    /** Returns no more than the sum, in spite of rounding. */
    double GetBound(double error, const Vec& offset) const;
  };

  /** The bends of the three edges of a tetrahedron that are opposite to the current point. */
  struct OppositeBends
  {
    std::array<double, 3> Edges;
    double Sum;
    double Squares; // their sum
  };

  /** A boundary face of the current point. */
  struct Face
  {
    std::uint32_t First, Second; // as places among the neighbors
    Vec Normal;                  // its length is twice the area
  };
};

/** Finds the best merge of a point. NumberOfFields is that of the input, or 0 for any. */
template <std::size_t NumberOfFields>
class MergeCosts : private MergeStar
{
public:
  MergeCosts(MergeMesh& mesh, const MergeInput& input, const MergeSettings& settings);

  /** Returns the cheapest merge of a point that turns no tetrahedron or face over, and preserves
   * the topology if that is checked. A good first neighbor to try makes this faster. */
  MergeChoice Choose(std::uint32_t point, std::uint32_t tryFirst, bool checkTopology);

private:
  std::size_t GetFields() const { return NumberOfFields > 0 ? NumberOfFields : this->Fields; }
  void SetScales();
  void FindSamples();
  void AddSlopes(const MergeMesh::Tet& corners, double volume);
  const Vec& GetPoint(std::uint32_t point) const;
  const Sample* GetSamples(std::uint32_t point) const;
  double GetWeight(double volume) const;
  std::uint32_t GetPlace(std::uint32_t neighbor);
  void Gather(std::uint32_t point);
  void GatherFields(std::uint32_t point);
  void GatherFaces(std::uint32_t point);
  void GatherBends(std::uint32_t point);
  void FindBounds(std::uint32_t point);
  double GetLeastFieldChange(const Sample* here, std::uint32_t place) const;
  std::uint32_t TakeCandidate(double mostCost);
  void Try(std::uint32_t point, std::uint32_t place, bool checkTopology, MergeChoice& best);
  static bool WouldInvert(const StarTet& tet, double volume);
  double GetFieldWeight(bool onBoundary) const;
  double GetLengthCost(const Neighbor& into) const;
  double GetFieldChange(std::uint32_t place, double enough) const;
  double GetMeanSquare(const StarTet& tet, std::size_t index, std::size_t field) const;
  double GetBendChange(std::uint32_t place, double enough);
  double GetShapeChange(std::uint32_t place) const;

  MergeMesh& Mesh;
  const MergeInput& Input;
  const MergeSettings& Settings;
  std::size_t Fields = 0;
  double PerWhole = 0;         // 1 / volume of the mesh
  double MeanWeight = 0;       // of a tetrahedron, if all have the same weight
  std::vector<double> Scales;  // of the fields
  std::vector<Sample> Samples; // of each point, all fields, after one with its place

  // Around the current point.
  LocalIndex Places; // of points among the neighbors, plus one
  std::vector<Neighbor> Neighbors;
  std::vector<Sample> Around; // of each neighbor, all fields, minus the value of the point
  std::vector<StarTet> Tets;
  std::vector<Vec> Slopes;          // of each tetrahedron, all fields
  std::vector<Quadric> Quadrics;    // of each field
  std::vector<double> Bounds;       // lower bounds of the costs, of each neighbor
  std::vector<OppositeBends> Bends; // of each tetrahedron, all fields
  std::vector<double> Spokes;       // bends of the edges of the current place, of each neighbor
  bool HasBends = false;            // whether Bends and BendBefore are those of the point
  double BendBefore = 0;
  double BendWeight = 0;
  std::vector<Face> Faces;
};

extern template class MergeCosts<0>;
extern template class MergeCosts<1>;
}

#endif
