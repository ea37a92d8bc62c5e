// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayCodec.h"

#include "gatunResidual.h"

#include <algorithm>
#include <cmath>

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
template <typename Coder>
Key CodeKey(Coder& coder, const Domain& domain, ResidualModel& model, unsigned spread,
  Key predicted, Key truth, std::int64_t& residual)
{
  residual = model.Code(coder, spread, Coder::Encoding ? domain.Subtract(truth, predicted) : 0);
  const Key key = domain.Add(predicted, residual);
  if (!Coder::Encoding && !domain.IsValid(key))
  {
    ThrowCorrupt("a value is not in the palette");
  }
  return key;
}

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
std::vector<double> GetNumbers(
  const Domain& domain, std::span<const Key> keys, const Topology& mesh, bool withOwn)
{
  std::vector<double> numbers(keys.size());
  for (std::size_t v = 0; v < keys.size(); ++v)
  {
    if (withOwn || mesh.IsShared(static_cast<Vertex>(v)))
    {
      numbers[v] = domain.ToNumber(keys[v]);
    }
  }
  return numbers;
}

template <typename Coder>
void CodePoints(Coder& coder, const ArrayModes& modes, const PointContext& context,
  const Domain& domain, ComponentKeys& keys)
{
  const SpatialPredictor predictor(context, modes.Spatial);
  const bool isPredicted =
    modes.Temporal != TemporalMode::Repeat && modes.Spatial != SpatialMode::Previous;
  std::vector<ResidualModel> models(SpatialPredictor::Groups);
  RunningSpread running;
  Key previous = domain.FromNumber(0);
  Key previousBefore = previous;
  const bool change = modes.Temporal == TemporalMode::Change;
  std::vector<double> numbers, numbersBefore;
  if (isPredicted)
  {
    numbers = GetNumbers(domain, keys.Now, *context.Mesh, false);
    numbersBefore = change ? GetNumbers(domain, keys.Before, *context.Mesh, true) : numbersBefore;
  }
  for (std::size_t own = 0; own < context.OwnIds.size(); ++own)
  {
    const Vertex v = context.OwnIds[own];
    Key predicted = previous;
    unsigned spread = running.Get();
    unsigned group = 0;
    if (modes.Temporal == TemporalMode::Repeat)
    {
      predicted = keys.Before[v];
    }
    else if (modes.Spatial == SpatialMode::Previous)
    {
      if (change)
      {
        predicted = domain.FromNumber(domain.ToNumber(keys.Before[v]) +
          (domain.ToNumber(previous) - domain.ToNumber(previousBefore)));
        previousBefore = keys.Before[v];
      }
    }
    else
    {
      const auto now = predictor.Predict(own, keys.Now, numbers);
      if (now.Known)
      {
        predicted = domain.FromNumber(now.Number);
        group = now.Group;
        spread = now.Spread != NoSpread ? now.Spread : spread;
        if (change)
        {
          const auto before = predictor.Predict(own, keys.Before, numbersBefore);
          predicted = domain.FromNumber(numbersBefore[v] + (now.Number - before.Number));
          spread = running.Get();
        }
      }
    }
    std::int64_t residual = 0;
    previous = CodeKey(coder, domain, models[group], spread, predicted, keys.Now[v], residual);
    keys.Now[v] = previous;
    if (isPredicted)
    {
      numbers[v] = domain.ToNumber(previous);
    }
    running.Add(residual);
  }
}

template <typename Coder>
void CodeCells(Coder& coder, const ArrayModes& modes, std::span<const std::uint32_t> parents,
  const Domain& domain, ComponentKeys& keys)
{
  ResidualModel model;
  RunningSpread running;
  const Key none = domain.FromNumber(0);
  for (std::size_t i = 0; i < keys.Now.size(); ++i)
  {
    std::size_t from = i - 1; // wraps around for the first one, which has no predecessor
    if (modes.Spatial == SpatialMode::Gate && parents[i] != Topology::NoTet)
    {
      from = parents[i];
    }
    const Key near = from < i ? keys.Now[from] : none;
    Key predicted = near;
    if (modes.Temporal == TemporalMode::Repeat)
    {
      predicted = keys.Before[i];
    }
    else if (modes.Temporal == TemporalMode::Change && from < i)
    {
      predicted = domain.FromNumber(domain.ToNumber(keys.Before[i]) +
        (domain.ToNumber(near) - domain.ToNumber(keys.Before[from])));
    }
    std::int64_t residual = 0;
    keys.Now[i] = CodeKey(coder, domain, model, running.Get(), predicted, keys.Now[i], residual);
    running.Add(residual);
  }
}

/** Encodes with all possible combinations of modes and returns the shortest stream. */
template <typename Code>
Bytes EncodeBest(std::span<const SpatialMode> spatial, bool hasBefore, Code&& code)
{
  Bytes best;
  const auto attempt = [&](const ArrayModes& modes)
  {
    EntropyEncoder coder;
    code(coder, modes);
    auto body = coder.Finish();
    if (best.empty() || body.size() + 2 < best.size())
    {
      best.clear();
      best.push_back(static_cast<std::uint8_t>(modes.Spatial));
      best.push_back(static_cast<std::uint8_t>(modes.Temporal));
      best.insert(best.end(), body.begin(), body.end());
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
  return best;
}

bool HaveBefore(std::span<const ComponentKeys> components)
{
  return std::all_of(components.begin(), components.end(),
    [](const ComponentKeys& keys) { return keys.Before.size() == keys.Now.size(); });
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
  return EncodeBest(context.Fit ? all : all.subspan(1), HaveBefore(components),
    [&](EntropyEncoder& coder, const ArrayModes& chosen)
    {
      for (std::size_t c = 0; c < components.size(); ++c)
      {
        CodePoints(coder, chosen, context, domains[c], components[c]);
      }
    });
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
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    CodePoints(coder, modes, context, domains[c], components[c]);
  }
}

Bytes EncodeCellValues(std::span<const std::uint32_t> parents, std::span<const Domain> domains,
  std::span<ComponentKeys> components)
{
  static constexpr std::array modes{ SpatialMode::Previous, SpatialMode::Gate };
  const std::span<const SpatialMode> all(modes);
  return EncodeBest(parents.empty() ? all.first(1) : all, HaveBefore(components),
    [&](EntropyEncoder& coder, const ArrayModes& chosen)
    {
      for (std::size_t c = 0; c < components.size(); ++c)
      {
        CodeCells(coder, chosen, parents, domains[c], components[c]);
      }
    });
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
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    CodeCells(coder, modes, parents, domains[c], components[c]);
  }
}
}
