// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGatePredictor_h
#define gatunGatePredictor_h

// Predictions of values from those around them. See Documentation/format.md, 10.12.

#include "gatunDomain.h"
#include "gatunGateRule.h"
#include "gatunNumberStream.h"
#include "gatunTetTree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Plain float32 values, which are predicted in binary32. */
class SingleValues
{
public:
  using Number = float;

  static unsigned GetBits() { return 32; }
  static float ToNumber(Key key) { return static_cast<float>(Float32Domain::ToNumber(key)); }
  static Key FromNumber(float number)
  {
    return Float32Domain::FromNumber(static_cast<double>(number));
  }
  static std::uint64_t Subtract(Key key, Key predicted)
  {
    return FromSigned(Float32Domain::Subtract(key, predicted));
  }
  static Key Add(Key predicted, std::uint64_t residual)
  {
    return Float32Domain::Add(predicted, ToSigned(residual));
  }
  static bool IsValid(Key) { return true; }
};

/** Values of other domains, which are predicted in binary64. DomainT: Domain, or a class that does
 * the same for some of them in less time. */
template <typename DomainT>
class DoubleValues
{
public:
  using Number = double;

  explicit DoubleValues(const DomainT& domain)
    : Values(domain)
  {
  }

  unsigned GetBits() const { return this->Values.GetBits(); }
  double ToNumber(Key key) const { return this->Values.ToNumber(key); }
  Key FromNumber(double number) const { return this->Values.FromNumber(number); }
  std::uint64_t Subtract(Key key, Key predicted) const
  {
    return FromSigned(this->Values.Subtract(key, predicted));
  }
  Key Add(Key predicted, std::uint64_t residual) const
  {
    return this->Values.Add(predicted, ToSigned(residual));
  }
  bool IsValid(Key key) const { return this->Values.IsValid(key); }

private:
  const DomainT Values;
};

/** Calls code(values) with a class for the values of the domain. */
template <typename Code>
void WithValues(const Domain& domain, Code&& code)
{
  if (Float32Domain::Matches(domain))
  {
    code(SingleValues());
  }
  else if (ShiftedFloat32Domain::Matches(domain))
  {
    code(DoubleValues(ShiftedFloat32Domain(domain)));
  }
  else if (BinaryDomain::Matches(domain))
  {
    code(DoubleValues(BinaryDomain(domain)));
  }
  else if (RankDomain::Matches(domain))
  {
    code(DoubleValues(RankDomain(domain)));
  }
  else
  {
    code(DoubleValues(domain));
  }
}

/** number(v): that of a vertex. */
template <typename Number, typename GetNumber>
Number PredictBy(
  const std::array<Number, GateSize>& weights, PackedTet gate, const GetNumber& number)
{
  return ((weights[0] * number(GetCorner(gate, 0)) + weights[1] * number(GetCorner(gate, 1))) +
           weights[2] * number(GetCorner(gate, 2))) +
    weights[3] * number(GetCorner(gate, 3));
}

/** Predicts the keys of vertices in order. */
template <typename Values>
class VertexPredictor
{
public:
  using Number = typename Values::Number;

  VertexPredictor(const Values& values, const GateVertices& vertices, const GateKeys& keys,
    const GateWeights& weights)
    : Coded(values)
    , Vertices(vertices)
    , Keys(keys)
    , Weights(ScaleWeights<Number>(weights))
    , Numbers(keys.Now.size())
  {
    for (std::size_t v = 0; v < this->Numbers.size(); ++v)
    {
      if (!IsOwn(vertices.Sources[v]))
      {
        this->Note(v, keys.Now[v]);
      }
    }
  }

  Key Predict(std::size_t v) const
  {
    if (this->Keys.Use == BeforeUse::Repeat)
    {
      return this->Keys.Before[v];
    }
    const auto number = PredictBy(this->Weights, this->Vertices.Gates[v],
      [from = this->Numbers.data()](std::uint32_t u) { return from[u]; });
    return this->Coded.FromNumber(
      this->Keys.Use == BeforeUse::Change ? this->GetBefore(v) + number : number);
  }

  /** Notes the key of a vertex. */
  void Set(std::size_t v, Key key)
  {
    this->Keys.Now[v] = key;
    this->Note(v, key);
  }

private:
  Number GetBefore(std::size_t v) const { return this->Coded.ToNumber(this->Keys.Before[v]); }

  void Note(std::size_t v, Key key)
  {
    const auto number = this->Coded.ToNumber(key);
    this->Numbers[v] = this->Keys.Use == BeforeUse::Change ? number - this->GetBefore(v) : number;
  }

  const Values& Coded;
  const GateVertices& Vertices;
  const GateKeys& Keys;
  const std::array<Number, GateSize> Weights;
  std::vector<Number> Numbers; // or changes; 0 of own vertices that come later
};

/** Predicts the keys of items in order. */
template <typename Values>
class ItemPredictor
{
public:
  ItemPredictor(const Values& values, std::span<const std::uint32_t> parents, const GateKeys& keys)
    : Coded(values)
    , Parents(parents)
    , Keys(keys)
    , None(values.FromNumber(0))
  {
  }

  Key Predict(std::size_t i) const
  {
    if (this->Keys.Use == BeforeUse::Repeat)
    {
      return this->Keys.Before[i];
    }
    const bool hasParent = !this->Parents.empty() && this->Parents[i] != TetTree::NoTet;
    const std::size_t from = hasParent ? this->Parents[i] : i - 1;
    if (i == 0)
    {
      return this->Keys.Use == BeforeUse::Change ? this->Keys.Before[i] : this->None;
    }
    if (this->Keys.Use == BeforeUse::None)
    {
      return this->Keys.Now[from];
    }
    return this->Coded.FromNumber(this->Coded.ToNumber(this->Keys.Before[i]) +
      (this->Coded.ToNumber(this->Keys.Now[from]) - this->Coded.ToNumber(this->Keys.Before[from])));
  }

private:
  const Values& Coded;
  const std::span<const std::uint32_t> Parents;
  const GateKeys& Keys;
  const Key None;
};
}

#endif
