// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticFit_h
#define gatunQuadraticFit_h

#include "gatunNeighborLists.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

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
  QuadraticFit(NeighborLists lists, NeighborLists::Places places);

  /** Of the points of a block. */
  explicit QuadraticFit(NeighborLists::Places places)
    : QuadraticFit(NeighborLists::OfBlock(places), places)
  {
  }

  /** As NeighborLists::Of. */
  Neighbors Of(std::size_t ownVertex) const
  {
    const std::size_t first = this->Lists.GetStart(ownVertex);
    return { this->Lists.Of(ownVertex), this->Quadratic.get() + first, this->Linear.get() + first,
      this->Shares.get() + first };
  }

  /** The memory of the lists and weights. */
  std::size_t GetBytes() const
  {
    return this->Lists.GetBytes() + 3 * sizeof(float) * this->Lists.GetNeighbors();
  }

private:
  void FindWeights(NeighborLists::Places places, std::span<const Vertex> centers,
    std::span<const std::uint8_t> isShared);

  NeighborLists Lists;
  // Apart, because the loop over a neighborhood waits for memory, and may need two of them only.
  std::unique_ptr<float[]> Quadratic;
  std::unique_ptr<float[]> Linear;
  std::unique_ptr<float[]> Shares;
};

/** The prediction of a function. first: the value at the nearest neighbor, so that a constant is
 * predicted exactly. difference: the weighted sum of the differences of other neighbors to it. */
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
