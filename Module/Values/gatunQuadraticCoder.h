// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticCoder_h
#define gatunQuadraticCoder_h

#include "gatunPointContext.h"
#include "gatunQuadraticPlaces.h"
#include "gatunQuadraticPredictor.h"

#include <cstddef>
#include <span>

namespace gatun
{
/**
 * Codes one component by the mode Quadratic. Changes are predicted as values are, by the changes at
 * neighbors. places: OwnPoints or AllPlaces. values: ExactValues or BoundedValues.
 */
template <typename Coder, typename PlacesOf, typename Values>
void CodeQuadratic(
  Coder& coder, TemporalMode temporal, const PlacesOf& places, Values&& values, ComponentKeys& keys)
{
  const auto& domain = values.GetDomain();
  const auto getBase = [&](Vertex v) { return GetBase(domain, temporal, keys, v); };
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
    Guess guess = MakeGuess(base, prediction.Number, keys, v);
    guess.Group = prediction.HasNeighbors ? 1 : 0;
    if (guess.HasNumber && prediction.HasError)
    {
      guess.Error = prediction.Error;
    }
    keys.Now[v] = values.Code(coder, guess, v, keys.Now[v]);
    predictor.Learn(v, domain.ToNumber(keys.Now[v]) - base);
  }
}
}

#endif
