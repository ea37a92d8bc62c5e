// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGateFrame.h"

#include "gatunRuleFitter.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** Least squares with few unknowns. */
template <std::size_t N>
class Regression
{
public:
  void Add(const std::array<double, N>& known, double wanted)
  {
    for (std::size_t r = 0; r < N; ++r)
    {
      this->Right[r] += known[r] * wanted;
      for (std::size_t c = 0; c < N; ++c)
      {
        this->Normal[r][c] += known[r] * known[c];
      }
    }
    this->Squares += wanted * wanted;
    this->Count += 1;
  }

  /** The factors, and the root of the mean square of what they leave. */
  std::pair<std::array<double, N>, double> Solve() const
  {
    auto normal = this->Normal;
    auto factors = this->Right;
    for (std::size_t r = 0; r < N; ++r)
    {
      normal[r][r] += 1e-9 + 1e-6 * normal[r][r];
    }
    if (!gatun::Solve(normal, factors))
    {
      factors = {};
    }
    double left = this->Squares;
    for (std::size_t r = 0; r < N; ++r)
    {
      left -= factors[r] * this->Right[r];
    }
    return { factors, std::sqrt(left / this->Count) };
  }

private:
  std::array<std::array<double, N>, N> Normal{};
  std::array<double, N> Right{};
  double Squares = 0;
  double Count = 0;
};
}

//------------------------------------------------------------------------------
std::optional<FrameRule> FitFrame(std::span<const GateRecord> records, std::span<const Vertex> ids,
  std::span<const std::array<Key, 3>> keys, const std::array<Domain, 3>& domain)
{
  using Numbers = GateFrame::Numbers;
  std::vector<Numbers> numbers(keys.size());
  for (std::size_t v = 0; v < keys.size(); ++v)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      numbers[v][i] = domain[i].ToNumber(keys[v][i]);
    }
  }
  Regression<1> along;
  Regression<2> across;
  for (std::size_t n = 0; n < records.size(); ++n)
  {
    if (records[n].IsSeed())
    {
      continue;
    }
    const GateFrame frame(records[n], numbers);
    const double unit = 1.0 / frame.Size;
    FrameVector way{};
    double square = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      way[i] = (numbers[ids[n]][i] - frame.Middle[i]) * unit;
      square += way[i] * way[i];
    }
    if (!(square < 4))
    {
      continue; // outliers would count too much
    }
    const double height = Dot(way, frame.Normal);
    along.Add({ 1.0 }, height);
    for (unsigned i = 0; i < 3; ++i)
    {
      across.Add(
        { frame.Center[i] * unit, frame.Far[i] * unit * unit }, way[i] - height * frame.Normal[i]);
    }
  }
  const auto [heights, deviation] = along.Solve();
  const auto [ways, wide] = across.Solve();
  FrameRule rule;
  const auto set = [&](FrameRule::Weight weight, double value)
  {
    const double scaled = std::floor(256.0 * value + 0.5);
    rule.Weights[weight] =
      static_cast<std::int16_t>(std::isfinite(scaled) ? std::clamp(scaled, -4096.0, 4096.0) : 0.0);
  };
  set(FrameRule::Height, heights[0]);
  set(FrameRule::AcrossOfCenter, ways[0]);
  set(FrameRule::AcrossOfFar, ways[1]);
  // The components of ways across share two dimensions.
  set(FrameRule::Across, wide * std::sqrt(1.5));
  set(FrameRule::Along, deviation);
  return rule.IsValid() ? std::optional(rule) : std::nullopt;
}
}
