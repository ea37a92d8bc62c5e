// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayCodec.h"

#include "gatunBoundedValues.h"
#include "gatunExactValues.h"
#include "gatunFastArrays.h"
#include "gatunFastSteps.h"
#include "gatunGateValues.h"
#include "gatunGuess.h"
#include "gatunNeighborFit.h"
#include "gatunPlainCoder.h"
#include "gatunQuadraticCoder.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace gatun
{
namespace
{
/** Predicts a chunk's point values from the gate or the neighbors. */
class SpatialPredictor
{
public:
  static constexpr unsigned Groups = static_cast<unsigned>(MaxRules) + 1;

  SpatialPredictor(const PointContext& context, SpatialMode mode)
    : Context(context)
    , Mode(mode)
  {
  }

  struct Prediction
  {
    double Number = 0;
    unsigned Spread = 0; // or NoSpread
    unsigned Group = 0;
    bool Known = false; // whether there is anything to predict from
  };

  /** keys, numbers: of all vertices that are known. */
  Prediction Predict(
    std::size_t own, std::span<const Key> keys, std::span<const double> numbers) const
  {
    return this->Mode == SpatialMode::Fit ? this->PredictFit(own, keys, numbers)
      : this->Context.CellRules           ? this->PredictCell(own, keys, numbers)
                                          : this->PredictGate(own, keys, numbers);
  }

  /** Calls use for each vertex that the prediction of an own vertex uses. */
  template <typename Use>
  void EachNeighbor(std::size_t own, Use&& use) const
  {
    if (this->Mode == SpatialMode::Fit)
    {
      for (const auto& n : this->Context.Fit->Of(own))
      {
        use(n.Id);
      }
    }
    else if (this->Context.CellRules)
    {
      for (const auto v : this->Context.Mesh->CellRecords[own].Known)
      {
        if (v != NoVertex)
        {
          use(v);
        }
      }
    }
    else if (!this->Context.Mesh->Records[own].IsSeed())
    {
      const auto& known = this->Context.Mesh->Records[own].Known;
      std::for_each(known.begin(), known.begin() + 4, use);
    }
  }

private:
  Prediction PredictFit(
    std::size_t own, std::span<const Key> keys, std::span<const double> numbers) const
  {
    const auto neighbors = this->Context.Fit->Of(own);
    Prediction result;
    if (neighbors.empty())
    {
      return result;
    }
    Key low = ~Key{ 0 };
    Key high = 0;
    for (const auto& n : neighbors)
    {
      const Key key = keys[n.Id];
      low = std::min(low, key);
      high = std::max(high, key);
      result.Number += n.Weight * numbers[n.Id];
    }
    const auto count = neighbors.size();
    result.Spread = static_cast<unsigned>(std::bit_width(high - low));
    result.Group = count < 4 ? 0 : count < 6 ? 1 : count < 8 ? 2 : count < 11 ? 3 : 4;
    result.Known = true;
    return result;
  }

  Prediction PredictGate(
    std::size_t own, std::span<const Key> keys, std::span<const double> numbers) const
  {
    const auto& record = this->Context.Mesh->Records[own];
    Prediction result;
    if (record.IsSeed())
    {
      return result;
    }
    Key low = ~Key{ 0 };
    Key high = 0;
    for (unsigned k = 0; k < 4; ++k)
    {
      const Key key = keys[record.Known[k]];
      low = std::min(low, key);
      high = std::max(high, key);
    }
    result.Number = *PredictByGate(this->Context, own, numbers);
    result.Spread = static_cast<unsigned>(std::bit_width(high - low));
    result.Group = 1u + this->Context.UsedRules[own];
    result.Known = true;
    return result;
  }

  Prediction PredictCell(
    std::size_t own, std::span<const Key> keys, std::span<const double> numbers) const
  {
    const auto& record = this->Context.Mesh->CellRecords[own];
    Prediction result;
    if (record.IsSeed())
    {
      return result;
    }
    result.Number = *PredictByGate(this->Context, own, numbers);
    result.Spread = GetSpread(record, [keys](Vertex v) { return keys[v]; });
    result.Group = std::min(1u + this->Context.UsedRules[own], Groups - 1);
    result.Known = true;
    return result;
  }

  const PointContext& Context;
  const SpatialMode Mode;
};

/** The numbers of the keys that predictions use: a key is used many times. */
template <typename Values>
std::vector<double> GetNumbers(
  Values& values, std::span<const Key> keys, const Topology& mesh, bool withOwn)
{
  std::vector<double> numbers(keys.size());
  for (std::size_t v = 0; v < keys.size(); ++v)
  {
    if (withOwn || mesh.IsShared(static_cast<Vertex>(v)))
    {
      numbers[v] = values.ToNumber(keys[v]);
    }
  }
  return numbers;
}

template <typename Coder, typename Values>
void CodePoints(Coder& coder, const ArrayModes& modes, const PointContext& context, Values&& values,
  ComponentKeys& keys)
{
  const auto& domain = values.GetDomain();
  const SpatialPredictor predictor(context, modes.Spatial);
  const bool isPredicted =
    modes.Temporal != TemporalMode::Repeat && modes.Spatial != SpatialMode::Previous;
  Key previous = domain.FromNumber(0);
  Key previousBefore = previous;
  const bool change = modes.Temporal == TemporalMode::Change;
  std::vector<double> numbers, numbersBefore;
  if (isPredicted)
  {
    numbers = GetNumbers(values, keys.Now, *context.Mesh, false);
    numbersBefore = change ? GetNumbers(values, keys.Before, *context.Mesh, true) : numbersBefore;
  }
  for (std::size_t own = 0; own < context.OwnIds.size(); ++own)
  {
    const Vertex v = context.OwnIds[own];
    Guess guess;
    guess.Predicted = previous;
    if (modes.Temporal == TemporalMode::Repeat)
    {
      guess.Predicted = keys.Before[v];
    }
    else if (modes.Spatial == SpatialMode::Previous)
    {
      if (change)
      {
        guess.SetNumber(domain.ToNumber(keys.Before[v]) +
          (domain.ToNumber(previous) - domain.ToNumber(previousBefore)));
        previousBefore = keys.Before[v];
      }
    }
    else
    {
      const auto now = predictor.Predict(own, keys.Now, numbers);
      if (now.Known)
      {
        guess.SetNumber(now.Number);
        guess.Group = now.Group;
        guess.Spread = now.Spread;
        if (change)
        {
          const auto before = predictor.Predict(own, keys.Before, numbersBefore);
          guess.SetNumber(numbersBefore[v] + (now.Number - before.Number));
          guess.Spread = NoSpread;
        }
      }
      if constexpr (std::remove_reference_t<Values>::IsBounded)
      {
        predictor.EachNeighbor(own, [&](Vertex u) { values.AddNeighbor(u); });
      }
    }
    previous = values.Code(coder, guess, v, keys.Now[v]);
    keys.Now[v] = previous;
    if (isPredicted)
    {
      numbers[v] = values.ToNumber(previous);
    }
  }
}

template <typename Coder, typename Values>
void CodeCells(Coder& coder, const ArrayModes& modes, const CellContext& context, Values&& values,
  ComponentKeys& keys)
{
  const auto& domain = values.GetDomain();
  const Key none = domain.FromNumber(0);
  for (std::size_t i = 0; i < keys.Now.size(); ++i)
  {
    std::size_t from = i - 1; // wraps around for the first one, which has no predecessor
    if (modes.Spatial == SpatialMode::Gate && context.Parents[i] != Topology::NoTet)
    {
      from = context.Parents[i];
    }
    const Key near = from < i ? keys.Now[from] : none;
    Guess guess;
    guess.Predicted = near;
    if (modes.Temporal == TemporalMode::Repeat)
    {
      guess.Predicted = keys.Before[i];
    }
    else if (modes.Temporal == TemporalMode::Change && from < i)
    {
      guess.SetNumber(domain.ToNumber(keys.Before[i]) +
        (domain.ToNumber(near) - domain.ToNumber(keys.Before[from])));
    }
    if constexpr (std::remove_reference_t<Values>::IsBounded)
    {
      if (i > 0)
      {
        values.AddNeighbor(i - 1);
        values.AddNeighbor(from);
      }
    }
    keys.Now[i] = values.Code(coder, guess, i, keys.Now[i]);
  }
}

/** Codes a component with code(values). A bounded one begins with whether it has exact values all
 * the same. */
template <typename Coder, typename Code>
void CodeComponent(
  Coder& coder, const Domain& domain, bool onLattice, const ComponentKeys& keys, Code&& code)
{
  bool isExact = true;
  if (domain.GetQuantizer())
  {
    isExact = Coder::Encoding && AreStepsTooFine(domain, keys.Now);
    isExact = coder.Raw(isExact, 1) != 0;
  }
  if (!isExact)
  {
    code(BoundedValues(domain, keys.Now.size(), onLattice || domain.GetQuantizer().OnLattice));
  }
  else if (Float32Domain::Matches(domain))
  {
    code(ExactValues(Float32Domain()));
  }
  else
  {
    code(ExactValues(domain));
  }
}

template <typename Coder>
void CodePointComponents(Coder& coder, const ArrayModes& modes, const PointContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  if (modes.Spatial == SpatialMode::PlainQuadratic)
  {
    CodePlain(coder, modes.Temporal, OwnPoints{ context }, false, domains, components);
    return;
  }
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    CodeComponent(coder, domains[c], false, components[c],
      [&](auto&& values)
      {
        if (modes.Spatial == SpatialMode::Quadratic)
        {
          CodeQuadratic(coder, modes.Temporal, OwnPoints{ context }, values, components[c]);
        }
        else
        {
          CodePoints(coder, modes, context, values, components[c]);
        }
      });
  }
}

template <typename Coder>
void CodeCellComponents(Coder& coder, const ArrayModes& modes, const CellContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  // Other processes round values on blocks, too.
  const bool onLattice = context.IsBlock();
  if (modes.Spatial == SpatialMode::PlainQuadratic)
  {
    const auto number = components.empty() ? 0 : components.front().Now.size();
    CodePlain(coder, modes.Temporal, AllPlaces{ context, number }, onLattice, domains, components);
    return;
  }
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    CodeComponent(coder, domains[c], onLattice, components[c],
      [&](auto&& values)
      {
        if (modes.Spatial == SpatialMode::Quadratic)
        {
          CodeQuadratic(coder, modes.Temporal, AllPlaces{ context, components[c].Now.size() },
            values, components[c]);
        }
        else
        {
          CodeCells(coder, modes, context, values, components[c]);
        }
      });
  }
}

/** The place of a mode if they are ordered by the time to decode a stream. */
int GetSlowness(SpatialMode mode, bool hasWeights)
{
  switch (mode)
  {
    case SpatialMode::Quadratic:
      return 3;
    case SpatialMode::PlainQuadratic:
      return hasWeights ? 0 : 2;
    default:
      return 1;
  }
}

/** Whether a stream of this size, with these modes, is to replace another one of so many values. */
bool IsBetter(const ArrayModes& modes, std::size_t size, const Bytes& best, std::size_t values,
  const ModeChoice& choice)
{
  const auto slowness = [&](SpatialMode mode) { return GetSlowness(mode, choice.HasWeights); };
  const int slower = slowness(modes.Spatial) - slowness(ArrayModes::Read(best).Spatial);
  const auto isWorthIt = [&](std::size_t small, std::size_t large)
  {
    const auto least =
      static_cast<std::size_t>(choice.BitsOfValue * static_cast<double>(values) / 8);
    return small + std::max(small / choice.Part, least) < large;
  };
  return slower > 0 ? isWorthIt(size, best.size())
    : slower < 0    ? !isWorthIt(best.size(), size)
                    : size < best.size();
}

/** Encodes with all possible combinations of modes and returns the best stream. */
template <typename Code>
Bytes EncodeBest(std::span<const SpatialMode> spatial, std::span<const Domain> domains,
  std::span<ComponentKeys> components, const ModeChoice& choice, Code&& code)
{
  // The values that readers will have depend on the modes if they are rounded.
  const bool areRounded = AreRounded(domains);
  const bool hasBefore = HaveBefore(components);
  const auto values = components.empty() ? 0 : components.size() * components.front().Now.size();
  Bytes best;
  std::vector<ComponentKeys> trial, rounded;
  const auto attempt = [&](const ArrayModes& modes)
  {
    EntropyEncoder coder;
    if (areRounded)
    {
      trial.assign(components.begin(), components.end());
    }
    code(coder, modes, areRounded ? std::span<ComponentKeys>(trial) : components);
    auto body = coder.Finish();
    if (best.empty() || IsBetter(modes, body.size() + 2, best, values, choice))
    {
      best.clear();
      best.push_back(static_cast<std::uint8_t>(modes.Spatial));
      best.push_back(static_cast<std::uint8_t>(modes.Temporal));
      best.insert(best.end(), body.begin(), body.end());
      rounded.swap(trial);
    }
  };
  for (const auto mode : spatial)
  {
    attempt({ mode, TemporalMode::None });
    if (hasBefore)
    {
      attempt({ mode, TemporalMode::Change });
    }
  }
  if (hasBefore)
  {
    attempt({ SpatialMode::Previous, TemporalMode::Repeat });
  }
  std::move(rounded.begin(), rounded.end(), components.begin());
  return best;
}

void CheckBefore(const ArrayModes& modes, std::span<const ComponentKeys> components)
{
  if (modes.Temporal != TemporalMode::None && !HaveBefore(components))
  {
    ThrowCorrupt("a stream needs a time step before it and there is none");
  }
}
}

//------------------------------------------------------------------------------
ArrayModes ArrayModes::Read(std::span<const std::uint8_t> stream)
{
  if (stream.size() < 2 || stream[0] > static_cast<std::uint8_t>(SpatialMode::Fast) ||
    stream[1] > 2)
  {
    ThrowCorrupt("an array's stream has an unknown mode");
  }
  const ArrayModes modes{ static_cast<SpatialMode>(stream[0]),
    static_cast<TemporalMode>(stream[1]) };
  if (IsQuadratic(modes.Spatial) && modes.Temporal == TemporalMode::Repeat)
  {
    ThrowCorrupt("an array's stream has modes that exclude each other");
  }
  return modes;
}

void CheckPointMode(SpatialMode mode, const Topology& mesh)
{
  if (mesh.HasTree() != (mode == SpatialMode::Fast))
  {
    ThrowCorrupt("an array's stream has a mode that its chunk cannot have");
  }
}

Bytes EncodePointValues(const PointContext& context, std::span<const Domain> domains,
  std::span<ComponentKeys> components, const ModeChoice& choice)
{
  if (context.Mesh->HasTree())
  {
    const GateVertices vertices{ context.Mesh->Gates, context.Mesh->Sources };
    return EncodeFast(domains, components,
      [&](ByteWriter& out, const Domain& domain, const GateKeys& keys)
      {
        const auto put = domain.GetQuantizer() ? PutVertexSteps : PutVertexValues;
        put(out, domain, vertices, keys);
      });
  }
  std::vector<SpatialMode> modes{ SpatialMode::Gate, SpatialMode::Previous };
  if (context.Fit)
  {
    modes.insert(modes.begin(), SpatialMode::Fit);
  }
  if (context.Quadratic)
  {
    // Last, so that each is compared with the best of those without weights.
    modes.insert(modes.end(), { SpatialMode::PlainQuadratic, SpatialMode::Quadratic });
  }
  return EncodeBest(modes, domains, components, choice,
    [&](EntropyEncoder& coder, const ArrayModes& chosen, std::span<ComponentKeys> keys)
    { CodePointComponents(coder, chosen, context, domains, keys); });
}

void DecodePointValues(std::span<const std::uint8_t> stream, const PointContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  const auto modes = ArrayModes::Read(stream);
  CheckBefore(modes, components);
  CheckPointMode(modes.Spatial, *context.Mesh);
  if ((modes.Spatial == SpatialMode::Fit && !context.Fit) ||
    (IsQuadratic(modes.Spatial) && !context.Quadratic))
  {
    ThrowCorrupt("a stream needs neighbors that are not there");
  }
  if (modes.Spatial == SpatialMode::Fast)
  {
    const GateVertices vertices{ context.Mesh->Gates, context.Mesh->Sources };
    if (modes.Temporal != TemporalMode::Repeat && HaveLanes(domains))
    {
      DecodeLanes(stream, modes.Temporal, vertices, components);
      return;
    }
    DecodeFast(stream, modes.Temporal, domains, components,
      [&](ByteReader& in, const Domain& domain, const GateKeys& keys)
      {
        const auto get = domain.GetQuantizer() ? GetVertexSteps : GetVertexValues;
        get(in, domain, vertices, keys);
      });
    return;
  }
  EntropyDecoder coder(stream.subspan(2));
  CodePointComponents(coder, modes, context, domains, components);
}

Bytes EncodeCellValues(const CellContext& context, std::span<const Domain> domains,
  std::span<ComponentKeys> components, const ModeChoice& choice)
{
  if (context.Coding == Profile::Fast)
  {
    return EncodeFast(domains, components,
      [&](ByteWriter& out, const Domain& domain, const GateKeys& keys)
      {
        if (domain.GetQuantizer())
        {
          PutItemSteps(out, domain, context.Parents, context.IsBlock(), keys);
        }
        else
        {
          PutItemValues(out, domain, context.Parents, keys);
        }
      });
  }
  std::vector<SpatialMode> modes{ SpatialMode::Previous };
  if (!context.IsBlock())
  {
    modes.push_back(SpatialMode::Gate);
  }
  if (context.Quadratic)
  {
    modes.insert(modes.end(), { SpatialMode::PlainQuadratic, SpatialMode::Quadratic });
  }
  return EncodeBest(modes, domains, components, choice,
    [&](EntropyEncoder& coder, const ArrayModes& chosen, std::span<ComponentKeys> keys)
    { CodeCellComponents(coder, chosen, context, domains, keys); });
}

void DecodeCellValues(std::span<const std::uint8_t> stream, const CellContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  const auto modes = ArrayModes::Read(stream);
  CheckBefore(modes, components);
  if (modes.Spatial == SpatialMode::Fit ||
    (modes.Spatial == SpatialMode::Gate && context.IsBlock()) ||
    (IsQuadratic(modes.Spatial) && !context.Quadratic))
  {
    ThrowCorrupt("a stream needs places around it that are not there");
  }
  if (modes.Spatial == SpatialMode::Fast)
  {
    DecodeFast(stream, modes.Temporal, domains, components,
      [&](ByteReader& in, const Domain& domain, const GateKeys& keys)
      {
        if (domain.GetQuantizer())
        {
          GetItemSteps(in, domain, context.Parents, context.IsBlock(), keys);
        }
        else
        {
          GetItemValues(in, domain, context.Parents, keys);
        }
      });
    return;
  }
  EntropyDecoder coder(stream.subspan(2));
  CodeCellComponents(coder, modes, context, domains, components);
}
}
