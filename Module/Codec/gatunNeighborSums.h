// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNeighborSums_h
#define gatunNeighborSums_h

#include "gatunQuadraticFit.h"

#include <optional>

namespace gatun
{
/** What QuadraticPredictor sums up over the neighbors of a vertex. */
struct NeighborErrors
{
  double Quadratic = 0; ///< difference from the first neighbor
  double Linear = 0;    ///< likewise
  double Errors[4] = {};
  bool HasErrors = false;
  double Corrected = 0;  ///< expected error of the corrected quadratic function
  double Correction = 0; ///< expected signed error of the quadratic one
};

/** Sums over the neighbors of a vertex, which must have some. The results do not depend on the
 * version. */
struct NeighborSums
{
  /** Predicts a number by the quadratic weights. See Documentation/format.md, 10.11. */
  double (*PredictOne)(const QuadraticFit::Neighbors& neighbors, const double* numbers);

  /** Predicts four numbers. Vertex v has the numbers from numbers[4 * v] on. */
  void (*PredictFour)(
    const QuadraticFit::Neighbors& neighbors, const double* numbers, double* predicted);

  /** The sums of 10.10. Vertex v has the errors from errors[4 * v] on. */
  NeighborErrors (*SumErrors)(
    const QuadraticFit::Neighbors& neighbors, const double* numbers, const double* errors);

  /** The sums of 10.12. Vertex v has the errors from errors[8 * v] on. */
  NeighborErrors (*SumCorrected)(
    const QuadraticFit::Neighbors& neighbors, const double* numbers, const double* errors);
};

NeighborSums GetPortableNeighborSums();

/** None if the compiler does not know AVX2. */
std::optional<NeighborSums> GetAVX2NeighborSums();

/** The fastest version that this processor has. */
const NeighborSums& GetBestNeighborSums();
}

#endif
