// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayCodec.h"

#include "gatunBoundedValues.h"
#include "gatunExactValues.h"
#include "gatunGuess.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace gatun
{
namespace
{
/** The neighbors of a vertex relative to it, and their weights before they are normalized. */
struct Offsets
{
  void Resize(std::size_t count)
  {
    if (count > this->X.size())
    {
      for (auto* list : { &this->X, &this->Y, &this->Z, &this->Weight })
      {
        list->resize(2 * count);
      }
    }
  }

  std::vector<double> X, Y, Z, Weight;
};

/** Computes the weights of the neighbors of a vertex. */
void FindWeights(const std::array<double, 3>& center, std::span<NeighborFit::Neighbor> neighbors,
  std::span<const std::array<double, 3>> places, Offsets& offsets)
{
  // Weighted least squares of value = c0 + c . (x - center). The result is c0, a weighted sum of
  // the values. With fewer than four neighbors, c is left out.
  const auto count = neighbors.size();
  offsets.Resize(count);
  double mean = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& p = places[neighbors[i].Id];
    const double x = p[0] - center[0], y = p[1] - center[1], z = p[2] - center[2];
    offsets.X[i] = x;
    offsets.Y[i] = y;
    offsets.Z[i] = z;
    mean += x * x + y * y + z * z;
  }
  mean = mean / static_cast<double>(count);
  const double scale = 1.0 / std::sqrt(mean);
  if (!std::isfinite(scale))
  {
    for (auto& n : neighbors)
    {
      n.Weight = 1.0 / static_cast<double>(count);
    }
    return;
  }
  // A loop of its own, because it can be vectorized. The sums cannot: their order matters.
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = offsets.X[i] * scale, y = offsets.Y[i] * scale, z = offsets.Z[i] * scale;
    offsets.X[i] = x;
    offsets.Y[i] = y;
    offsets.Z[i] = z;
    offsets.Weight[i] = 1.0 / (x * x + y * y + z * z + 1e-6);
  }
  double m = 0, mx = 0, my = 0, mz = 0;
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = offsets.X[i], y = offsets.Y[i], z = offsets.Z[i], w = offsets.Weight[i];
    const double wx = w * x, wy = w * y, wz = w * z;
    m += w;
    mx += wx;
    my += wy;
    mz += wz;
    xx += wx * x;
    xy += wx * y;
    xz += wx * z;
    yy += wy * y;
    yz += wy * z;
    zz += wz * z;
  }
  double bx = 0, by = 0, bz = 0;
  if (count >= 4)
  {
    const double ridge = 1e-4 * (m + xx + yy + zz);
    xx += ridge;
    yy += ridge;
    zz += ridge;
    // b = inverse of the symmetric matrix times (mx, my, mz), by cofactors
    const double axx = yy * zz - yz * yz;
    const double axy = xz * yz - xy * zz;
    const double axz = xy * yz - xz * yy;
    const double ayy = xx * zz - xz * xz;
    const double ayz = xy * xz - xx * yz;
    const double azz = xx * yy - xy * xy;
    const double inverse = 1.0 / (xx * axx + xy * axy + xz * axz);
    bx = (axx * mx + axy * my + axz * mz) * inverse;
    by = (axy * mx + ayy * my + ayz * mz) * inverse;
    bz = (axz * mx + ayz * my + azz * mz) * inverse;
  }
  const double whole = 1.0 / (m - (bx * mx + by * my + bz * mz));
  for (std::size_t i = 0; i < count; ++i)
  {
    const double inside = bx * offsets.X[i] + by * offsets.Y[i] + bz * offsets.Z[i];
    neighbors[i].Weight = offsets.Weight[i] * whole * (1.0 - inside);
  }
}
}

//------------------------------------------------------------------------------
NeighborFit::NeighborFit(const Topology& topology, std::span<const std::array<double, 3>> places)
  : Start(topology.GetOwnVertices() + 2, 0)
{
  // The later end of an edge knows the earlier one, but shared vertices are known from the start.
  // Edges between two shared vertices are appended to all lists, because branches would cost more.
  const auto none = static_cast<std::uint32_t>(topology.GetOwnVertices());
  const auto eachPair = [&](auto&& pair)
  {
    for (const auto& edge : topology.EdgeLog)
    {
      const Vertex low = std::min(edge[0], edge[1]);
      const Vertex high = std::max(edge[0], edge[1]);
      const bool later = !topology.IsShared(high);
      const auto own = topology.Sources[later ? high : low];
      pair((own & Topology::SharedFlag) != 0 ? none : own, later ? low : high);
    }
  };
  eachPair([&](std::uint32_t own, Vertex) { ++this->Start[own + 1]; });
  for (std::size_t i = 1; i < this->Start.size(); ++i)
  {
    this->Start[i] += this->Start[i - 1];
  }
  this->List.resize(this->Start.back());
  auto next = this->Start;
  eachPair([&](std::uint32_t own, Vertex known) { this->List[next[own]++] = { known, 0 }; });

  Offsets offsets;
  for (Vertex v = 0; v < topology.Sources.size(); ++v)
  {
    if (!topology.IsShared(v))
    {
      const auto own = topology.Sources[v];
      FindWeights(places[v],
        { this->List.data() + this->Start[own], this->Start[own + 1] - this->Start[own] }, places,
        offsets);
    }
  }
}

//------------------------------------------------------------------------------
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
    const auto rule = this->Context.UsedRules[own];
    const auto number = [&](unsigned k) { return std::array{ numbers[record.Known[k]] }; };
    result.Number = ApplyRule<1>((*this->Context.Rules)[rule], number)[0];
    result.Spread = static_cast<unsigned>(std::bit_width(high - low));
    result.Group = 1u + rule;
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
    const auto rule = this->Context.UsedRules[own];
    const auto number = [&](unsigned k)
    {
      const auto v = record.Known[k];
      return std::array{ v != NoVertex ? numbers[v] : 0.0 };
    };
    result.Number = ApplyRule<1>((*this->Context.CellRules)[rule], number)[0];
    result.Spread = GetSpread(record, [keys](Vertex v) { return keys[v]; });
    result.Group = std::min(1u + rule, Groups - 1);
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
void CodePoints(Coder& coder, const ArrayModes& modes, const PointContext& context,
  const Domain& domain, Values&& values, ComponentKeys& keys)
{
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
void CodeCells(Coder& coder, const ArrayModes& modes, std::span<const std::uint32_t> parents,
  const Domain& domain, Values&& values, ComponentKeys& keys)
{
  const Key none = domain.FromNumber(0);
  for (std::size_t i = 0; i < keys.Now.size(); ++i)
  {
    std::size_t from = i - 1; // wraps around for the first one, which has no predecessor
    if (modes.Spatial == SpatialMode::Gate && parents[i] != Topology::NoTet)
    {
      from = parents[i];
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
  if (!domain.GetQuantizer())
  {
    return code(ExactValues(domain, keys.Now.size()));
  }
  const bool isExact = Coder::Encoding && BoundedValues::AreTooFine(domain, keys.Now);
  if (coder.Raw(isExact, 1) != 0)
  {
    return code(ExactValues(domain, keys.Now.size()));
  }
  code(BoundedValues(domain, keys.Now.size(), onLattice || domain.GetQuantizer().OnLattice));
}

template <typename Coder>
void CodePointComponents(Coder& coder, const ArrayModes& modes, const PointContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    CodeComponent(coder, domains[c], false, components[c],
      [&](auto&& values) { CodePoints(coder, modes, context, domains[c], values, components[c]); });
  }
}

template <typename Coder>
void CodeCellComponents(Coder& coder, const ArrayModes& modes,
  std::span<const std::uint32_t> parents, std::span<const Domain> domains,
  std::span<ComponentKeys> components)
{
  // Without parents, these are values on blocks: other processes round them, too.
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    CodeComponent(coder, domains[c], parents.empty(), components[c],
      [&](auto&& values) { CodeCells(coder, modes, parents, domains[c], values, components[c]); });
  }
}

bool HaveBefore(std::span<const ComponentKeys> components)
{
  return std::all_of(components.begin(), components.end(),
    [](const ComponentKeys& keys) { return keys.Before.size() == keys.Now.size(); });
}

/** Encodes with all possible combinations of modes and returns the shortest stream. */
template <typename Code>
Bytes EncodeBest(std::span<const SpatialMode> spatial, std::span<const Domain> domains,
  std::span<ComponentKeys> components, Code&& code)
{
  // The values that readers will have depend on the modes if they are rounded.
  const bool areRounded = std::any_of(domains.begin(), domains.end(),
    [](const Domain& domain) { return static_cast<bool>(domain.GetQuantizer()); });
  const bool hasBefore = HaveBefore(components);
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
    if (best.empty() || body.size() + 2 < best.size())
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
  if (stream.size() < 2 || stream[0] > 2 || stream[1] > 2)
  {
    ThrowCorrupt("an array's stream has an unknown mode");
  }
  return { static_cast<SpatialMode>(stream[0]), static_cast<TemporalMode>(stream[1]) };
}

Bytes EncodePointValues(
  const PointContext& context, std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  static constexpr std::array modes{ SpatialMode::Fit, SpatialMode::Gate, SpatialMode::Previous };
  const std::span<const SpatialMode> all(modes);
  return EncodeBest(context.Fit ? all : all.subspan(1), domains, components,
    [&](EntropyEncoder& coder, const ArrayModes& chosen, std::span<ComponentKeys> keys)
    { CodePointComponents(coder, chosen, context, domains, keys); });
}

void DecodePointValues(std::span<const std::uint8_t> stream, const PointContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  const auto modes = ArrayModes::Read(stream);
  CheckBefore(modes, components);
  if (modes.Spatial == SpatialMode::Fit && !context.Fit)
  {
    ThrowCorrupt("a stream needs neighbors that are not there");
  }
  EntropyDecoder coder(stream.subspan(2));
  CodePointComponents(coder, modes, context, domains, components);
}

Bytes EncodeCellValues(std::span<const std::uint32_t> parents, std::span<const Domain> domains,
  std::span<ComponentKeys> components)
{
  static constexpr std::array modes{ SpatialMode::Previous, SpatialMode::Gate };
  const std::span<const SpatialMode> all(modes);
  return EncodeBest(parents.empty() ? all.first(1) : all, domains, components,
    [&](EntropyEncoder& coder, const ArrayModes& chosen, std::span<ComponentKeys> keys)
    { CodeCellComponents(coder, chosen, parents, domains, keys); });
}

void DecodeCellValues(std::span<const std::uint8_t> stream, std::span<const std::uint32_t> parents,
  std::span<const Domain> domains, std::span<ComponentKeys> components)
{
  const auto modes = ArrayModes::Read(stream);
  CheckBefore(modes, components);
  if (modes.Spatial == SpatialMode::Fit || (modes.Spatial == SpatialMode::Gate && parents.empty()))
  {
    ThrowCorrupt("a stream needs parents that are not there");
  }
  EntropyDecoder coder(stream.subspan(2));
  CodeCellComponents(coder, modes, parents, domains, components);
}
}
