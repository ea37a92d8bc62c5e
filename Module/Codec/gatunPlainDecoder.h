// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPlainDecoder_h
#define gatunPlainDecoder_h

// Faster decoding of exact values with several components in the mode PlainQuadratic. A residual
// depends on no prediction there. So all are decoded first, and then the values of several
// components at a place are found side by side, by one loop over its neighbors.

#include "gatunExactValues.h"
#include "gatunPointContext.h"
#include "gatunQuadraticPredictor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace gatun
{
/** Decodes up to four components. The result is that of CodeByPredictor with a
 * PlainQuadraticPredictor for one component after the other. */
template <typename AnyDomain, typename PlacesOf>
class PlainDecoder
{
public:
  static constexpr std::size_t MaxComponents = 4;

  PlainDecoder(TemporalMode temporal, const PlacesOf& places, std::span<const AnyDomain> domains,
    std::span<ComponentKeys> components)
    : IsChange(temporal == TemporalMode::Change)
    , Places(places)
    , Domains(domains)
    , Components(components)
    , Numbers(components.front().Now.size())
  {
  }

  /** residuals: for each component those of the own places, in their order. */
  void Decode(std::span<const std::vector<std::int64_t>> residuals)
  {
    this->SetKnown();
    const auto& fit = this->Places.GetFit();
    for (std::size_t own = 0; own < this->Places.GetNumber(); ++own)
    {
      const Vertex v = this->Places.GetPlace(own);
      const auto neighbors = fit.Of(own);
      if (neighbors.Ids.empty())
      {
        for (std::size_t c = 0; c < this->Components.size(); ++c)
        {
          this->Set(v, c, this->Last[c], residuals[c][own]);
        }
        continue;
      }
      const auto& first = this->Numbers[neighbors.Ids.front()];
      const Lanes sums = this->SumUp(neighbors, first);
      for (std::size_t c = 0; c < this->Components.size(); ++c)
      {
        const double sum = first[c] + sums[c];
        this->Set(v, c, std::isfinite(sum) ? sum : first[c], residuals[c][own]);
      }
    }
  }

private:
  using Double2 = double __attribute__((vector_size(16)));

  /** The numbers of four components. */
  struct Lanes
  {
    double operator[](std::size_t c) const { return this->Halves[c / 2][c % 2]; }
    void Set(std::size_t c, double number) { this->Halves[c / 2][c % 2] = number; }

    std::array<Double2, 2> Halves{};
  };

  double GetBase(Vertex v, std::size_t c) const
  {
    return this->IsChange ? this->Domains[c].ToNumber(this->Components[c].Before[v]) : 0.0;
  }

  /** The numbers of places that are known from the beginning, as QuadraticNumbers::SetShared. */
  void SetKnown()
  {
    for (std::size_t c = 0; c < this->Components.size(); ++c)
    {
      double last = 0;
      for (Vertex v = 0; v < this->Numbers.size(); ++v)
      {
        if (this->Places.IsKnown(v))
        {
          const double number =
            this->Domains[c].ToNumber(this->Components[c].Now[v]) - this->GetBase(v, c);
          last = std::isfinite(number) ? number : last;
          this->Numbers[v].Set(c, last);
        }
      }
    }
  }

  /** As PlainQuadraticPredictor::SumUp, for each component. */
  Lanes SumUp(const QuadraticFit::Neighbors& neighbors, const Lanes& first) const
  {
    const Lanes* numbers = this->Numbers.data();
    const std::size_t count = neighbors.GetCount();
    std::array<Lanes, 4> sums;
    const auto add = [&](std::size_t k, std::size_t i)
    {
      const double weight = neighbors.Quadratic[i];
      const auto& there = numbers[neighbors.Ids[i]];
      for (std::size_t half = 0; half < 2; ++half)
      {
        sums[k].Halves[half] +=
          Double2{ weight, weight } * (there.Halves[half] - first.Halves[half]);
      }
    };
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4)
    {
      add(0, i);
      add(1, i + 1);
      add(2, i + 2);
      add(3, i + 3);
    }
    for (; i < count; ++i)
    {
      add(i % 4, i);
    }
    Lanes result;
    for (std::size_t half = 0; half < 2; ++half)
    {
      result.Halves[half] = (sums[0].Halves[half] + sums[1].Halves[half]) +
        (sums[2].Halves[half] + sums[3].Halves[half]);
    }
    return result;
  }

  /** Sets the value that is a residual away from what is predicted. */
  void Set(Vertex v, std::size_t c, double predicted, std::int64_t residual)
  {
    const auto& domain = this->Domains[c];
    auto& keys = this->Components[c];
    const double base = this->GetBase(v, c);
    const Key key = ExactValues<AnyDomain>::AddTo(
      domain, std::isfinite(base) ? domain.FromNumber(base + predicted) : keys.Before[v], residual);
    keys.Now[v] = key;
    const double number = domain.ToNumber(key) - base;
    this->Last[c] = std::isfinite(number) ? number : predicted;
    this->Numbers[v].Set(c, this->Last[c]);
  }

  const bool IsChange;
  const PlacesOf& Places;
  const std::span<const AnyDomain> Domains;
  const std::span<ComponentKeys> Components;
  std::vector<Lanes> Numbers;
  std::array<double, MaxComponents> Last{}; // of own places
};

/** Decodes all components of a stream. domains: none has a quantizer. */
template <typename PlacesOf>
void DecodePlain(EntropyDecoder& coder, TemporalMode temporal, const PlacesOf& places,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  const auto& fit = places.GetFit();
  const bool areFloats = std::all_of(
    domains.begin(), domains.end(), [](const Domain& d) { return Float32Domain::Matches(d); });
  constexpr std::array<Float32Domain, PlainDecoder<Float32Domain, PlacesOf>::MaxComponents> floats;
  for (std::size_t first = 0; first < components.size(); first += floats.size())
  {
    const auto some = components.subspan(first, std::min(floats.size(), components.size() - first));
    std::vector<std::vector<std::int64_t>> residuals(some.size());
    for (auto& list : residuals)
    {
      ExactValues<Float32Domain> values{ {} }; // a residual does not depend on the domain
      list.resize(places.GetNumber());
      for (std::size_t own = 0; own < list.size(); ++own)
      {
        list[own] = values.DecodeResidual(coder, fit.Of(own).Ids.empty() ? 0 : 1);
      }
    }
    if (areFloats)
    {
      PlainDecoder<Float32Domain, PlacesOf>(
        temporal, places, std::span(floats).first(some.size()), some)
        .Decode(residuals);
    }
    else
    {
      PlainDecoder<Domain, PlacesOf>(temporal, places, domains.subspan(first, some.size()), some)
        .Decode(residuals);
    }
  }
}
}

#endif
