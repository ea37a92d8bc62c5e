// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurfaceCosts_h
#define gatunSurfaceCosts_h

#include "gatunMergeChoice.h"
#include "gatunMergeTriangles.h"
#include "gatunSurfaceQuadrics.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A surface while its points are merged, as MergeRounds needs it. */
class MergeSurface : public MergeTriangles
{
public:
  MergeSurface(const SurfaceMergeInput& input, const SurfaceMergeSettings& settings)
    : MergeTriangles(input, settings.KeepBorder)
    , Quadrics(*this, input, settings)
  {
  }

  /** Returns the position of a place, relative to the diagonal of the mesh. */
  SurfaceQuadrics::Vec GetPosition(std::uint32_t place) const
  {
    return this->Quadrics.GetPosition(this->GetFirstPoint(place));
  }

  /** Loads the first data that Choose reads into the cache of the processor. */
  void PrefetchRing(std::uint32_t place) const
  {
    this->MergeTriangles::PrefetchRing(place);
    this->Quadrics.Prefetch(this->GetFirstPoint(place));
  }

  /** Loads the points of the triangles around a place, which must be in the cache. */
  void PrefetchCorners(std::uint32_t place) const
  {
    for (const auto cell : this->GetRing(place))
    {
      for (const auto corner : this->GetCell(cell))
      {
        this->Quadrics.PrefetchSpot(this->GetFirstPoint(corner));
      }
    }
  }

  /** Merges all points of a place into those of a neighbor. */
  void Merge(std::uint32_t place, std::uint32_t into);

  SurfaceQuadrics Quadrics;
  std::vector<Pair> Pairs; ///< of points, in the order of their merges
};

/** Finds the best merge of a place of a surface. */
class SurfaceCosts
{
public:
  static constexpr std::uint8_t MostChanges = 3; // see MergeRounds
  static constexpr double ChangePerError = 1;

  explicit SurfaceCosts(const MergeSurface& mesh)
    : Mesh(mesh)
    , Marks(mesh.GetNumberOfPlaces(), 0)
  {
  }

  /** Returns the cheapest merge of a place that turns no triangle over, opens no seam, and
   * preserves the topology if that is checked. */
  MergeChoice Choose(std::uint32_t place, std::uint32_t tryFirst, bool checkTopology);

  /**
   * Whether merging a place into a neighbor preserves the topology: the intersection of their links
   * must be the link of their edge (Dey, Edelsbrunner, Guha, Nekhayev: Topology preserving edge
   * contraction, 1999). Links include one more point, which forms a triangle with each edge of the
   * border.
   */
  bool MayMerge(std::uint32_t place, std::uint32_t into);

private:
  using Vec = SurfaceQuadrics::Vec;
  static constexpr std::uint32_t None = MergeChoice::None;
  static constexpr std::uint32_t Several = None - 1;

  /** A mark of a neighbor of two places. Others count the triangles with the first one, times 2. */
  static constexpr std::uint32_t Shared = 1;

  struct Neighbor
  {
    std::uint32_t Place;
    std::uint32_t Triangles; // on the edge
    Vec Offset;
    double Cost;
    double Change;
  };

  /** A triangle around the place, without the place itself. */
  struct Triangle
  {
    std::uint32_t First, Second; // neighbors
    Vec Normal;                  // twice the area
  };

  void Gather(std::uint32_t place);
  void MarkNeighbors();
  std::uint32_t FindNeighbor(std::uint32_t place);
  void FindTargets();
  void SetTarget(std::uint32_t neighbor, std::uint32_t side, std::uint32_t point);
  void FindCost(std::size_t neighbor);
  bool ShareOppositeEdge(std::uint32_t place, std::uint32_t into, bool isOfBorder) const;
  bool TurnsNone(std::uint32_t neighbor) const;

  const MergeSurface& Mesh;
  std::vector<std::uint32_t> Marks; // of each place; 0 if it is not near, see MayMerge
  std::vector<Neighbor> Neighbors;
  std::vector<Triangle> Triangles;
  std::vector<std::uint32_t> Sides;   // the points of the place that have triangles
  std::vector<std::uint32_t> Targets; // of each neighbor, for each side
  std::uint32_t Place = 0;
  bool IsOnBorder = false;
};
}

#endif
