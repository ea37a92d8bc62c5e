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

  // From the center: along x, y and z. 0 where there is no neighbor.
  alignas(32) double Offsets[3][NeighborLists::MaxNeighbors][Count];
  alignas(32) Lane Size; // the number of neighbors

  // The offsets in other units, and then without the distortion of the neighborhood.
  alignas(32) Lane X[NeighborLists::MaxNeighbors];
  alignas(32) Lane Y[NeighborLists::MaxNeighbors];
  alignas(32) Lane Z[NeighborLists::MaxNeighbors];
  alignas(
    32) Lane Near[NeighborLists::MaxNeighbors]; // more where a neighbor is near; 0 where none is
  alignas(32) Lane PerNeighbor;                 // 3 / number of neighbors
  alignas(32) Lane Equal;                       // 1 / number of neighbors
  alignas(32) Lane Share[NeighborLists::MaxNeighbors]; // 1 or 0; the result is normalized

  alignas(32) Lane Quadratic[NeighborLists::MaxNeighbors]; // results
  alignas(32) Lane Linear[NeighborLists::MaxNeighbors];
};

/** Computes the weights. The results do not depend on the version. */
using FindQuadraticWeights = void (*)(QuadraticLanes& lanes);

FindQuadraticWeights GetPortableQuadraticWeights();

/** Null if the compiler does not know AVX2. */
FindQuadraticWeights GetAVX2QuadraticWeights();

/** The fastest version that this processor has. */
FindQuadraticWeights GetBestQuadraticWeights();
}

#endif
