// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPlainCoder_h
#define gatunPlainCoder_h

// The mode PlainQuadratic: values are predicted by the quadratic function alone. Residuals do not
// depend on predictions, so that values of several components at a place are found side by side, by
// one loop over its neighbors. See Documentation/format.md, 10.11.

#include "gatunBoundedSteps.h"
#include "gatunExactValues.h"
#include "gatunGuess.h"
#include "gatunPlainResiduals.h"
#include "gatunPointContext.h"
#include "gatunQuadraticFit.h"
#include "gatunQuadraticPlaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace gatun
{
using PlainLanes = double __attribute__((vector_size(16)));

/** The numbers of four components at all places. All are finite. */
class PlainNumbersOfFour
{
public:
  static constexpr std::size_t Components = 4;
  using Numbers = std::array<double, Components>;

  explicit PlainNumbersOfFour(std::size_t places)
    : Halves(places)
  {
  }

  void Set(Vertex v, std::size_t c, double number) { this->Halves[v][c / 2][c % 2] = number; }

  /** The quadratic function at a place with neighbors. */
  Numbers Predict(const QuadraticFit::Neighbors& neighbors) const
  {
    const auto* numbers = this->Halves.data();
    const auto first = numbers[neighbors.Ids.front()];
    const std::size_t count = neighbors.GetCount();
    std::array<Pair, 4> sums{};
    const auto add = [&](std::size_t k, std::size_t i)
    {
      const double weight = neighbors.Quadratic[i];
      const auto& there = numbers[neighbors.Ids[i]];
      sums[k][0] += PlainLanes{ weight, weight } * (there[0] - first[0]);
      sums[k][1] += PlainLanes{ weight, weight } * (there[1] - first[1]);
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
    const auto low = (sums[0][0] + sums[1][0]) + (sums[2][0] + sums[3][0]);
    const auto high = (sums[0][1] + sums[1][1]) + (sums[2][1] + sums[3][1]);
    const std::array differences{ low[0], low[1], high[0], high[1] };
    Numbers result{};
    for (std::size_t c = 0; c < Components; ++c)
    {
      result[c] = AddDifference(first[c / 2][c % 2], differences[c]);
    }
    return result;
  }

private:
  using Pair = std::array<PlainLanes, 2>;

  std::vector<Pair> Halves;
};

/** The same of one component. */
class PlainNumbersOfOne
{
public:
  static constexpr std::size_t Components = 1;
  using Numbers = std::array<double, Components>;

  explicit PlainNumbersOfOne(std::size_t places)
    : All(places)
  {
  }

  void Set(Vertex v, std::size_t, double number) { this->All[v] = number; }

  Numbers Predict(const QuadraticFit::Neighbors& neighbors) const
  {
    const double first = this->All[neighbors.Ids.front()];
    return { AddDifference(first, this->SumUp(neighbors, first)) };
  }

private:
  /** The sum over neighbors i has four partial sums, by i % 4, so that no addition has to wait for
   * the previous one. */
  [[gnu::noinline]] double SumUp(const QuadraticFit::Neighbors& neighbors, double first) const
  {
    const double* numbers = this->All.data();
    const Vertex* ids = neighbors.Ids.data();
    const float* weights = neighbors.Quadratic;
    const std::size_t count = neighbors.GetCount();
    const PlainLanes base{ first, first };
    PlainLanes low{}, high{};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4)
    {
      low += PlainLanes{ weights[i], weights[i + 1] } *
        (PlainLanes{ numbers[ids[i]], numbers[ids[i + 1]] } - base);
      high += PlainLanes{ weights[i + 2], weights[i + 3] } *
        (PlainLanes{ numbers[ids[i + 2]], numbers[ids[i + 3]] } - base);
    }
    std::array<double, 4> sums{ low[0], low[1], high[0], high[1] };
    for (; i < count; ++i)
    {
      sums[i % 4] += static_cast<double>(weights[i]) * (numbers[ids[i]] - first);
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }

  std::vector<double> All;
};

/** Codes the values of a component, given the prediction of each. */
template <typename Coder, typename AnyDomain>
class PlainValues
{
public:
  /** onLattice: whether values that have a bound of errors are places of the lattice already. */
  PlainValues(const Domain& domain, bool onLattice)
    : Values(domain)
    , Rule(this->Values, domain.GetQuantizer(), onLattice || domain.GetQuantizer().OnLattice)
    , HasBound(domain.GetQuantizer())
    , List(this->Values.GetBits(), this->Rule.GetZero())
  {
  }

  const AnyDomain& GetDomain() const { return this->Values; }

  /** Decodes the residuals of a number of values. To be called before GetValue. */
  void Decode(Coder& coder, std::size_t count)
  {
    this->List.IsBounded = this->HasBound && coder.Raw(0, 1) == 0;
    this->List.Code(coder, count);
  }

  /** Encodes without steps if they are too fine. To be called before GetValue. */
  void Choose(const Domain& domain, std::span<const Key> keys)
  {
    this->List.IsBounded = this->HasBound && !AreStepsTooFine(domain, keys);
  }

  /** Encodes the residuals that GetValue has found. */
  void Encode(Coder& coder)
  {
    if (this->HasBound)
    {
      coder.Raw(!this->List.IsBounded, 1);
    }
    this->List.Code(coder, this->List.Residuals.size());
  }

  /** The key that readers will have. The index is that of the residual; the indices ascend. */
  Key GetValue(const Guess& guess, std::size_t index, Key actual)
  {
    if constexpr (Coder::Encoding)
    {
      return this->Find(guess, actual);
    }
    const std::int64_t residual = this->List.Residuals[index];
    if (!this->List.IsBounded)
    {
      return AddResidual(this->Values, guess.GetKey(this->Values), residual);
    }
    return residual == PlainResiduals::NoSteps
      ? this->List.Keys[this->NextKey++]
      : this->Rule.GetKey(this->Rule.FindOrigin(guess), residual);
  }

private:
  Key Find(const Guess& guess, Key actual)
  {
    auto& residuals = this->List.Residuals;
    if (!this->List.IsBounded)
    {
      residuals.push_back(this->Values.Subtract(actual, guess.GetKey(this->Values)));
      return actual;
    }
    Key key = actual;
    std::int64_t steps = 0;
    if (!this->Rule.FindSteps(this->Rule.FindOrigin(guess), actual, steps, key))
    {
      residuals.push_back(PlainResiduals::NoSteps);
      this->List.Keys.push_back(actual);
      return actual;
    }
    residuals.push_back(steps);
    return key;
  }

  const AnyDomain Values;
  const BoundedSteps<AnyDomain> Rule;
  const bool HasBound;
  PlainResiduals List;
  std::size_t NextKey = 0;
};

/** Codes the values of up to PlainNumbers::Components components. places: OwnPoints or AllPlaces.
 */
template <typename PlainNumbers, typename AnyValues, typename PlacesOf>
class PlainWalk
{
public:
  PlainWalk(TemporalMode temporal, const PlacesOf& places, std::span<AnyValues> values,
    std::span<ComponentKeys> components)
    : Temporal(temporal)
    , Places(places)
    , Values(values)
    , Components(components)
    , Numbers(components.front().Now.size())
  {
  }

  void Code()
  {
    this->SetKnown();
    const auto& fit = this->Places.GetFit();
    for (std::size_t own = 0; own < this->Places.GetNumber(); ++own)
    {
      const auto neighbors = fit.Of(own);
      const auto predicted = neighbors.Ids.empty() ? this->Last : this->Numbers.Predict(neighbors);
      const Vertex v = this->Places.GetPlace(own);
      for (std::size_t c = 0; c < this->Components.size(); ++c)
      {
        this->CodeValue(own, v, c, predicted[c]);
      }
    }
  }

private:
  double ToNumber(std::size_t c, Key key) const
  {
    return this->Values[c].GetDomain().ToNumber(key);
  }

  double GetBase(Vertex v, std::size_t c) const
  {
    return gatun::GetBase(this->Values[c].GetDomain(), this->Temporal, this->Components[c], v);
  }

  /** The numbers of places that are known from the beginning. One that is not finite is replaced by
   * the one before. */
  void SetKnown()
  {
    for (std::size_t c = 0; c < this->Components.size(); ++c)
    {
      double last = 0;
      const auto count = static_cast<Vertex>(this->Components[c].Now.size());
      for (Vertex v = 0; v < count; ++v)
      {
        if (this->Places.IsKnown(v))
        {
          const double number = this->ToNumber(c, this->Components[c].Now[v]) - this->GetBase(v, c);
          last = std::isfinite(number) ? number : last;
          this->Numbers.Set(v, c, last);
        }
      }
    }
  }

  void CodeValue(std::size_t own, Vertex v, std::size_t c, double predicted)
  {
    auto& keys = this->Components[c];
    const double base = this->GetBase(v, c);
    const Key key = this->Values[c].GetValue(MakeGuess(base, predicted, keys, v), own, keys.Now[v]);
    keys.Now[v] = key;
    const double number = this->ToNumber(c, key) - base;
    this->Last[c] = std::isfinite(number) ? number : predicted;
    this->Numbers.Set(v, c, this->Last[c]);
  }

  const TemporalMode Temporal;
  const PlacesOf& Places;
  const std::span<AnyValues> Values;
  const std::span<ComponentKeys> Components;
  PlainNumbers Numbers;
  typename PlainNumbers::Numbers Last{}; // of own places
};

/** Codes components that fit into PlainNumbers. */
template <typename PlainNumbers, typename AnyDomain, typename Coder, typename PlacesOf>
void CodePlainTogether(Coder& coder, TemporalMode temporal, const PlacesOf& places, bool onLattice,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  using AnyValues = PlainValues<Coder, AnyDomain>;
  std::vector<AnyValues> values;
  values.reserve(components.size());
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    values.emplace_back(domains[c], onLattice);
    if constexpr (Coder::Encoding)
    {
      values.back().Choose(domains[c], components[c].Now);
    }
    else
    {
      values.back().Decode(coder, places.GetNumber());
    }
  }
  PlainWalk<PlainNumbers, AnyValues, PlacesOf>(temporal, places, values, components).Code();
  if constexpr (Coder::Encoding)
  {
    for (auto& some : values)
    {
      some.Encode(coder);
    }
  }
}

/** Codes all components of a stream. onLattice: whether values that have a bound of errors are
 * places of the lattice already. */
template <typename Coder, typename PlacesOf>
void CodePlain(Coder& coder, TemporalMode temporal, const PlacesOf& places, bool onLattice,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  const auto match = [&](auto&& matches)
  { return std::all_of(domains.begin(), domains.end(), matches); };
  const bool areFloats = match(Float32Domain::Matches);
  const bool areShifted = match(ShiftedFloat32Domain::Matches);
  const bool areBinary = match(BinaryDomain::Matches);
  const auto code = [&]<typename PlainNumbers>(
                      std::type_identity<PlainNumbers>, std::size_t first, std::size_t count)
  {
    const auto someDomains = domains.subspan(first, count);
    const auto some = components.subspan(first, count);
    if (areFloats)
    {
      CodePlainTogether<PlainNumbers, Float32Domain>(
        coder, temporal, places, onLattice, someDomains, some);
    }
    else if (areShifted)
    {
      CodePlainTogether<PlainNumbers, ShiftedFloat32Domain>(
        coder, temporal, places, onLattice, someDomains, some);
    }
    else if (areBinary)
    {
      CodePlainTogether<PlainNumbers, BinaryDomain>(
        coder, temporal, places, onLattice, someDomains, some);
    }
    else
    {
      CodePlainTogether<PlainNumbers, Domain>(
        coder, temporal, places, onLattice, someDomains, some);
    }
  };
  constexpr std::size_t most = PlainNumbersOfFour::Components;
  for (std::size_t first = 0; first < components.size(); first += most)
  {
    const auto count = std::min(most, components.size() - first);
    if (count == 1)
    {
      code(std::type_identity<PlainNumbersOfOne>(), first, count);
    }
    else
    {
      code(std::type_identity<PlainNumbersOfFour>(), first, count);
    }
  }
}
}

#endif
