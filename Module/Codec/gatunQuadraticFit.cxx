// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunQuadraticFit.h"

#include "gatunQuadraticLanes.h"
#include "gatunTopology.h"

#include <algorithm>
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
 * cannot be, all are 0. Returns what they were multiplied by, or 0. */
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

double GetSquare(
  const std::array<double, 3>& place, const std::array<double, 3>& center, double scale)
{
  double sum = 0;
  for (unsigned k = 0; k < 3; ++k)
  {
    const double d = (place[k] - center[k]) * scale;
    sum += d * d;
  }
  return sum;
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

void QuadraticFit::FindWeights(const NeighborLists& lists, Places places,
  std::span<const Vertex> centers, std::span<const std::uint8_t> isShared, bool withCorrections)
{
  const auto own = centers.size();
  this->Start.reserve(own + 1);
  this->Start.push_back(0);
  for (std::size_t i = 0; i < own; ++i)
  {
    const auto count = static_cast<std::uint32_t>(lists.Of(i).size());
    this->Start.push_back(this->Start.back() + count);
  }
  this->List.reserve(this->Start.back());

  const auto& kernels = GetBestQuadraticKernels();
  std::vector<Moments> moments(withCorrections ? places.size() : 0);
  QuadraticLanes lanes;
  std::array<Neighbor, NeighborLists::MaxNeighbors> neighbors;
  for (std::size_t first = 0; first < own; first += QuadraticLanes::Count)
  {
    const auto end = std::min(own, first + QuadraticLanes::Count);
    lanes.Neighbors = 0;
    std::array<double, QuadraticLanes::Count> scales{};
    for (std::size_t i = first; i < first + QuadraticLanes::Count; ++i)
    {
      const auto lane = i - first;
      if (i >= end)
      {
        SetLane(lanes, lane, {}, {}, isShared, places);
        continue;
      }
      scales[lane] = SetLane(lanes, lane, places[centers[i]], lists.Of(i), isShared, places);
    }
    MomentLanes found;
    if (withCorrections)
    {
      std::memcpy(found.X, lanes.X, sizeof(found.X));
      std::memcpy(found.Y, lanes.Y, sizeof(found.Y));
      std::memcpy(found.Z, lanes.Z, sizeof(found.Z));
    }
    kernels.FindWeights(lanes);
    if (withCorrections)
    {
      kernels.FindMoments(lanes, found);
    }
    for (std::size_t i = first; i < end; ++i)
    {
      const auto list = lists.Of(i);
      const auto lane = i - first;
      for (std::size_t k = 0; k < list.size(); ++k)
      {
        neighbors[k] = { list[k], lanes.Quadratic[k][lane], lanes.Linear[k][lane],
          lanes.Share[k][lane] };
      }
      this->List.insert(this->List.end(), neighbors.begin(),
        neighbors.begin() + static_cast<std::ptrdiff_t>(list.size()));
      if (withCorrections && !list.empty())
      {
        auto& moment = moments[centers[i]];
        moment.Scale = scales[lane];
        for (std::size_t k = 0; k < moment.Values.size(); ++k)
        {
          moment.Values[k] = found.Moment[k][lane];
        }
      }
    }
  }
  if (withCorrections)
  {
    this->FindCorrections(places, centers, moments);
  }
}

void QuadraticFit::FindCorrections(
  Places places, std::span<const Vertex> centers, std::span<const Moments> moments)
{
  this->IsCorrected = true;
  this->Corrections.resize(this->List.size());
  const auto& kernels = GetBestQuadraticKernels();
  CorrectionLanes lanes;
  for (std::size_t first = 0; first < centers.size(); first += QuadraticLanes::Count)
  {
    const auto end = std::min(centers.size(), first + QuadraticLanes::Count);
    lanes = {}; // a neighbor without moments has weight 0
    for (std::size_t i = first; i < end; ++i)
    {
      const auto lane = i - first;
      const auto& own = moments[centers[i]];
      const auto nearest = this->GetCorrecting(i);
      lanes.Neighbors = std::max(lanes.Neighbors, nearest.size());
      for (std::size_t m = 0; m < own.Values.size(); ++m)
      {
        lanes.Own[m][lane] = own.Values[m];
      }
      for (std::size_t k = 0; k < nearest.size(); ++k)
      {
        const auto u = nearest[k].Id;
        const auto& other = moments[u];
        const auto ratio =
          own.Scale > 0 && other.Scale > 0 ? static_cast<float>(own.Scale / other.Scale) : 0;
        const float unit = ratio * ratio * ratio; // of third derivatives
        if (unit > 0 && unit <= 1e6f)
        {
          const double square = GetSquare(places[u], places[centers[i]], own.Scale);
          lanes.Nearness[k][lane] = 1 / (static_cast<float>(square) + 0.3f);
          for (std::size_t m = 0; m < other.Values.size(); ++m)
          {
            lanes.Moment[k][m][lane] = other.Values[m] * unit;
          }
        }
      }
    }
    kernels.FindCorrections(lanes);
    for (std::size_t i = first; i < end; ++i)
    {
      for (std::size_t k = 0; k < this->GetCorrecting(i).size(); ++k)
      {
        this->Corrections[this->Start[i] + k] = lanes.Weight[k][i - first];
      }
    }
  }
}

//------------------------------------------------------------------------------
QuadraticFit FitCells(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners,
  Places points, bool withCorrections)
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
