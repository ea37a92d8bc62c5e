// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPlainQuadratic_h
#define gatunPlainQuadratic_h

// The mode PlainQuadratic of exact values. See Documentation/format.md, 10.11. Residuals do not
// depend on predictions there, so that those of all components but the last one are decoded first,
// and then all components side by side: each prediction waits for the values just before.

#include "gatunDomain.h"
#include "gatunEntropy.h"
#include "gatunPointContext.h"
#include "gatunQuadraticPredictor.h"
#include "gatunResidual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
using Residuals = std::vector<std::int64_t>; // of the places of a component, in their order

/** Codes the residuals of a component one by one. */
class ResidualSequence
{
public:
  template <typename Coder>
  std::int64_t Code(Coder& coder, bool hasNeighbors, std::int64_t residual)
  {
    residual = this->Models[hasNeighbors ? 1 : 0].Code(coder, this->Spread.Get(), residual);
    this->Spread.Add(residual);
    return residual;
  }

private:
  std::array<ResidualModel, 2> Models;
  RunningSpread Spread;
};

template <typename Coder>
void CodeResiduals(Coder& coder, const QuadraticFit& fit, Residuals& residuals)
{
  ResidualSequence sequence;
  for (std::size_t own = 0; own < residuals.size(); ++own)
  {
    residuals[own] = sequence.Code(coder, fit.HasNeighbors(own), residuals[own]);
  }
}

template <typename AnyDomain>
struct PlainComponent
{
  AnyDomain Values; // a copy: small, and so the compiler knows that it does not change
  ComponentKeys* Keys;
};

/** Up to four components that are predicted side by side. */
template <typename PlacesOf, typename AnyDomain>
class PlainQuadraticComponents
{
public:
  static constexpr std::size_t Most = 4;

  /** All components must have as many values. memory: of any content, kept for others. */
  PlainQuadraticComponents(const PlacesOf& places, TemporalMode temporal,
    std::span<const PlainComponent<AnyDomain>> components, std::vector<double>& memory)
    : Places(places)
    , IsChange(temporal == TemporalMode::Change)
    , Components(components)
    , Stride(components.size() == 1 ? 1 : Most)
    , Numbers(memory)
  {
    // Numbers are set before they are used. Those of other components than there are do not matter.
    memory.resize(std::max(memory.size(), this->Stride * components.front().Keys->Now.size()));
    std::array<double, Most> last{};
    for (Vertex v = 0; v < components.front().Keys->Now.size(); ++v)
    {
      if (places.IsKnown(v))
      {
        for (std::size_t c = 0; c < components.size(); ++c)
        {
          const auto& domain = components[c].Values;
          const double number = domain.ToNumber(components[c].Keys->Now[v]) - this->GetBase(c, v);
          last[c] = std::isfinite(number) ? number : last[c];
          this->Numbers[v * this->Stride + c] = last[c];
        }
      }
    }
  }

  /** Calls use(component, place, domain, predicted key, key) for each component of each place. use
   * may set the key. */
  template <typename Use>
  void EachPlace(Use&& use)
  {
    const auto& fit = this->Places.GetFit();
    const auto& sums = GetBestNeighborSums();
    alignas(32) std::array<double, Most> predicted{};
    for (std::size_t own = 0; own < this->Places.GetNumber(); ++own)
    {
      const Vertex v = this->Places.GetPlace(own);
      const auto neighbors = fit.Of(own);
      if (neighbors.Count > 0 && this->Stride == 1)
      {
        predicted[0] = sums.PredictOne(neighbors, this->Numbers.data());
      }
      else if (neighbors.Count > 0)
      {
        sums.PredictFour(neighbors, this->Numbers.data(), predicted.data());
      }
      else
      {
        predicted = this->Last;
      }
      for (std::size_t c = 0; c < this->Components.size(); ++c)
      {
        const auto& component = this->Components[c];
        const auto& domain = component.Values;
        Key& key = component.Keys->Now[v];
        const double base = this->GetBase(c, v);
        const Key guess = std::isfinite(base) ? domain.FromNumber(base + predicted[c])
                                              : component.Keys->Before[v];
        use(c, own, domain, guess, key);
        const double number = domain.ToNumber(key) - base;
        this->Last[c] = std::isfinite(number) ? number : predicted[c];
        this->Numbers[v * this->Stride + c] = this->Last[c];
      }
    }
  }

private:
  double GetBase(std::size_t component, Vertex v) const
  {
    const auto& c = this->Components[component];
    return this->IsChange ? c.Values.ToNumber(c.Keys->Before[v]) : 0.0;
  }

  const PlacesOf& Places;
  const bool IsChange;
  const std::span<const PlainComponent<AnyDomain>> Components;
  const std::size_t Stride;
  std::vector<double>& Numbers;    // those of a vertex one after the other
  std::array<double, Most> Last{}; // numbers of own vertices
};

/** Calls use as EachPlace does, for any number of components. */
template <typename PlacesOf, typename AnyDomain, typename Use>
void EachPlainValue(const PlacesOf& places, TemporalMode temporal,
  std::span<const PlainComponent<AnyDomain>> components, Use&& use)
{
  static thread_local std::vector<double> memory; // new memory takes as long as predictions
  using Group = PlainQuadraticComponents<PlacesOf, AnyDomain>;
  for (std::size_t first = 0; first < components.size(); first += Group::Most)
  {
    Group group(places, temporal,
      components.subspan(first, std::min(Group::Most, components.size() - first)), memory);
    group.EachPlace(
      [&](std::size_t c, std::size_t place, const AnyDomain& domain, Key predicted, Key& key)
      { use(first + c, place, domain, predicted, key); });
  }
}
}

#endif
