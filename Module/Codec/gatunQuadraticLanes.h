// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticLanes_h
#define gatunQuadraticLanes_h

// Eight least squares problems side by side in the lanes of vectors.

#include "gatunNeighborLists.h"

#include <cstddef>

namespace gatun
{
/** Neighbors of eight vertices. Lanes with fewer neighbors than others have weight 0 in the rest,
 * which changes no sum. */
struct QuadraticLanes
{
  static constexpr std::size_t Count = 8;
  using Lane = float[Count];

  std::size_t Neighbors = 0; // the most of all lanes

  alignas(32) Lane X[NeighborLists::MaxNeighbors];
  alignas(32) Lane Y[NeighborLists::MaxNeighbors];
  alignas(32) Lane Z[NeighborLists::MaxNeighbors];
  alignas(32) Lane Used[NeighborLists::MaxNeighbors];  // 1 or 0
  alignas(32) Lane PerNeighbor;                        // 3 / number of neighbors
  alignas(32) Lane Equal;                              // 1 / number of neighbors
  alignas(32) Lane Share[NeighborLists::MaxNeighbors]; // 1 or 0; the result is normalized

  alignas(32) Lane Quadratic[NeighborLists::MaxNeighbors]; // results
  alignas(32) Lane Linear[NeighborLists::MaxNeighbors];
};

/** The moments of the quadratic weights of eight vertices: how the functions err with third
 * derivatives. */
struct MomentLanes
{
  static constexpr std::size_t Count = 10;
  using Lane = QuadraticLanes::Lane;

  alignas(32) Lane X[NeighborLists::MaxNeighbors]; // as they were before the weights were found
  alignas(32) Lane Y[NeighborLists::MaxNeighbors];
  alignas(32) Lane Z[NeighborLists::MaxNeighbors];
  alignas(32) Lane Moment[Count]; // result
};

/** Neighbors by whose errors those of eight vertices are found. What is not set is 0. */
struct CorrectionLanes
{
  using Lane = QuadraticLanes::Lane;

  std::size_t Neighbors = 0; // the most of all lanes

  alignas(32) Lane Moment[NeighborLists::MaxCorrecting][MomentLanes::Count] = {};
  alignas(32) Lane Nearness[NeighborLists::MaxCorrecting] = {};
  alignas(32) Lane Own[MomentLanes::Count] = {};
  alignas(32) Lane Weight[NeighborLists::MaxCorrecting] = {}; // result
};

/** The results do not depend on the version. */
struct QuadraticKernels
{
  /** Computes the weights, and changes X, Y and Z. */
  void (*FindWeights)(QuadraticLanes& lanes);

  /** Computes the moments of the weights that were found. */
  void (*FindMoments)(const QuadraticLanes& lanes, MomentLanes& moments);

  void (*FindCorrections)(CorrectionLanes& lanes);
};

const QuadraticKernels& GetPortableQuadraticKernels();

/** Null if the compiler does not know AVX2. */
const QuadraticKernels* GetAVX2QuadraticKernels();

/** The fastest version that this processor has. */
const QuadraticKernels& GetBestQuadraticKernels();
}

#endif
