// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticFit_h
#define gatunQuadraticFit_h

#include "gatunNeighborLists.h"

#include <array>
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
  /** The neighbors of a vertex. Lists that are not empty are filled up to a multiple of Group with
   * the first neighbor and weights of 0, which change no sum. */
  struct Neighbors
  {
    static constexpr std::size_t Group = 4;

    std::size_t Count;
    const Vertex* Ids;
    const float* Quadratic; ///< weights of the values in the quadratic function
    const float* Linear;    ///< and in the linear one
    const float* Shares;    ///< of their errors in the error to expect; 0 for shared vertices
    const float* Corrections; ///< weights of the signed errors of the quadratic function, or null
  };

  /** places: coordinates of all vertices of the topology in the order of the walk. The calling
   * thread must have a FloatEnvironment. */
  QuadraticFit(
    const Topology& topology, NeighborLists::Places places, bool withCorrections = false);

  /** Of places that are all coded, in their order. */
  QuadraticFit(
    const NeighborLists& lists, NeighborLists::Places places, bool withCorrections = false);

  /** Of the points of a block. */
  explicit QuadraticFit(NeighborLists::Places places, bool withCorrections = false)
    : QuadraticFit(NeighborLists::OfBlock(places), places, withCorrections)
  {
  }

  /** As NeighborLists::Of. */
  Neighbors Of(std::size_t ownVertex) const
  {
    const auto start = this->Start[ownVertex];
    return { this->Start[ownVertex + 1] - start, this->Ids.data() + start,
      this->Quadratic.data() + start, this->Linear.data() + start, this->Shares.data() + start,
      this->HasCorrections() ? this->Corrections.data() + start : nullptr };
  }

  bool HasCorrections() const { return !this->Corrections.empty(); }

  bool HasNeighbors(std::size_t ownVertex) const
  {
    return this->Start[ownVertex] != this->Start[ownVertex + 1];
  }

  /** The memory of the lists. */
  std::size_t GetBytes() const
  {
    return this->Start.capacity() * sizeof(std::uint32_t) +
      this->Ids.capacity() * (sizeof(Vertex) + 3 * sizeof(float)) +
      this->Corrections.capacity() * sizeof(float);
  }

private:
  /** Of each vertex, for the corrections at others. */
  struct Moments
  {
    double Scale = 0; ///< of the offsets of neighbors, 0 if there are no moments
    std::array<float, 10> Values{};
  };

  void MakeLists(const NeighborLists& lists, bool withCorrections);
  void FindWeights(const NeighborLists& lists, NeighborLists::Places places,
    std::span<const Vertex> centers, std::span<const std::uint8_t> isShared, bool withCorrections);
  void FindCorrections(const NeighborLists& lists, NeighborLists::Places places,
    std::span<const Vertex> centers, std::span<const Moments> moments);

  std::vector<std::uint32_t> Start;
  // Apart, because not every mode needs all of them.
  std::vector<Vertex> Ids;
  std::vector<float> Quadratic, Linear, Shares, Corrections;
};

/** The weights of the cells around each cell, all cells being coded in their order. starts,
 * corners: as in NeighborLists::OfCells. points: coordinates of the corners. */
QuadraticFit FitCells(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners,
  NeighborLists::Places points, bool withCorrections = false);
}

#endif
