// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticFit_h
#define gatunQuadraticFit_h

#include "gatunNeighborLists.h"

#include <cmath>
#include <cstddef>
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
  /** The neighbors of a place. */
  struct Neighbors
  {
    std::span<const Vertex> Ids;
    const float* Quadratic; ///< weight of each value in the quadratic function
    const float* Linear;    ///< and in the linear one
    const float* Shares;    ///< of its error in the error to expect; 0 for shared vertices

    std::size_t GetCount() const { return this->Ids.size(); }
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
  Neighbors Of(std::size_t ownVertex) const
  {
    const std::size_t first = this->Start[ownVertex];
    return { { this->Ids.data() + first, this->Start[ownVertex + 1] - first },
      this->Quadratic.data() + first, this->Linear.data() + first, this->Shares.data() + first };
  }

  /** The memory of the lists. */
  std::size_t GetBytes() const
  {
    return this->Start.capacity() * sizeof(std::uint32_t) + this->Ids.capacity() * sizeof(Vertex) +
      (this->Quadratic.capacity() + this->Linear.capacity() + this->Shares.capacity()) *
      sizeof(float);
  }

private:
  void FindWeights(const NeighborLists& lists, NeighborLists::Places places,
    std::span<const Vertex> centers, std::span<const std::uint8_t> isShared);

  std::vector<std::uint32_t> Start;
  // Apart, because the loop over a neighborhood waits for memory, and may need two of them only.
  std::vector<Vertex> Ids;
  std::vector<float> Quadratic;
  std::vector<float> Linear;
  std::vector<float> Shares;
};

/** The number that a function predicts. first: that at the nearest neighbor, so that a constant is
 * predicted exactly. difference: the weighted sum of what other neighbors have more. */
inline double AddDifference(double first, double difference)
{
  const double sum = first + difference;
  return std::isfinite(sum) ? sum : first;
}

/** The weights of the cells around each cell, all cells being coded in their order. starts,
 * corners: as in NeighborLists::OfCells. points: coordinates of the corners. */
QuadraticFit FitCells(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners,
  NeighborLists::Places points);
}

#endif
