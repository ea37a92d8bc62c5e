// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticCoder_h
#define gatunQuadraticCoder_h

#include "gatunComponentCoder.h"
#include "gatunGuess.h"
#include "gatunPlainQuadratic.h"
#include "gatunPointContext.h"
#include "gatunQuadraticPredictor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

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

/** Codes one component by a predictor. */
template <typename Predictor, typename Coder, typename PlacesOf, typename Values>
void CodeByPredictor(
  Coder& coder, TemporalMode temporal, const PlacesOf& places, Values&& values, ComponentKeys& keys)
{
  const auto& domain = values.GetDomain();
  const bool isChange = temporal == TemporalMode::Change;
  const auto getBase = [&](Vertex v) { return isChange ? domain.ToNumber(keys.Before[v]) : 0.0; };
  Predictor predictor(places.GetFit(), keys.Now.size());
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

/** Predicts chosen components by the mode PlainQuadratic. use: as in EachPlainValue. */
template <typename PlacesOf, typename Use>
void EachPlainValue(const PlacesOf& places, TemporalMode temporal,
  std::span<const std::size_t> chosen, std::span<const Domain> domains,
  std::span<ComponentKeys> components, Use&& use)
{
  const auto run = [&]<typename AnyDomain>(auto&& makeDomain, const AnyDomain*)
  {
    std::vector<PlainComponent<AnyDomain>> together;
    for (const auto c : chosen)
    {
      together.push_back({ makeDomain(domains[c]), &components[c] });
    }
    EachPlainValue<PlacesOf, AnyDomain>(places, temporal, together, use);
  };
  const auto all = [&](bool (*matches)(const Domain&))
  {
    return std::all_of(
      chosen.begin(), chosen.end(), [&](std::size_t c) { return matches(domains[c]); });
  };
  if (all(Float32Domain::Matches))
  {
    run([](const Domain&) { return Float32Domain(); }, static_cast<Float32Domain*>(nullptr));
  }
  else if (all(ShiftedFloat32Domain::Matches))
  {
    run([](const Domain& domain) { return ShiftedFloat32Domain(domain); },
      static_cast<ShiftedFloat32Domain*>(nullptr));
  }
  else
  {
    run([](const Domain& domain) { return domain; }, static_cast<Domain*>(nullptr));
  }
}

/** Codes components by the mode PlainQuadratic. */
template <typename Coder, typename PlacesOf>
void CodePlainQuadratic(Coder& coder, TemporalMode temporal, const PlacesOf& places,
  std::span<const Domain> domains, std::span<ComponentKeys> components, bool onLattice)
{
  static thread_local std::vector<Residuals> residuals; // as the memory in EachPlainValue
  residuals.resize(std::max(residuals.size(), components.size()));
  std::vector<std::size_t> exact;
  bool isLastOpen = false; // whether the residuals of the last one are not decoded yet
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    auto& keys = components[c];
    if (!CodeIsExact(coder, domains[c], keys))
    {
      CodeByPredictor<PlainQuadraticPredictor>(
        coder, temporal, places, MakeBoundedValues(domains[c], onLattice, keys), keys);
      continue;
    }
    exact.push_back(c);
    isLastOpen = !Coder::Encoding && c + 1 == components.size();
    if (isLastOpen)
    {
      continue;
    }
    residuals[c].resize(places.GetNumber());
    if (Coder::Encoding)
    {
      EachPlainValue(places, temporal, std::array{ c }, domains, components,
        [&](std::size_t, std::size_t place, const auto& domain, Key predicted, Key key)
        { residuals[c][place] = domain.Subtract(key, predicted); });
    }
    CodeResiduals(coder, places.GetFit(), residuals[c]);
  }
  if (!Coder::Encoding && !exact.empty())
  {
    ResidualSequence last;
    EachPlainValue(places, temporal, exact, domains, components,
      [&](std::size_t i, std::size_t place, const auto& domain, Key predicted, Key& key)
      {
        const bool isOpen = isLastOpen && i + 1 == exact.size();
        key = domain.Add(predicted,
          isOpen ? last.Code(coder, places.GetFit().HasNeighbors(place), 0)
                 : residuals[exact[i]][place]);
        if (!domain.IsValid(key))
        {
          ThrowCorrupt("a value is not in the palette");
        }
      });
  }
}

/**
 * Codes components by one of the quadratic modes. Changes are predicted as values are, by
 * the changes at neighbors. places: OwnPoints or AllPlaces. onLattice: whether values with a bound
 * of errors are on its lattice.
 */
template <typename Coder, typename PlacesOf>
void CodeQuadratic(Coder& coder, SpatialMode spatial, TemporalMode temporal, const PlacesOf& places,
  std::span<const Domain> domains, std::span<ComponentKeys> components, bool onLattice)
{
  if (spatial == SpatialMode::PlainQuadratic)
  {
    CodePlainQuadratic(coder, temporal, places, domains, components, onLattice);
    return;
  }
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    CodeComponent(coder, domains[c], onLattice, components[c],
      [&](auto&& values)
      {
        if (spatial == SpatialMode::Corrected)
        {
          CodeByPredictor<CorrectedPredictor>(coder, temporal, places, values, components[c]);
        }
        else
        {
          CodeByPredictor<QuadraticPredictor>(coder, temporal, places, values, components[c]);
        }
      });
  }
}
}

#endif
