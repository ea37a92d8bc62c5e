// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticFit_h
#define gatunQuadraticFit_h

#include "gatunNeighborLists.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
struct Topology;

/**
 * The weights by which a quadratic and a linear function, both fitted to the nearest known places
 * around a place, predict its value. See Documentation/format.md, 10.9. They depend on the
 * mesh alone, so that all arrays and time steps of a chunk share them.
 */
class QuadraticFit
{
public:
  struct Neighbor
  {
    Vertex Id;
    float Quadratic; ///< weight of the value in the quadratic function
    float Linear;    ///< and in the linear one
    float Share;     ///< of the neighbor's error in the error to expect; 0 for shared vertices
  };

  /** places: coordinates of all vertices of the topology in the order of the walk. The calling
   * thread must have a FloatEnvironment. */
  QuadraticFit(const Topology& topology, NeighborLists::Places places);

  /** Of places that are all coded, in their order. */
  QuadraticFit(const NeighborLists& lists, NeighborLists::Places places);

  /** Of the points of a block. */
  explicit QuadraticFit(NeighborLists::Places places)
    : QuadraticFit(NeighborLists::OfBlock(places), places)
  {
  }

  /** As NeighborLists::Of. */
  std::span<const Neighbor> Of(std::size_t ownVertex) const
  {
    return { this->List.data() + this->Start[ownVertex],
      this->Start[ownVertex + 1] - this->Start[ownVertex] };
  }

  /** The memory of the lists. */
  std::size_t GetBytes() const
  {
    return this->Start.capacity() * sizeof(std::uint32_t) +
      this->List.capacity() * sizeof(Neighbor);
  }

private:
  void FindWeights(const NeighborLists& lists, NeighborLists::Places places,
    std::span<const Vertex> centers, std::span<const std::uint8_t> isShared);

  std::vector<std::uint32_t> Start;
  std::vector<Neighbor> List;
};

/** The weights of the cells around each cell, all cells being coded in their order. starts,
 * corners: as in NeighborLists::OfCells. points: coordinates of the corners. */
QuadraticFit FitCells(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners,
  NeighborLists::Places points);
}

#endif
