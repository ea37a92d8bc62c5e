// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticPredictor_h
#define gatunQuadraticPredictor_h

#include "gatunNeighborSums.h"
#include "gatunQuadraticFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** What is predicted for a number. */
struct QuadraticPrediction
{
  double Number = 0;
  double Error = 0;          ///< to expect, if HasError
  bool HasNeighbors = false; ///< otherwise Number is the number before
  bool HasError = false;     ///< whether the errors of neighbors are known
};

/** The numbers of a component that are known while it is coded. All are finite. */
class QuadraticNumbers
{
public:
  /** count: the number of vertices. */
  QuadraticNumbers(const QuadraticFit& fit, std::size_t count)
    : Fit(fit)
    , Numbers(count)
  {
  }

  /** Sets the number at a shared vertex. To be called for all, ascending, before Predict. One that
   * is not finite is replaced by the one before. */
  void SetShared(Vertex v, double number)
  {
    this->LastShared = std::isfinite(number) ? number : this->LastShared;
    this->Numbers[v] = this->LastShared;
  }

protected:
  /** first: the number at the nearest neighbor, so that a constant is predicted exactly. */
  static double Add(double first, double difference)
  {
    const double sum = first + difference;
    return std::isfinite(sum) ? sum : first;
  }

  /** Mean of predictions with weights of 1 / error^4. */
  template <std::size_t Count>
  static double Blend(
    const std::array<double, Count>& predictions, std::array<double, Count> errors)
  {
    // So that there is no division by zero. Errors in real data are either 0 or larger than this.
    constexpr double least = 1e-300;
    double best = std::numeric_limits<double>::infinity();
    for (double& error : errors)
    {
      error += least;
      best = std::min(best, error);
    }
    const auto weigh = [best](double error)
    {
      const double relative = best / error;
      const double square = relative * relative;
      return square * square;
    };
    double weights = weigh(errors[0]);
    double sum = -0.0; // added to a number, it changes nothing
    for (std::size_t k = 1; k < Count; ++k)
    {
      const double weight = weigh(errors[k]);
      weights += weight;
      sum += weight * (predictions[k] - predictions[0]);
    }
    return predictions[0] + sum / weights;
  }

  static constexpr double MaxError = 1e300;
  static double LimitError(double error)
  {
    return std::abs(error) <= MaxError ? std::abs(error) : MaxError;
  }

  void Set(Vertex v, double number)
  {
    this->Numbers[v] = number;
    this->Last = number;
  }

  const NeighborSums& Sums = GetBestNeighborSums();
  const QuadraticFit& Fit;
  std::vector<double> Numbers;
  double Last = 0; // of own vertices

private:
  double LastShared = 0;
};

/**
 * Predicts one number at each own vertex of a chunk, in the order of the walk, by a quadratic fit.
 * See Documentation/format.md, 10.11.
 *
 * Any numbers are valid. Those that are not finite are replaced by what was predicted there.
 */
class PlainQuadraticPredictor : public QuadraticNumbers
{
public:
  using QuadraticNumbers::QuadraticNumbers;

  /** Predicts the next own vertex. */
  template <typename Other>
  QuadraticPrediction Predict(std::size_t own, const Other&)
  {
    QuadraticPrediction result;
    const auto neighbors = this->Fit.Of(own);
    result.HasNeighbors = neighbors.Count > 0;
    result.Number = this->Last;
    if (result.HasNeighbors)
    {
      result.Number = this->Sums.PredictOne(neighbors, this->Numbers.data());
    }
    this->Predicted = result.Number;
    return result;
  }

  /** Sets the number at the vertex that was predicted last. */
  void Learn(Vertex v, double number)
  {
    this->Set(v, std::isfinite(number) ? number : this->Predicted);
  }

private:
  double Predicted = 0;
};

/**
 * Predicts as PlainQuadraticPredictor does, but blends the quadratic fit with a linear fit and the
 * rule that predicted the coordinates, by the errors that each has made at the neighbors. See
 * Documentation/format.md, 10.10.
 */
class QuadraticPredictor : public QuadraticNumbers
{
public:
  QuadraticPredictor(const QuadraticFit& fit, std::size_t count)
    : QuadraticNumbers(fit, count)
    , Errors(4 * count)
  {
  }

  /** Predicts the next own vertex. other: gives what another rule predicts from the numbers of all
   * vertices, as an optional double. */
  template <typename Other>
  QuadraticPrediction Predict(std::size_t own, const Other& other)
  {
    QuadraticPrediction result;
    const auto neighbors = this->Fit.Of(own);
    if (neighbors.Count == 0)
    {
      result.Number = this->Last;
      this->Predicted = { this->Last, this->Last, this->Last, this->Last };
      return result;
    }
    const double first = this->Numbers[neighbors.Ids[0]];
    const auto sums = this->Sums.SumErrors(neighbors, this->Numbers.data(), this->Errors.data());
    const double a = Add(first, sums.Quadratic);
    const double b = Add(first, sums.Linear);
    const std::optional<double> found = other(std::span<const double>(this->Numbers));
    const double c = found && std::isfinite(*found) ? *found : a;
    const double blend =
      Blend<3>({ a, b, c }, { sums.Errors[0], sums.Errors[1], sums.Errors[2] });
    result.Number = std::isfinite(blend) ? blend : first;
    result.Error = sums.Errors[3];
    result.HasNeighbors = true;
    result.HasError = sums.HasErrors;
    this->Predicted = { a, b, c, result.Number };
    return result;
  }

  /** Sets the number at the vertex that was predicted last. */
  void Learn(Vertex v, double number)
  {
    number = std::isfinite(number) ? number : this->Predicted[3];
    for (std::size_t k = 0; k < 4; ++k)
    {
      this->Errors[4 * static_cast<std::size_t>(v) + k] = LimitError(number - this->Predicted[k]);
    }
    this->Set(v, number);
  }

private:
  std::vector<double> Errors; // four for each vertex: of the three predictions and of the blend
  std::array<double, 4> Predicted{};
};

/**
 * Predicts as QuadraticPredictor does, and blends the quadratic function corrected by its errors at
 * the neighbors, too. See Documentation/format.md, 10.12. The fit must have corrections.
 */
class CorrectedPredictor : public QuadraticNumbers
{
public:
  CorrectedPredictor(const QuadraticFit& fit, std::size_t count)
    : QuadraticNumbers(fit, count)
    , Errors(Stride * count)
  {
  }

  /** As that of QuadraticPredictor. */
  template <typename Other>
  QuadraticPrediction Predict(std::size_t own, const Other& other)
  {
    QuadraticPrediction result;
    const auto neighbors = this->Fit.Of(own);
    if (neighbors.Count == 0)
    {
      result.Number = this->Last;
      this->Predicted.fill(this->Last);
      return result;
    }
    const double first = this->Numbers[neighbors.Ids[0]];
    const auto sums =
      this->Sums.SumCorrected(neighbors, this->Numbers.data(), this->Errors.data());
    const double a = Add(first, sums.Quadratic);
    const double b = Add(first, sums.Linear);
    const std::optional<double> found = other(std::span<const double>(this->Numbers));
    const double c = found && std::isfinite(*found) ? *found : a;
    const double d = Add(a, sums.Correction);
    const double blend = Blend<4>({ a, b, c, d },
      { sums.Errors[0], sums.Errors[1], sums.Errors[2], sums.Corrected });
    result.Number = std::isfinite(blend) ? blend : first;
    result.Error = sums.Errors[3];
    result.HasNeighbors = true;
    result.HasError = sums.HasErrors;
    this->Predicted = { a, b, c, result.Number, d };
    return result;
  }

  /** Sets the number at the vertex that was predicted last. */
  void Learn(Vertex v, double number)
  {
    number = std::isfinite(number) ? number : this->Predicted[3];
    double* errors = this->Errors.data() + Stride * static_cast<std::size_t>(v);
    for (std::size_t k = 0; k < this->Predicted.size(); ++k)
    {
      errors[k] = LimitError(number - this->Predicted[k]);
    }
    errors[5] = std::copysign(errors[0], number - this->Predicted[0]);
    this->Set(v, number);
  }

private:
  static constexpr std::size_t Stride = 8;

  // Of the predictions a, b, c, of the blend, and of d; and the signed one of a.
  std::vector<double> Errors;
  std::array<double, 5> Predicted{};
};
}

#endif
