// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeCosts_h
#define gatunMergeCosts_h

#include "gatunMergeBuilder.h"
#include "gatunMergeMesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** What it costs to merge a point into a neighbour; Into is None where that is not possible. */
struct MergeChoice
{
  std::uint32_t Into = MergeMesh::None;
  double Cost = 0;
};

/** Finds where points had best be merged to. */
class MergeCosts
{
public:
  MergeCosts(MergeMesh& mesh, const MergeInput& input, const MergeSettings& settings);

  /** The cheapest merge of a point that turns no tetrahedron or face over and keeps the topology.
   */
  MergeChoice Choose(std::uint32_t point);

private:
  using Vec = std::array<double, 3>;

  /** The tetrahedra around the point at hand, as if it were anywhere: six times the volume is
   * Normal . (x - point) + Volume, positive as it is now. */
  struct Star
  {
    std::vector<double> NormalX, NormalY, NormalZ, Volume, LeastVolume;
    std::vector<std::array<std::uint32_t, 3>> Corners; // as places among the neighbours
    std::vector<double> Sums;                          // of the fields' values at the corners
  };

  /** A face on the boundary, at the point. */
  struct Face
  {
    std::uint32_t First, Second; // as places among the neighbours
    Vec Normal;                  // of the length of twice the area
  };

  void Gather(std::uint32_t point);
  void GatherFaces(std::uint32_t point);
  std::uint32_t GetPlace(std::uint32_t neighbour);
  double GetDataCost(std::uint32_t place, const Vec& offset);
  double GetGeometryCost(std::uint32_t place, const Vec& offset) const;

  MergeMesh& Mesh;
  const MergeInput& Input;
  const MergeSettings& Settings;
  double PerWhole = 0;                // 1 / volume of the mesh
  std::vector<double> Weights;        // of the fields, over their ranges
  std::vector<std::uint32_t> PlaceOf; // of each point among the neighbours
  std::vector<std::uint32_t> Stamps;
  std::uint32_t Stamp = 0;

  std::vector<std::uint32_t> Neighbours;
  std::vector<Vec> Offsets;         // of the neighbours from the point
  std::vector<char> OnBoundaryEdge; // of the neighbours: whether the edge to them is
  Star Tets;
  std::vector<Face> Faces;
  std::vector<double> Before, After; // of each field
  std::vector<MergeChoice> Choices;
};
}

#endif
