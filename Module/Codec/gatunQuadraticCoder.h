// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticCoder_h
#define gatunQuadraticCoder_h

#include "gatunGuess.h"
#include "gatunPointContext.h"
#include "gatunQuadraticPredictor.h"

#include <cmath>
#include <cstddef>

namespace gatun
{

/** The own points of a chunk, for CodeQuadratic. */
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

/**
 * Codes one component by the mode Quadratic. Changes are predicted as values are, by the changes at
 * neighbors. places: OwnPoints or AllPlaces. values: ExactValues or BoundedValues.
 */
template <typename Coder, typename PlacesOf, typename Values>
void CodeQuadratic(
  Coder& coder, TemporalMode temporal, const PlacesOf& places, Values&& values, ComponentKeys& keys)
{
  const auto& domain = values.GetDomain();
  const bool isChange = temporal == TemporalMode::Change;
  const auto getBase = [&](Vertex v) { return isChange ? domain.ToNumber(keys.Before[v]) : 0.0; };
  QuadraticPredictor predictor(places.GetFit(), keys.Now.size());
  for (Vertex v = 0; v < keys.Now.size(); ++v)
  {
    if (places.IsKnown(v))
    {
      predictor.SetShared(v, domain.ToNumber(keys.Now[v]) - getBase(v));
    }
  }
  for (std::size_t own = 0; own < places.GetNumber(); ++own)
  {
    const Vertex v = places.GetPlace(own);
    const double base = getBase(v);
    const auto prediction = predictor.Predict(
      own, [&](std::span<const double> numbers) { return places.Predict(own, numbers); });
    Guess guess;
    guess.Group = prediction.HasNeighbors ? 1 : 0;
    if (std::isfinite(base))
    {
      guess.SetNumber(base + prediction.Number);
      guess.Error = prediction.HasError ? prediction.Error : -1;
    }
    else
    {
      guess.Predicted = keys.Before[v];
    }
    keys.Now[v] = values.Code(coder, guess, v, keys.Now[v]);
    predictor.Learn(v, domain.ToNumber(keys.Now[v]) - base);
  }
}
}

#endif
