// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticPredictor_h
#define gatunQuadraticPredictor_h

#include "gatunQuadraticFit.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Predicts one number at each own vertex of a chunk, in the order of the walk: a quadratic fit, a
 * linear fit and the rule that predicted the coordinates, blended by the errors that each has made
 * at the neighbors. See Documentation/format.md, 10.10.
 *
 * Any numbers are valid. Those that are not finite are replaced by what was predicted there.
 */
class QuadraticPredictor
{
public:
  struct Prediction
  {
    double Number = 0;
    double Error = 0;          ///< to expect, if HasError
    bool HasNeighbors = false; ///< otherwise Number is the number before
    bool HasError = false;     ///< whether a neighbor was predicted, too
  };

  /** count: the number of vertices. */
  QuadraticPredictor(const QuadraticFit& fit, std::size_t count)
    : Fit(fit)
    , Numbers(count)
    , Errors(count)
  {
  }

  /** Sets the number at a shared vertex. To be called for all, ascending, before Predict. */
  void SetShared(Vertex v, double number)
  {
    this->LastShared = std::isfinite(number) ? number : this->LastShared;
    this->Numbers[v] = this->LastShared;
  }

  /** The numbers of all vertices that are known. */
  std::span<const double> GetNumbers() const { return this->Numbers; }

  /** Predicts the next own vertex. other: what another rule predicts from the numbers, if it does.
   */
  Prediction Predict(std::size_t own, std::optional<double> other)
  {
    Prediction result;
    const auto neighbors = this->Fit.Of(own);
    if (neighbors.empty())
    {
      result.Number = this->Last;
      this->Predicted = { this->Last, this->Last, this->Last, this->Last };
      return result;
    }
    // Differences from the nearest number, so that a constant is predicted exactly.
    const double first = this->Numbers[neighbors.front().Id];
    Double2 fits{}, errorsOfFits{}, errorsOfRest{};
    std::uint32_t bitsOfShares = 0;
    for (const auto& n : neighbors)
    {
      const double difference = this->Numbers[n.Id] - first;
      const double share = n.Share;
      const double* known = this->Errors[n.Id].data();
      fits += Double2{ n.Quadratic, n.Linear } * Double2{ difference, difference };
      errorsOfFits += Double2{ share, share } * Double2{ known[0], known[1] };
      errorsOfRest += Double2{ share, share } * Double2{ known[2], known[3] };
      bitsOfShares |= std::bit_cast<std::uint32_t>(n.Share);
    }
    const auto number = [first](double difference)
    {
      const double sum = first + difference;
      return std::isfinite(sum) ? sum : first;
    };
    const double a = number(fits[0]);
    const double b = number(fits[1]);
    const double c = other && std::isfinite(*other) ? *other : a;
    const double blend = Blend(a, b, c, errorsOfFits[0], errorsOfFits[1], errorsOfRest[0]);
    result.Number = std::isfinite(blend) ? blend : first;
    result.Error = errorsOfRest[1];
    result.HasNeighbors = true;
    result.HasError = bitsOfShares != 0; // no share is negative
    this->Predicted = { a, b, c, result.Number };
    return result;
  }

  /** Sets the number at the vertex that was predicted last. */
  void Learn(Vertex v, double number)
  {
    number = std::isfinite(number) ? number : this->Predicted[3];
    for (std::size_t k = 0; k < 4; ++k)
    {
      const double error = std::abs(number - this->Predicted[k]);
      this->Errors[v][k] = error <= MaxError ? error : MaxError;
    }
    this->Numbers[v] = number;
    this->Last = number;
  }

private:
  // As large as a register of every processor: sums in larger ones went through memory.
  using Double2 = double __attribute__((vector_size(16)));

  static constexpr double MaxError = 1e300;

  /** Mean of predictions with weights of 1 / error^4. */
  static double Blend(double a, double b, double c, double errorA, double errorB, double errorC)
  {
    // So that there is no division by zero. Errors in real data are either 0 or larger than this.
    constexpr double least = 1e-300;
    errorA += least;
    errorB += least;
    errorC += least;
    const double best = std::min(std::min(errorA, errorB), errorC);
    const auto weigh = [best](double error)
    {
      const double relative = best / error;
      const double square = relative * relative;
      return square * square;
    };
    const double weightA = weigh(errorA);
    const double weightB = weigh(errorB);
    const double weightC = weigh(errorC);
    return a + (weightB * (b - a) + weightC * (c - a)) / (weightA + weightB + weightC);
  }

  const QuadraticFit& Fit;
  std::vector<double> Numbers;
  std::vector<std::array<double, 4>> Errors; // of the three predictions and of the blend
  std::array<double, 4> Predicted{};
  double Last = 0;
  double LastShared = 0;
};
}

#endif
