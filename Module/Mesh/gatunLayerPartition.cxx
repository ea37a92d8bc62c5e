// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunLayerPartition.h"

#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gatun
{
namespace
{
constexpr std::uint64_t ItemsPerLayerTask = 1u << 16;

// The maximum number of tetrahedra in the histogram.
constexpr std::uint64_t MostSamples = 1u << 20;

// The time to join buckets grows with the square of their number.
constexpr std::size_t ManyBuckets = 1u << 14;

//------------------------------------------------------------------------------
/** Calls body(task, begin, end) for ranges of items in parallel. */
template <typename Body>
void ForTasks(std::uint64_t items, Body&& body)
{
  ParallelFor(static_cast<std::size_t>((items + ItemsPerLayerTask - 1) / ItemsPerLayerTask),
    [&](std::size_t task)
    { body(task, task * ItemsPerLayerTask, std::min(items, (task + 1) * ItemsPerLayerTask)); });
}

//------------------------------------------------------------------------------
/** Marks the points that cells use. */
std::vector<bool> FindUsed(const MeshAccess& mesh)
{
  std::vector<bool> used(static_cast<std::size_t>(mesh.GetMesh().Points), false);
  for (std::uint64_t cell = 0; cell < mesh.GetMesh().Cells; ++cell)
  {
    mesh.ForEachPoint(
      cell, [&](std::uint64_t point) { used[static_cast<std::size_t>(point)] = true; });
  }
  return used;
}

/** Statistics of the finite values of used points. */
struct Moments
{
  Range Values;
  double Mean = 0;
  double Deviation = 0;
};

/** Sums for mean and deviation. */
struct Sums
{
  double Count = 0;
  double First = 0;
  double Second = 0;
};

Moments FindMoments(const MeshAccess& mesh, const LayerValues& values)
{
  const std::uint64_t points = mesh.GetMesh().Points;
  const std::vector<bool> used = FindUsed(mesh);
  const auto counts = [&](std::uint64_t point, double value)
  { return used[static_cast<std::size_t>(point)] && std::isfinite(value); };
  std::vector<Range> ranges(
    static_cast<std::size_t>(points / ItemsPerLayerTask + 1), Range::MakeEmpty());
  ForTasks(points,
    [&](std::size_t task, std::uint64_t begin, std::uint64_t end)
    {
      for (auto p = begin; p < end; ++p)
      {
        const double value = values.Get(p);
        if (counts(p, value))
        {
          ranges[task].Include(value);
        }
      }
    });
  Moments result;
  result.Values = ranges[0];
  for (const Range& range : ranges)
  {
    result.Values.Include(range);
  }
  // Relative to the largest value, so that no sum overflows.
  const double scale = std::max(std::abs(result.Values.Min), std::abs(result.Values.Max));
  if (!(scale > 0) || !std::isfinite(scale))
  {
    return result;
  }
  std::vector<Sums> sums(ranges.size());
  ForTasks(points,
    [&](std::size_t task, std::uint64_t begin, std::uint64_t end)
    {
      for (auto p = begin; p < end; ++p)
      {
        const double value = values.Get(p) / scale;
        if (counts(p, value))
        {
          sums[task].Count += 1;
          sums[task].First += value;
          sums[task].Second += value * value;
        }
      }
    });
  Sums all;
  for (const Sums& part : sums)
  {
    all.Count += part.Count;
    all.First += part.First;
    all.Second += part.Second;
  }
  const double mean = all.First / all.Count;
  result.Mean = scale * mean;
  result.Deviation = scale * std::sqrt(std::max(0.0, all.Second / all.Count - mean * mean));
  return result;
}

//------------------------------------------------------------------------------
/** The quantile of the standard normal distribution. */
double FindNormalQuantile(double part)
{
  double low = -10;
  double high = 10;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = (low + high) / 2;
    (0.5 * std::erfc(-middle / std::numbers::sqrt2) < part ? low : high) = middle;
  }
  return (low + high) / 2;
}

//------------------------------------------------------------------------------
/** A pseudorandom number that depends only on the seed. */
std::uint64_t Scramble(std::uint64_t seed)
{
  seed += 0x9e3779b97f4a7c15u;
  seed = (seed ^ (seed >> 30)) * 0xbf58476d1ce4e5b9u;
  seed = (seed ^ (seed >> 27)) * 0x94d049bb133111ebu;
  return seed ^ (seed >> 31);
}

/** The values in the middle of evenly sampled cells, ascending. */
std::vector<double> SampleMiddles(const MeshAccess& mesh, const LayerValues& values)
{
  const std::uint64_t cells = mesh.GetMesh().Cells;
  const std::uint64_t count = std::min(cells, MostSamples);
  std::vector<double> middles(static_cast<std::size_t>(count));
  ForTasks(count,
    [&](std::size_t, std::uint64_t begin, std::uint64_t end)
    {
      for (auto i = begin; i < end; ++i)
      {
        // One cell of each run, at a pseudorandom position.
        const std::uint64_t first = cells * i / count;
        const std::uint64_t run = cells * (i + 1) / count - first;
        const Range range = values.GetRange(mesh, first + Scramble(i) % run);
        middles[static_cast<std::size_t>(i)] = range.Min / 2 + range.Max / 2;
      }
    });
  std::erase_if(middles, [](double value) { return !std::isfinite(value); });
  std::sort(middles.begin(), middles.end());
  return middles;
}

//------------------------------------------------------------------------------
/** Cells of the same first and last layer. */
struct Bucket
{
  LayerSpan Span;
  std::size_t Cells = 0;
  std::uint32_t JoinedTo = 0; // its own number unless it was joined
};

double GetWidth(const LayerSpan& span)
{
  return 1.0 + (span.Last - span.First);
}

LayerSpan Join(const LayerSpan& a, const LayerSpan& b)
{
  return { std::min(a.First, b.First), std::max(a.Last, b.Last) };
}

/** The number of cells read needlessly, over all layers, if two buckets are joined. */
double GetCost(const Bucket& a, const Bucket& b)
{
  const double width = GetWidth(Join(a.Span, b.Span));
  return static_cast<double>(a.Cells) * (width - GetWidth(a.Span)) +
    static_cast<double>(b.Cells) * (width - GetWidth(b.Span));
}

void Join(std::vector<Bucket>& buckets, std::size_t from, std::size_t to)
{
  buckets[to].Span = Join(buckets[to].Span, buckets[from].Span);
  buckets[to].Cells += buckets[from].Cells;
  buckets[from].Cells = 0;
  buckets[from].JoinedTo = static_cast<std::uint32_t>(to);
}

/** Joins small buckets that begin in the same layer. The buckets must be sorted. */
void JoinRows(std::vector<Bucket>& buckets, std::size_t smallest)
{
  std::size_t open = 0;
  for (std::size_t i = 1; i < buckets.size(); ++i)
  {
    if (buckets[i].Span.First == buckets[open].Span.First && buckets[open].Cells < smallest &&
      buckets[i].Cells < smallest)
    {
      Join(buckets, i, open);
    }
    else
    {
      open = i;
    }
  }
}

/** Joins buckets that are too small, the smallest first, with those of least cost. */
void JoinSmall(std::vector<Bucket>& buckets, std::size_t smallest)
{
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < buckets.size(); ++i)
  {
    if (buckets[i].Cells > 0)
    {
      left.push_back(i);
    }
  }
  while (left.size() > 1)
  {
    const auto least = std::min_element(left.begin(), left.end(),
      [&](std::size_t a, std::size_t b) { return buckets[a].Cells < buckets[b].Cells; });
    const std::size_t from = *least;
    if (buckets[from].Cells >= smallest)
    {
      return;
    }
    left.erase(least);
    const std::size_t to = *std::min_element(left.begin(), left.end(),
      [&](std::size_t a, std::size_t b)
      { return GetCost(buckets[from], buckets[a]) < GetCost(buckets[from], buckets[b]); });
    Join(buckets, from, to);
  }
}
}

//------------------------------------------------------------------------------
std::uint32_t GetDefaultLayers(std::uint64_t tets)
{
  // Measured on meshes of one million tetrahedra. Thinner layers share nearly all of their points
  // and make files larger. With thicker layers more is read.
  constexpr double measured = 10;
  constexpr double measuredTets = 1e7;
  constexpr std::uint64_t leastTets = 16384;
  const double wanted =
    measured * std::cbrt(std::max(1.0, static_cast<double>(tets) / measuredTets));
  const auto most = std::clamp<std::uint64_t>(tets / leastTets, 4, MaxLayers);
  return std::min(static_cast<std::uint32_t>(wanted + 0.5), static_cast<std::uint32_t>(most));
}

//------------------------------------------------------------------------------
std::vector<double> FindLayerBounds(
  const MeshAccess& mesh, const LayerValues& values, LayerSpacing spacing, std::uint32_t count)
{
  const Moments moments = FindMoments(mesh, values);
  const Range& all = moments.Values;
  if (!(all.Min < all.Max))
  {
    return {};
  }
  std::vector<double> middles;
  if (spacing == LayerSpacing::Histogram)
  {
    middles = SampleMiddles(mesh, values);
    if (middles.empty())
    {
      return {};
    }
  }
  std::vector<double> bounds;
  for (std::uint32_t i = 1; i < count; ++i)
  {
    const double part = static_cast<double>(i) / count;
    const double bound = spacing == LayerSpacing::Uniform ? all.Min * (1 - part) + all.Max * part
      : spacing == LayerSpacing::Normal
      ? moments.Mean + moments.Deviation * FindNormalQuantile(part)
      : middles[static_cast<std::size_t>(part * static_cast<double>(middles.size()))];
    // The first and the last layer must not be empty.
    const double last = bounds.empty() ? all.Min : bounds.back();
    if (bound > last && bound <= all.Max && std::isfinite(bound))
    {
      bounds.push_back(bound);
    }
  }
  return bounds;
}

//------------------------------------------------------------------------------
LayerBuckets SortByLayers(
  const MeshAccess& mesh, const LayerValues& values, const Layers& layers, std::size_t smallest)
{
  const auto cells = static_cast<std::size_t>(mesh.GetMesh().Cells);
  const std::size_t count = layers.GetCount();
  std::vector<std::uint32_t> places(cells); // first layer and last layer; then bucket
  ForTasks(cells,
    [&](std::size_t, std::uint64_t begin, std::uint64_t end)
    {
      for (auto cell = begin; cell < end; ++cell)
      {
        const Range range = values.GetRange(mesh, cell);
        const std::size_t first = range.IsEmpty() ? 0 : layers.Find(range.Min);
        const std::size_t last = range.IsEmpty() ? 0 : layers.Find(range.Max);
        places[static_cast<std::size_t>(cell)] = static_cast<std::uint32_t>(first * count + last);
      }
    });

  std::vector<std::uint32_t> bucketOf(count * count);
  for (const auto place : places)
  {
    ++bucketOf[place];
  }
  std::vector<Bucket> buckets;
  for (std::size_t place = 0; place < bucketOf.size(); ++place)
  {
    if (const std::size_t here = bucketOf[place])
    {
      const auto number = static_cast<std::uint32_t>(buckets.size());
      buckets.push_back(
        { { static_cast<std::uint32_t>(place / count), static_cast<std::uint32_t>(place % count) },
          here, number });
      bucketOf[place] = number;
    }
  }
  if (buckets.size() > ManyBuckets)
  {
    JoinRows(buckets, smallest);
  }
  JoinSmall(buckets, smallest);

  // The remaining buckets, sorted by their layers.
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < buckets.size(); ++i)
  {
    if (buckets[i].JoinedTo == i)
    {
      left.push_back(i);
    }
  }
  std::stable_sort(left.begin(), left.end(),
    [&](std::uint32_t a, std::uint32_t b)
    {
      const LayerSpan& one = buckets[a].Span;
      const LayerSpan& other = buckets[b].Span;
      return one.First < other.First || (one.First == other.First && one.Last < other.Last);
    });
  LayerBuckets result;
  result.Start.push_back(0);
  std::vector<std::size_t> next(buckets.size());
  for (const auto i : left)
  {
    next[i] = result.Start.back();
    result.Start.push_back(next[i] + buckets[i].Cells);
  }
  const auto findRoot = [&](std::uint32_t i)
  {
    while (buckets[i].JoinedTo != i)
    {
      i = buckets[i].JoinedTo;
    }
    return i;
  };
  std::vector<std::uint32_t> roots(buckets.size());
  for (std::uint32_t i = 0; i < buckets.size(); ++i)
  {
    roots[i] = findRoot(i);
  }
  result.Cells.resize(cells);
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    result.Cells[next[roots[bucketOf[places[cell]]]]++] = static_cast<std::uint32_t>(cell);
  }
  return result;
}

//------------------------------------------------------------------------------
LayerSpan FindLayerSpan(const MeshAccess& mesh, const LayerValues& values, const Layers& layers,
  std::span<const std::uint32_t> cells)
{
  Range all = Range::MakeEmpty();
  for (const auto cell : cells)
  {
    all.Include(values.GetRange(mesh, cell));
  }
  return all.IsEmpty() ? LayerSpan{} : LayerSpan{ layers.Find(all.Min), layers.Find(all.Max) };
}
}
