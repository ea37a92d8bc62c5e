// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticPlaces_h
#define gatunQuadraticPlaces_h

// Common parts of the quadratic modes: the places whose values are coded, and the key from which a
// value is predicted.

#include "gatunGuess.h"
#include "gatunPointContext.h"
#include "gatunQuadraticFit.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace gatun
{
/** The own points of a chunk. */
struct OwnPoints
{
  const PointContext& Context;

  const QuadraticFit& GetFit() const { return *this->Context.Quadratic; }
  std::size_t GetNumber() const { return this->Context.OwnIds.size(); }
  Vertex GetPlace(std::size_t own) const { return this->Context.OwnIds[own]; }
  bool IsKnown(Vertex v) const { return this->Context.Mesh->IsShared(v); }
  std::optional<double> Predict(std::size_t own, std::span<const double> numbers) const
  {
    return PredictByGate(this->Context, own, numbers);
  }
};

/** The cells of a chunk, or the points of a block. */
struct AllPlaces
{
  const CellContext& Context;
  std::size_t Number;

  const QuadraticFit& GetFit() const { return *this->Context.Quadratic; }
  std::size_t GetNumber() const { return this->Number; }
  static Vertex GetPlace(std::size_t i) { return static_cast<Vertex>(i); }
  static bool IsKnown(Vertex) { return false; }
  std::optional<double> Predict(std::size_t i, std::span<const double> numbers) const
  {
    const auto from = this->Context.IsBlock() || this->Context.Parents[i] == Topology::NoTet
      ? static_cast<std::uint32_t>(i) - 1 // wraps around for the first one
      : this->Context.Parents[i];
    return from < i ? std::optional(numbers[from]) : std::nullopt;
  }
};

/** The number from which the number at a place is counted: that at the step before with the mode
 * Change, else 0. Perhaps not finite. */
template <typename AnyDomain>
double GetBase(const AnyDomain& domain, TemporalMode temporal, const ComponentKeys& keys, Vertex v)
{
  return temporal == TemporalMode::Change ? domain.ToNumber(keys.Before[v]) : 0.0;
}

/** The prediction at a place: a number, or the previous key if the base is not finite. */
inline Guess MakeGuess(double base, double predicted, const ComponentKeys& keys, Vertex v)
{
  Guess guess;
  if (std::isfinite(base))
  {
    guess.SetNumber(base + predicted);
  }
  else
  {
    guess.Predicted = keys.Before[v];
  }
  return guess;
}
}

#endif
