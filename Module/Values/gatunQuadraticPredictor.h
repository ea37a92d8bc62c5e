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
/** The prediction for a number. */
struct QuadraticPrediction
{
  double Number = 0;
  double Error = 0;          ///< to expect, if HasError
  bool HasNeighbors = false; ///< otherwise Number is the number before
  bool HasError = false;     ///< whether the errors of neighbors are known
};

/**
 * Predicts one number at each own vertex of a chunk, in the order of the walk: blends a quadratic
 * fit with a linear fit and the rule that predicted the coordinates, by the errors that each has
 * made at the neighbors. See Documentation/format.md, 10.10.
 *
 * Any numbers are valid. Values that are not finite are replaced by their predictions.
 */
class QuadraticPredictor
{
public:
  /** count: the number of vertices. */
  QuadraticPredictor(const QuadraticFit& fit, std::size_t count)
    : Fit(fit)
    , Numbers(count)
    , Errors(count)
  {
  }

  /** Sets the number at a shared vertex. To be called for all, ascending, before Predict. One that
   * is not finite is replaced by the one before. */
  void SetShared(Vertex v, double number)
  {
    this->LastShared = std::isfinite(number) ? number : this->LastShared;
    this->Numbers[v] = this->LastShared;
  }

  /** Predicts the next own vertex. other: returns the prediction of another rule from the numbers
   * of all vertices, as an optional double. */
  template <typename Other>
  QuadraticPrediction Predict(std::size_t own, const Other& other)
  {
    QuadraticPrediction result;
    const auto neighbors = this->Fit.Of(own);
    if (neighbors.Ids.empty())
    {
      result.Number = this->Last;
      this->Predicted = { this->Last, this->Last, this->Last, this->Last };
      return result;
    }
    const double first = this->Numbers[neighbors.Ids.front()];
    const Sums sums = this->SumUp(neighbors, first);
    const double a = AddDifference(first, sums.Fits[0]);
    const double b = AddDifference(first, sums.Fits[1]);
    const std::optional<double> found = other(std::span<const double>(this->Numbers));
    const double c = found && std::isfinite(*found) ? *found : a;
    const double blend =
      Blend(a, b, c, sums.ErrorsOfFits[0], sums.ErrorsOfFits[1], sums.ErrorsOfRest[0]);
    result.Number = std::isfinite(blend) ? blend : first;
    result.Error = sums.ErrorsOfRest[1];
    result.HasNeighbors = true;
    result.HasError = sums.Shares != 0; // no share is negative
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
  // Vectors are as large as registers of every processor, and the loop is a function of its own:
  // else sums go through memory, which takes twice as long.
  using Double2 = double __attribute__((vector_size(16)));

  struct Sums
  {
    Double2 Fits{}; // quadratic and linear
    Double2 ErrorsOfFits{};
    Double2 ErrorsOfRest{};
    std::uint32_t Shares = 0; // the bits of any
  };

  [[gnu::noinline]] Sums SumUp(const QuadraticFit::Neighbors& neighbors, double first) const
  {
    const double* numbers = this->Numbers.data();
    Double2 fits{}, errorsOfFits{}, errorsOfRest{};
    std::uint32_t shares = 0;
    for (std::size_t i = 0; i < neighbors.GetCount(); ++i)
    {
      const Vertex id = neighbors.Ids[i];
      const double difference = numbers[id] - first;
      const double share = neighbors.Shares[i];
      const double* known = this->Errors[id].data();
      fits +=
        Double2{ neighbors.Quadratic[i], neighbors.Linear[i] } * Double2{ difference, difference };
      errorsOfFits += Double2{ share, share } * Double2{ known[0], known[1] };
      errorsOfRest += Double2{ share, share } * Double2{ known[2], known[3] };
      shares |= std::bit_cast<std::uint32_t>(neighbors.Shares[i]);
    }
    return { fits, errorsOfFits, errorsOfRest, shares };
  }

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
  std::vector<double> Numbers; // that are known, all finite
  double Last = 0;             // of own vertices
  double LastShared = 0;
  std::vector<std::array<double, 4>> Errors; // of the three predictions and of the blend
  std::array<double, 4> Predicted{};
};
}

#endif
