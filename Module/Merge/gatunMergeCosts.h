// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeCosts_h
#define gatunMergeCosts_h

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

/** Finds the best merge of a point. */
class MergeCosts
{
public:
  MergeCosts(MergeMesh& mesh, const MergeInput& input, const MergeSettings& settings);

  /** Returns the cheapest merge of a point that turns no tetrahedron or face over, and preserves
   * the topology if that is checked. A good first neighbor to try makes this faster. */
  MergeChoice Choose(std::uint32_t point, std::uint32_t tryFirst, bool checkTopology);

private:
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
    double LeastVolume;
    double Weight;                        // of changes in it
    std::array<std::uint32_t, 3> Corners; // as places among the neighbors
  };

  /** A boundary face of the current point. */
  struct Face
  {
    std::uint32_t First, Second; // as places among the neighbors
    Vec Normal;                  // its length is twice the area
  };

  /** The place of a point among the neighbors of the current one, if the stamp is up to date. */
  struct Place
  {
    std::uint32_t Stamp = 0;
    std::uint32_t At = 0;
  };

  void SetScales();
  void FindSamples();
  double GetWeight(double volume) const;
  std::uint32_t GetPlace(std::uint32_t neighbor);
  void Gather(std::uint32_t point);
  void GatherFields(std::uint32_t point);
  void GatherFaces(std::uint32_t point);
  double GetBend(const Sample& a, const Sample& b, const Vec& edge) const;
  void Try(std::uint32_t point, std::uint32_t place, bool checkTopology, MergeChoice& best);
  double GetFieldChange(std::uint32_t place, double enough) const;
  double GetBendChange(std::uint32_t place, double enough);
  double GetShapeChange(std::uint32_t place) const;

  MergeMesh& Mesh;
  const MergeInput& Input;
  const MergeSettings& Settings;
  std::size_t Fields = 0;
  double PerWhole = 0;         // 1 / volume of the mesh
  double MeanWeight = 0;       // of a tetrahedron, if all have the same weight
  std::vector<double> Scales;  // of the fields
  std::vector<Sample> Samples; // of each point, all fields
  std::vector<Place> Places;   // of each point
  std::uint32_t Stamp = 0;

  // Around the current point.
  std::vector<Neighbor> Neighbors;
  std::vector<Sample> Around; // of each neighbor, all fields, minus the value of the point
  std::vector<StarTet> Tets;
  std::vector<Vec> Slopes;                  // of each tetrahedron, all fields
  std::vector<std::array<double, 3>> Bends; // of the edges opposite to the point, likewise
  std::vector<double> Spokes;               // of the edges of the current place, likewise
  double BendBefore = 0;
  std::vector<Face> Faces;
};
}

#endif
