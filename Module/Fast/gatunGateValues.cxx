// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGateValues.h"

#include "gatunGatePredictor.h"
#include "gatunGateRule.h"
#include "gatunNumberStream.h"
#include "gatunTreeSymbols.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** Those that the encoder tries: the middle of the face, from there on past the vertex behind it,
 * parallelograms, also with middles of edges, and copies. */
constexpr std::array<GateWeights, 12> CommonWeights{ { { 85, 85, 86, 0 }, { 171, 171, 170, -256 },
  { 128, 128, 128, -128 }, { 256, 256, -256, 0 }, { -256, 256, 256, 0 }, { 256, -256, 256, 0 },
  { 256, 256, 0, -256 }, { 0, 256, 256, -256 }, { 256, 0, 256, -256 }, { 256, 256, -128, -128 },
  { 0, 0, 256, 0 }, { 256, 0, 0, 0 } } };

/** The place in a gate of the first vertex with a key, or GateSize. */
unsigned FindCopy(PackedTet gate, std::span<const Key> keys, Key key)
{
  for (unsigned k = 0; k < GateSize; ++k)
  {
    if (keys[GetCorner(gate, k)] == key)
    {
      return k;
    }
  }
  return GateSize;
}

/** A vertex of a sample from which the encoder chooses a rule. */
template <typename Number>
struct GateSample
{
  std::array<Number, GateSize> Gate; // or changes
  Number Before = 0;
  Key Wanted;
  unsigned Copy; // as FindCopy
};

/** The keys of all vertices are known. */
template <typename Values>
std::vector<GateSample<typename Values::Number>> TakeSamples(
  const Values& values, const GateVertices& vertices, const GateKeys& keys)
{
  constexpr std::size_t most = 1024;
  const auto step = std::max<std::size_t>(1, keys.Now.size() / most);
  std::vector<GateSample<typename Values::Number>> samples;
  samples.reserve(keys.Now.size() / step);
  const bool isChange = keys.Use == BeforeUse::Change;
  for (std::size_t v = 1; v < keys.Now.size(); v += step)
  {
    auto& sample = samples.emplace_back();
    const auto gate = vertices.Gates[v];
    for (unsigned k = 0; k < GateSize; ++k)
    {
      const auto corner = GetCorner(gate, k);
      sample.Gate[k] = values.ToNumber(keys.Now[corner]);
      if (isChange)
      {
        sample.Gate[k] -= values.ToNumber(keys.Before[corner]);
      }
    }
    if (isChange)
    {
      sample.Before = values.ToNumber(keys.Before[v]);
    }
    sample.Wanted = keys.Now[v];
    sample.Copy = FindCopy(gate, keys.Now, sample.Wanted);
  }
  return samples;
}

/** The bits of the lengths of numbers, each of which occurs so often, and of the numbers. */
class BitCount
{
public:
  void Add(unsigned length, unsigned lowBits)
  {
    ++this->Counts[length];
    this->Bits += lowBits;
    ++this->All;
  }

  double GetSum() const
  {
    double bits = this->Bits;
    for (const auto count : this->Counts)
    {
      bits += count > 0 ? count * std::log2(this->All / count) : 0;
    }
    return bits;
  }

private:
  std::array<std::uint32_t, 64 + GateSize + 1> Counts{};
  double Bits = 0;
  double All = 0;
};

/** The bits that a sample of the vertices would take, without and with copies. */
template <typename Values>
std::array<double, 2> EstimateBits(const Values& values,
  std::span<const GateSample<typename Values::Number>> samples, const GateWeights& weights,
  BeforeUse use)
{
  using Number = typename Values::Number;
  const auto scaled = ScaleWeights<Number>(weights);
  const auto predict = [&](const std::array<Number, GateSize>& gate)
  {
    return PredictBy(
      scaled, TreeSymbols::Pack(0, 1, 2, 3), [&](std::uint32_t k) -> Number { return gate[k]; });
  };
  BitCount plain;
  BitCount copied;
  for (const auto& sample : samples)
  {
    const Number predicted = predict(sample.Gate);
    const Number number = use == BeforeUse::Change ? sample.Before + predicted : predicted;
    const auto length = static_cast<unsigned>(
      std::bit_width(values.Subtract(sample.Wanted, values.FromNumber(number))));
    plain.Add(length, GetLowBits(length));
    if (length > 0 && sample.Copy < GateSize)
    {
      copied.Add(values.GetBits() + 1 + sample.Copy, 0);
    }
    else
    {
      copied.Add(length, GetLowBits(length));
    }
  }
  return { plain.GetSum(), copied.GetSum() };
}

template <typename Values>
VertexRule ChooseRule(const Values& values, const GateVertices& vertices, const GateKeys& keys)
{
  VertexRule best{ CommonWeights[0] };
  if (keys.Use == BeforeUse::Repeat || keys.Now.empty())
  {
    return best;
  }
  const auto samples = TakeSamples(values, vertices, keys);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& weights : CommonWeights)
  {
    const auto bits = EstimateBits<Values>(values, samples, weights, keys.Use);
    for (const bool copies : { false, true })
    {
      // Copies are slower to decode.
      const double worth = copies ? 0.98 : 1;
      if (bits[copies] < worth * least)
      {
        least = bits[copies];
        best = { weights, copies };
      }
    }
  }
  return best;
}

template <typename Values>
void PutVertices(
  ByteWriter& out, const Values& values, const GateVertices& vertices, const GateKeys& keys)
{
  const auto rule = ChooseRule(values, vertices, keys);
  VertexPredictor<Values> predictor(values, vertices, keys, rule.Weights);
  NumberWriter residuals;
  for (const std::size_t v : FindOwn(vertices.Sources))
  {
    const Key key = keys.Now[v];
    const auto residual = values.Subtract(key, predictor.Predict(v));
    // Vertex 0 has no others.
    const auto copy =
      rule.Copies && residual != 0 && v > 0 ? FindCopy(vertices.Gates[v], keys.Now, key) : GateSize;
    if (copy < GateSize)
    {
      residuals.PutLength(values.GetBits() + 1 + copy);
    }
    else
    {
      residuals.Put(residual);
    }
    predictor.Set(v, key);
  }
  rule.Write(out);
  residuals.Finish(out);
}

void CheckKey(bool isValid)
{
  if (!isValid)
  {
    ThrowCorrupt("a value is not in the palette");
  }
}

/** Has no branches that depend on lengths, as those are unpredictable. */
template <bool Copies, typename Values>
void GetVerticesBy(ByteReader& in, const Values& values, const GateVertices& vertices,
  const GateKeys& keys, const GateWeights& weights)
{
  VertexPredictor<Values> predictor(values, vertices, keys, weights);
  const unsigned bits = values.GetBits();
  const auto own = FindOwn(vertices.Sources);
  NumberReader residuals(in, own.size(), bits, bits + (Copies ? GateSize : 0));
  bool areValid = true;
  for (const std::size_t v : own)
  {
    const auto length = residuals.GetLength();
    const std::uint64_t isCopy = Copies && length > bits ? 1 : 0;
    const auto number =
      residuals.GetNumber(length & (static_cast<unsigned>(isCopy) - 1)); // 0 for a copy
    Key key = values.Add(predictor.Predict(v), number);
    if constexpr (Copies)
    {
      const Key other = keys.Now[GetCorner(vertices.Gates[v], (length - bits - 1) % GateSize)];
      key ^= (key ^ other) & (0 - isCopy);
    }
    areValid = areValid && values.IsValid(key);
    predictor.Set(v, areValid ? key : 0);
  }
  CheckKey(areValid);
}

template <typename Values>
void GetVertices(
  ByteReader& in, const Values& values, const GateVertices& vertices, const GateKeys& keys)
{
  const auto rule = VertexRule::Read(in);
  rule.Copies ? GetVerticesBy<true>(in, values, vertices, keys, rule.Weights)
              : GetVerticesBy<false>(in, values, vertices, keys, rule.Weights);
}
}

//------------------------------------------------------------------------------
VertexRule ChooseVertexRule(
  const Domain& domain, const GateVertices& vertices, const GateKeys& keys)
{
  VertexRule rule;
  WithValues(domain, [&](const auto& values) { rule = ChooseRule(values, vertices, keys); });
  return rule;
}

//------------------------------------------------------------------------------
void PutVertexValues(
  ByteWriter& out, const Domain& domain, const GateVertices& vertices, const GateKeys& keys)
{
  WithValues(domain, [&](const auto& values) { PutVertices(out, values, vertices, keys); });
}

//------------------------------------------------------------------------------
void GetVertexValues(
  ByteReader& in, const Domain& domain, const GateVertices& vertices, const GateKeys& keys)
{
  WithValues(domain, [&](const auto& values) { GetVertices(in, values, vertices, keys); });
}

//------------------------------------------------------------------------------
void PutItemValues(ByteWriter& out, const Domain& domain, std::span<const std::uint32_t> parents,
  const GateKeys& keys)
{
  WithValues(domain,
    [&](const auto& values)
    {
      const ItemPredictor predictor(values, parents, keys);
      NumberWriter residuals;
      for (std::size_t i = 0; i < keys.Now.size(); ++i)
      {
        residuals.Put(values.Subtract(keys.Now[i], predictor.Predict(i)));
      }
      residuals.Finish(out);
    });
}

//------------------------------------------------------------------------------
void GetItemValues(ByteReader& in, const Domain& domain, std::span<const std::uint32_t> parents,
  const GateKeys& keys)
{
  WithValues(domain,
    [&](const auto& values)
    {
      const ItemPredictor predictor(values, parents, keys);
      NumberReader residuals(in, keys.Now.size(), values.GetBits());
      bool areValid = true;
      for (std::size_t i = 0; i < keys.Now.size(); ++i)
      {
        const Key key = values.Add(predictor.Predict(i), residuals.Get());
        areValid = areValid && values.IsValid(key);
        keys.Now[i] = areValid ? key : 0;
      }
      CheckKey(areValid);
    });
}
}
