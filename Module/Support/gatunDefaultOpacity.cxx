// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunDefaultOpacity.h"

#include "gatunFraming.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace gatun
{
namespace
{
// Found by comparing images of many meshes and scans.
constexpr double LeastInnerPart = 0.95;   // of the range; else all of it is colored
constexpr double OpticalDepth = 1.3;      // of the mean ray, if all of the object contributes alike
constexpr double FlatOpticalDepth = 0.7;  // the same for an object of one value
constexpr double LeastWeight = 0.1;       // of the median
constexpr double LeastDensity = 0.03;     // of a value, where 1 is the mean
constexpr double LargestExtinction = 2.5; // per unit distance
constexpr double Smoothing = 6;           // standard deviation, in bins
constexpr std::size_t Bins = 512;
constexpr std::size_t Nodes = 129; // before those that change little are dropped

/** Along a mean ray through the box, the length inside of the object, by Cauchy's formula: four
 * times the volume by the surface. */
double GetMeanChord(const ValueSurvey& survey)
{
  std::array<double, 3> edge{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    edge[axis] = std::max(0., survey.Box[axis].Max - survey.Box[axis].Min);
  }
  const double surface = 2 * (edge[0] * edge[1] + edge[1] * edge[2] + edge[2] * edge[0]);
  const double chord = 4 * survey.Volume / surface;
  const double diagonal = std::hypot(edge[0], edge[1], edge[2]);
  return chord > 0 && std::isfinite(chord) ? chord : diagonal > 0 ? diagonal / 3 : 1;
}

std::vector<double> Smooth(const std::vector<double>& values)
{
  constexpr int reach = static_cast<int>(4 * Smoothing);
  std::array<double, 2 * reach + 1> kernel{};
  for (int i = -reach; i <= reach; ++i)
  {
    kernel[static_cast<std::size_t>(i + reach)] = std::exp(-i * i / (2 * Smoothing * Smoothing));
  }
  const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.);
  const int count = static_cast<int>(values.size());
  std::vector<double> smooth(values.size(), 0);
  for (int i = 0; i < count; ++i)
  {
    for (int j = -reach; j <= reach; ++j)
    {
      const auto from = static_cast<std::size_t>(std::clamp(i + j, 0, count - 1));
      smooth[static_cast<std::size_t>(i)] +=
        values[from] * kernel[static_cast<std::size_t>(j + reach)] / sum;
    }
  }
  return smooth;
}

double GetPlace(std::size_t bin)
{
  return (static_cast<double>(bin) + 0.5) / static_cast<double>(Bins);
}

/** The extinction of each bin, of any scale. */
std::vector<double> GetExtinctions(const std::vector<double>& fractions)
{
  const std::vector<double> smooth = Smooth(fractions);
  double below = 0;
  std::size_t middle = 0;
  const double half = std::accumulate(fractions.begin(), fractions.end(), 0.) / 2;
  while (middle + 1 < Bins && below + fractions[middle] < half)
  {
    below += fractions[middle];
    ++middle;
  }
  const double median = GetPlace(middle);
  std::vector<double> extinctions(Bins);
  for (std::size_t bin = 0; bin < Bins; ++bin)
  {
    const double away = std::abs(GetPlace(bin) - median) / std::max(median, 1 - median);
    const double density = smooth[bin] * static_cast<double>(Bins);
    extinctions[bin] = (LeastWeight + (1 - LeastWeight) * away) / (density + LeastDensity);
  }
  return extinctions;
}

/** Scales extinctions so that their mean over the object is as given, as far as the largest one
 * allows. */
void Scale(std::vector<double>& extinctions, const std::vector<double>& fractions, double mean)
{
  const auto getMean = [&](double factor)
  {
    double sum = 0;
    for (std::size_t bin = 0; bin < Bins; ++bin)
    {
      sum += std::min(extinctions[bin] * factor, LargestExtinction) * fractions[bin];
    }
    return sum;
  };
  // The mean grows with the factor.
  double low = 0;
  double high = 1;
  for (int i = 0; i < 200 && getMean(high) < mean; ++i)
  {
    low = high;
    high *= 2;
    if (getMean(high) <= getMean(low))
    {
      break; // all are the largest
    }
  }
  for (int i = 0; i < 50; ++i)
  {
    const double factor = (low + high) / 2;
    (getMean(factor) < mean ? low : high) = factor;
  }
  for (double& extinction : extinctions)
  {
    extinction = std::min(extinction * high, LargestExtinction);
  }
}

/** The part of the object that contributes, as if it did so evenly. */
double GetContributing(const std::vector<double>& extinctions, const std::vector<double>& fractions)
{
  double sum = 0;
  double squares = 0;
  for (std::size_t bin = 0; bin < Bins; ++bin)
  {
    sum += extinctions[bin] * fractions[bin];
    squares += extinctions[bin] * extinctions[bin] * fractions[bin];
  }
  return squares > 0 ? std::min(1., sum * sum / squares) : 1;
}

/** Keeps the nodes without which a line would be off by more than a little; recursive, between two
 * nodes that are kept. */
void Simplify(const std::vector<OpacityNode>& nodes, std::size_t first, std::size_t last,
  std::vector<OpacityNode>& kept)
{
  std::size_t worst = first;
  double largest = 1;
  for (std::size_t i = first + 1; i < last; ++i)
  {
    const double along = static_cast<double>(i - first) / static_cast<double>(last - first);
    const double line = nodes[first].Opacity * (1 - along) + nodes[last].Opacity * along;
    const double off = std::abs(line - nodes[i].Opacity) / (0.002 + 0.05 * nodes[i].Opacity);
    if (off > largest)
    {
      largest = off;
      worst = i;
    }
  }
  if (worst != first)
  {
    Simplify(nodes, first, worst, kept);
    Simplify(nodes, worst, last, kept);
    return;
  }
  kept.push_back(nodes[last]);
}

std::vector<OpacityNode> MakeNodes(const std::vector<double>& extinctions, const Range& range)
{
  std::vector<OpacityNode> nodes;
  for (std::size_t i = 0; i < Nodes; ++i)
  {
    const double along = static_cast<double>(i) / static_cast<double>(Nodes - 1);
    const double at =
      std::clamp(along * static_cast<double>(Bins) - 0.5, 0., static_cast<double>(Bins - 1));
    const auto bin = std::min(static_cast<std::size_t>(at), Bins - 2);
    const double within = at - static_cast<double>(bin);
    const double extinction = extinctions[bin] * (1 - within) + extinctions[bin + 1] * within;
    const double value = range.Min * (1 - along) + range.Max * along;
    if (nodes.empty() || value > nodes.back().Value)
    {
      nodes.push_back({ value, -std::expm1(-extinction) });
    }
  }
  std::vector<OpacityNode> kept{ nodes.front() };
  if (nodes.size() > 1)
  {
    Simplify(nodes, 0, nodes.size() - 1, kept);
  }
  return kept;
}
}

//------------------------------------------------------------------------------
std::span<const DefaultColor> GetDefaultColors()
{
  // Five colors, with those between them in the space CIE Lab, so that all who use them may
  // interpolate linearly.
  static constexpr std::array<DefaultColor, 21> colors{ { { 0, { 0.300, 0.100, 0.450 } },
    { 0.05, { 0.297, 0.153, 0.475 } }, { 0.1, { 0.292, 0.199, 0.499 } },
    { 0.15, { 0.283, 0.241, 0.524 } }, { 0.2, { 0.271, 0.282, 0.549 } },
    { 0.25, { 0.254, 0.321, 0.575 } }, { 0.3, { 0.230, 0.360, 0.600 } },
    { 0.35, { 0.233, 0.403, 0.591 } }, { 0.4, { 0.231, 0.447, 0.582 } },
    { 0.45, { 0.222, 0.490, 0.573 } }, { 0.5, { 0.205, 0.533, 0.563 } },
    { 0.55, { 0.177, 0.576, 0.552 } }, { 0.6, { 0.130, 0.620, 0.540 } },
    { 0.65, { 0.291, 0.660, 0.493 } }, { 0.7, { 0.389, 0.702, 0.443 } },
    { 0.75, { 0.468, 0.744, 0.388 } }, { 0.8, { 0.537, 0.787, 0.326 } },
    { 0.85, { 0.600, 0.830, 0.250 } }, { 0.9, { 0.736, 0.858, 0.236 } },
    { 0.95, { 0.865, 0.885, 0.220 } }, { 1, { 0.990, 0.910, 0.200 } } } };
  return colors;
}

//------------------------------------------------------------------------------
std::span<const OpacityNode> GetDefaultRamp()
{
  static constexpr std::array<OpacityNode, 3> ramp{ { { 0, 0.01 }, { 0.3, 0.06 }, { 1, 0.45 } } };
  return ramp;
}

//------------------------------------------------------------------------------
DefaultTransfer MakeDefaultTransfer(
  const ValueSurvey& survey, double unitDistance, const std::optional<Range>& range)
{
  const ValueHistogram& values = survey.Values;
  const double units = GetMeanChord(survey) / unitDistance;
  DefaultTransfer transfer;
  Range& colors = transfer.Colors;
  colors = values.GetRange();
  if (range)
  {
    colors = *range;
  }
  else if (values.HasExtent())
  {
    const Range inner = values.GetInnerRange(ValueHistogram::OuterFraction);
    const double bins = values.CountBins(inner);
    // Less than two bins: nearly everything has one value.
    colors = bins >= 2 && bins < LeastInnerPart * ValueHistogram::Bins ? inner : colors;
  }
  if (!(colors.Min < colors.Max) || (!range && !values.HasExtent()))
  {
    // A lone value gets the color in the middle.
    const double margin = std::max(0.5, std::abs(colors.Min) / 100);
    colors = { colors.Min - margin, colors.Max + margin };
    const double opacity = -std::expm1(-std::min(FlatOpticalDepth / units, LargestExtinction));
    transfer.Opacities = { { colors.Min, opacity }, { colors.Max, opacity } };
    return transfer;
  }
  const std::vector<double> fractions = values.GetFractions(colors, Bins);
  std::vector<double> extinctions = GetExtinctions(fractions);
  Scale(extinctions, fractions,
    OpticalDepth * std::cbrt(GetContributing(extinctions, fractions)) / units);
  transfer.Opacities = MakeNodes(extinctions, colors);
  return transfer;
}

//------------------------------------------------------------------------------
double GetDefaultUnitDistance(const Bounds& box)
{
  return GetPositiveDiagonal(box) / 100;
}
}
