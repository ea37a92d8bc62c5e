// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunQuadraticFit.h"

#include "gatunQuadraticLanes.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace gatun
{
namespace
{
using Places = NeighborLists::Places;

/** Sets a lane to the offsets of neighbors from the center, of which the mean square is 1. If that
 * cannot be, all are 0. Returns what the offsets were multiplied by, or 0. */
double SetLane(QuadraticLanes& lanes, std::size_t lane, const std::array<double, 3>& center,
  std::span<const Vertex> neighbors, std::span<const std::uint8_t> isShared, Places places)
{
  double sum = 0;
  for (const Vertex u : neighbors)
  {
    const auto& p = places[u];
    const double x = p[0] - center[0], y = p[1] - center[1], z = p[2] - center[2];
    sum += x * x + y * y + z * z;
  }
  const double mean = sum / static_cast<double>(neighbors.size());
  const bool isUsable = mean > 0 && mean <= std::numeric_limits<double>::max();
  const double scale = 1.0 / std::sqrt(mean);
  for (std::size_t i = 0; i < neighbors.size(); ++i)
  {
    const auto& p = places[neighbors[i]];
    lanes.X[i][lane] = isUsable ? static_cast<float>((p[0] - center[0]) * scale) : 0;
    lanes.Y[i][lane] = isUsable ? static_cast<float>((p[1] - center[1]) * scale) : 0;
    lanes.Z[i][lane] = isUsable ? static_cast<float>((p[2] - center[2]) * scale) : 0;
    lanes.Used[i][lane] = 1;
    lanes.Share[i][lane] = isShared[neighbors[i]] != 0 ? 0 : 1; // no error is known there
  }
  for (std::size_t i = neighbors.size(); i < NeighborLists::MaxNeighbors; ++i)
  {
    lanes.X[i][lane] = lanes.Y[i][lane] = lanes.Z[i][lane] = 0;
    lanes.Used[i][lane] = lanes.Share[i][lane] = 0;
  }
  const auto count = static_cast<float>(std::max<std::size_t>(neighbors.size(), 1));
  lanes.PerNeighbor[lane] = 3 / count;
  lanes.Equal[lane] = 1 / count;
  lanes.Neighbors = std::max(lanes.Neighbors, neighbors.size());
  return isUsable ? scale : 0;
}

/** Sets a lane to the moments of a vertex and of those of its neighbors that have some. offset: of
 * a neighbor, as a squared distance in units of the vertex. */
template <typename MomentsOf, typename DistanceTo>
void SetLane(CorrectionLanes& lanes, std::size_t lane, const MomentsOf& own,
  std::span<const MomentsOf> moments, std::span<const Vertex> neighbors, DistanceTo&& distanceTo)
{
  for (std::size_t k = 0; k < own.Values.size(); ++k)
  {
    lanes.Own[k][lane] = own.Values[k];
  }
  const auto count = std::min(neighbors.size(), NeighborLists::MaxCorrecting);
  for (std::size_t i = 0; i < NeighborLists::MaxCorrecting; ++i)
  {
    float unit = 0; // of the neighbor's moments
    if (i < count && own.Scale > 0 && moments[neighbors[i]].Scale > 0)
    {
      const auto ratio = static_cast<float>(own.Scale / moments[neighbors[i]].Scale);
      unit = ratio * ratio * ratio;
      unit = unit <= 1e6f ? unit : 0;
    }
    lanes.Nearness[i][lane] = unit > 0 ? 1 / (distanceTo(neighbors[i]) + 0.3f) : 0;
    for (std::size_t k = 0; k < own.Values.size(); ++k)
    {
      lanes.Moment[i][k][lane] = unit > 0 ? moments[neighbors[i]].Values[k] * unit : 0;
    }
  }
  lanes.Neighbors = std::max(lanes.Neighbors, count);
}
}

//------------------------------------------------------------------------------
QuadraticFit::QuadraticFit(const Topology& topology, Places places, bool withCorrections)
{
  std::vector<Vertex> centers;
  std::vector<std::uint8_t> isShared(places.size());
  centers.reserve(topology.GetOwnVertices());
  for (Vertex v = 0; v < places.size(); ++v)
  {
    isShared[v] = topology.IsShared(v) ? 1 : 0;
    if (isShared[v] == 0)
    {
      centers.push_back(v);
    }
  }
  this->FindWeights(
    NeighborLists::OfWalk(topology, places), places, centers, isShared, withCorrections);
}

QuadraticFit::QuadraticFit(const NeighborLists& lists, Places places, bool withCorrections)
{
  std::vector<Vertex> centers(places.size());
  std::iota(centers.begin(), centers.end(), 0u);
  this->FindWeights(
    lists, places, centers, std::vector<std::uint8_t>(places.size()), withCorrections);
}

void QuadraticFit::MakeLists(const NeighborLists& lists, bool withCorrections)
{
  constexpr auto group = Neighbors::Group;
  const auto own = lists.GetCenters();
  this->Start.reserve(own + 1);
  this->Start.push_back(0);
  for (std::size_t i = 0; i < own; ++i)
  {
    const auto count = (lists.Of(i).size() + group - 1) / group * group;
    this->Start.push_back(this->Start.back() + static_cast<std::uint32_t>(count));
  }
  this->Ids.resize(this->Start.back());
  this->Quadratic.resize(this->Start.back());
  this->Linear.resize(this->Start.back());
  this->Shares.resize(this->Start.back());
  this->Corrections.resize(withCorrections ? this->Start.back() : 0);
  for (std::size_t i = 0; i < own; ++i)
  {
    const auto list = lists.Of(i);
    for (std::size_t k = this->Start[i]; k < this->Start[i + 1]; ++k)
    {
      this->Ids[k] = list[k - this->Start[i] < list.size() ? k - this->Start[i] : 0];
    }
  }
}

void QuadraticFit::FindWeights(const NeighborLists& lists, NeighborLists::Places places,
  std::span<const Vertex> centers, std::span<const std::uint8_t> isShared, bool withCorrections)
{
  this->MakeLists(lists, withCorrections);
  std::vector<Moments> moments(withCorrections ? places.size() : 0);
  const auto own = centers.size();
  const auto& kernels = GetBestQuadraticKernels();
  QuadraticLanes lanes;
  for (std::size_t first = 0; first < own; first += QuadraticLanes::Count)
  {
    const auto end = std::min(own, first + QuadraticLanes::Count);
    lanes.Neighbors = 0;
    std::array<double, QuadraticLanes::Count> scales{};
    for (std::size_t i = first; i < first + QuadraticLanes::Count; ++i)
    {
      scales[i - first] = i < end
        ? SetLane(lanes, i - first, places[centers[i]], lists.Of(i), isShared, places)
        : SetLane(lanes, i - first, {}, {}, isShared, places);
    }
    QuadraticLanes offsets;
    if (withCorrections)
    {
      offsets = lanes;
    }
    kernels.FindWeights(lanes);
    if (withCorrections)
    {
      std::memcpy(offsets.Quadratic, lanes.Quadratic, sizeof(offsets.Quadratic));
      kernels.FindMoments(offsets);
    }
    for (std::size_t i = first; i < end; ++i)
    {
      const auto count = lists.Of(i).size();
      const auto lane = i - first;
      const auto start = this->Start[i];
      for (std::size_t k = 0; k < count; ++k)
      {
        this->Quadratic[start + k] = lanes.Quadratic[k][lane];
        this->Linear[start + k] = lanes.Linear[k][lane];
        this->Shares[start + k] = lanes.Share[k][lane];
      }
      if (withCorrections && count > 0)
      {
        auto& found = moments[centers[i]];
        found.Scale = scales[lane];
        for (std::size_t k = 0; k < found.Values.size(); ++k)
        {
          found.Values[k] = offsets.Moment[k][lane];
        }
      }
    }
  }
  if (withCorrections)
  {
    this->FindCorrections(lists, places, centers, moments);
  }
}

void QuadraticFit::FindCorrections(const NeighborLists& lists, NeighborLists::Places places,
  std::span<const Vertex> centers, std::span<const Moments> moments)
{
  const auto own = centers.size();
  const auto& kernels = GetBestQuadraticKernels();
  CorrectionLanes lanes;
  for (std::size_t first = 0; first < own; first += QuadraticLanes::Count)
  {
    const auto end = std::min(own, first + QuadraticLanes::Count);
    lanes.Neighbors = 0;
    for (std::size_t i = first; i < first + QuadraticLanes::Count; ++i)
    {
      const Vertex v = i < end ? centers[i] : 0;
      const Moments of = i < end ? moments[v] : Moments{};
      SetLane<Moments>(lanes, i - first, of, moments,
        i < end ? lists.Of(i) : std::span<const Vertex>(),
        [&](Vertex u)
        {
          double square = 0;
          for (unsigned k = 0; k < 3; ++k)
          {
            const double d = (places[u][k] - places[v][k]) * of.Scale;
            square += d * d;
          }
          return static_cast<float>(square);
        });
    }
    kernels.FindCorrections(lanes);
    for (std::size_t i = first; i < end; ++i)
    {
      const auto count = std::min(lists.Of(i).size(), NeighborLists::MaxCorrecting);
      for (std::size_t k = 0; k < count; ++k)
      {
        this->Corrections[this->Start[i] + k] = lanes.Weight[k][i - first];
      }
    }
  }
}

//------------------------------------------------------------------------------
QuadraticFit FitCells(
  std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners, Places points,
  bool withCorrections)
{
  // Means of the corners, added up in the order of their numbers, whatever their order in the cell.
  std::vector<std::array<double, 3>> places(starts.size() - 1);
  std::vector<std::uint32_t> own;
  for (std::size_t cell = 0; cell < places.size(); ++cell)
  {
    own.assign(corners.begin() + starts[cell], corners.begin() + starts[cell + 1]);
    std::sort(own.begin(), own.end());
    std::array<double, 3> sum{};
    for (const auto corner : own)
    {
      for (unsigned k = 0; k < 3; ++k)
      {
        sum[k] += points[corner][k];
      }
    }
    const auto count = static_cast<double>(own.size());
    places[cell] = { sum[0] / count, sum[1] / count, sum[2] / count };
  }
  return { NeighborLists::OfCells(starts, corners, places), places, withCorrections };
}
}
