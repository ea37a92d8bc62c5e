// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticFit_h
#define gatunQuadraticFit_h

#include "gatunNeighborLists.h"

#include <algorithm>
#include <array>
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
  struct Neighbor
  {
    Vertex Id;
    float Quadratic; ///< weight of the value in the quadratic function
    float Linear;    ///< and in the linear one
    float Share;     ///< of the neighbor's error in the error to expect; 0 for shared vertices
  };

  /** places: coordinates of all vertices of the topology in the order of the walk. The calling
   * thread must have a FloatEnvironment. withCorrections: for the mode CorrectedQuadratic; they
   * take about as long as the rest. */
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
  std::span<const Neighbor> Of(std::size_t ownVertex) const
  {
    return { this->List.data() + this->Start[ownVertex],
      this->Start[ownVertex + 1] - this->Start[ownVertex] };
  }

  /** The weights of the signed errors that the quadratic function made at each of these neighbors,
   * in the error to expect of it. See Documentation/format.md, 10.12. Needs HasCorrections. */
  const float* CorrectionsOf(std::size_t ownVertex) const
  {
    return this->Corrections.data() + this->Start[ownVertex];
  }

  bool HasCorrections() const { return this->IsCorrected; }

  /** The memory of the lists. */
  std::size_t GetBytes() const
  {
    return this->Start.capacity() * sizeof(std::uint32_t) +
      this->List.capacity() * sizeof(Neighbor) + this->Corrections.capacity() * sizeof(float);
  }

private:
  /** How the quadratic function of a place errs with third derivatives. */
  struct Moments
  {
    double Scale = 0; // of the offsets of its neighbors; 0: there are no moments
    std::array<float, 10> Values{};
  };

  std::span<const Neighbor> GetCorrecting(std::size_t ownVertex) const
  {
    const auto all = this->Of(ownVertex);
    return all.first(std::min(all.size(), NeighborLists::MaxCorrecting));
  }

  void FindWeights(const NeighborLists& lists, NeighborLists::Places places,
    std::span<const Vertex> centers, std::span<const std::uint8_t> isShared, bool withCorrections);
  void FindCorrections(NeighborLists::Places places, std::span<const Vertex> centers,
    std::span<const Moments> moments);

  std::vector<std::uint32_t> Start;
  std::vector<Neighbor> List;
  std::vector<float> Corrections; // of each element of List, if IsCorrected
  bool IsCorrected = false;
};

/** The weights of the cells around each cell, all cells being coded in their order. starts,
 * corners: as in NeighborLists::OfCells. points: coordinates of the corners. */
QuadraticFit FitCells(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners,
  NeighborLists::Places points, bool withCorrections = false);
}

#endif
