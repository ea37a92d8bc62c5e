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
/** What it costs to merge a point into a neighbour; Into is None where that is not possible. */
struct MergeChoice
{
  std::uint32_t Into = MergeMesh::None;

  /** The change, by the number of tetrahedra that vanish: what is best does most for it. */
  double Cost = 0;

  /** The square of the change of the fields and of the shape, over the mesh, as a part of the
   * ranges and of the mesh. */
  double Change = 0;
};

/** Finds where points had best be merged to. */
class MergeCosts
{
public:
  MergeCosts(MergeMesh& mesh, const MergeInput& input, const MergeSettings& settings);

  /** The cheapest merge of a point that turns no tetrahedron or face over, and keeps the topology
   * if that is looked at. Faster if the neighbour that is tried first turns out to be a good one.
   */
  MergeChoice Choose(std::uint32_t point, std::uint32_t tryFirst, bool checkTopology);

private:
  using Vec = glm::dvec3;

  /** A field at a point of the mesh: the value, over the range and times the root of the weight,
   * and how it changes around there in the mesh that was given. */
  struct Sample
  {
    double Value = 0;
    Vec Gradient{ 0 };
  };

  /** A point that has an edge with the one at hand. */
  struct Neighbour
  {
    std::uint32_t Point;
    std::uint32_t Tets;      // that have both, and vanish by a merge
    bool OnBoundary = false; // whether the edge is
    Vec Offset;              // from the point at hand
  };

  /** A tetrahedron at the point at hand, as if that were anywhere: six times the volume is
   * dot(Normal, offset) + Volume, positive as it is now. */
  struct StarTet
  {
    Vec Normal;
    double Volume;
    double LeastVolume;
    double Weight;                        // of what changes in it
    std::array<std::uint32_t, 3> Corners; // as places among the neighbours
  };

  /** A face on the boundary, at the point. */
  struct Face
  {
    std::uint32_t First, Second; // as places among the neighbours
    Vec Normal;                  // of the length of twice the area
  };

  /** Of a point, among the neighbours of the one at hand, if the stamp is that of now. */
  struct Place
  {
    std::uint32_t Stamp = 0;
    std::uint32_t At = 0;
  };

  void SetScales();
  void FindSamples();
  double GetWeight(double volume) const;
  std::uint32_t GetPlace(std::uint32_t neighbour);
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
  double MeanWeight = 0;       // of a tetrahedron where all weigh alike
  std::vector<double> Scales;  // of the fields
  std::vector<Sample> Samples; // of each point, all fields
  std::vector<Place> Places;   // of each point
  std::uint32_t Stamp = 0;

  // Around the point at hand.
  std::vector<Neighbour> Neighbours;
  std::vector<Sample> Around; // of each neighbour, all fields, less the point's value
  std::vector<StarTet> Tets;
  std::vector<Vec> Slopes;                  // of each tetrahedron, all fields
  std::vector<std::array<double, 3>> Bends; // of the edges opposite to the point, likewise
  std::vector<double> Spokes;               // of the edges of a place at hand, likewise
  double BendBefore = 0;
  std::vector<Face> Faces;
};
}

#endif
