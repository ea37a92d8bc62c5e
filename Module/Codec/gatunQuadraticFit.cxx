// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunQuadraticFit.h"

#include "gatunQuadraticLanes.h"
#include "gatunTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gatun
{
namespace
{
using Places = NeighborLists::Places;

/** Sets a lane to the offsets of neighbors from the center, of which the mean square is 1. If that
 * cannot be, all are 0. */
void SetLane(QuadraticLanes& lanes, std::size_t lane, const std::array<double, 3>& center,
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
}
}

//------------------------------------------------------------------------------
QuadraticFit::QuadraticFit(const Topology& topology, Places places)
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
  this->FindWeights(NeighborLists::OfWalk(topology, places), places, centers, isShared);
}

QuadraticFit::QuadraticFit(const NeighborLists& lists, Places places)
{
  std::vector<Vertex> centers(places.size());
  std::iota(centers.begin(), centers.end(), 0u);
  this->FindWeights(lists, places, centers, std::vector<std::uint8_t>(places.size()));
}

void QuadraticFit::FindWeights(const NeighborLists& lists, Places places,
  std::span<const Vertex> centers, std::span<const std::uint8_t> isShared)
{
  const auto own = centers.size();
  this->Start.reserve(own + 1);
  this->Start.push_back(0);
  for (std::size_t i = 0; i < own; ++i)
  {
    const auto count = static_cast<std::uint32_t>(lists.Of(i).size());
    this->Start.push_back(this->Start.back() + count);
  }
  this->Ids.reserve(this->Start.back());
  for (auto* weights : { &this->Quadratic, &this->Linear, &this->Shares })
  {
    weights->reserve(this->Start.back());
  }

  const auto findWeights = GetBestQuadraticWeights();
  QuadraticLanes lanes;
  for (std::size_t first = 0; first < own; first += QuadraticLanes::Count)
  {
    const auto end = std::min(own, first + QuadraticLanes::Count);
    lanes.Neighbors = 0;
    for (std::size_t i = first; i < first + QuadraticLanes::Count; ++i)
    {
      const auto lane = i - first;
      if (i >= end)
      {
        SetLane(lanes, lane, {}, {}, isShared, places);
        continue;
      }
      SetLane(lanes, lane, places[centers[i]], lists.Of(i), isShared, places);
    }
    findWeights(lanes);
    for (std::size_t i = first; i < end; ++i)
    {
      const auto list = lists.Of(i);
      const auto lane = i - first;
      this->Ids.insert(this->Ids.end(), list.begin(), list.end());
      for (std::size_t k = 0; k < list.size(); ++k)
      {
        this->Quadratic.push_back(lanes.Quadratic[k][lane]);
        this->Linear.push_back(lanes.Linear[k][lane]);
        this->Shares.push_back(lanes.Share[k][lane]);
      }
    }
  }
}

//------------------------------------------------------------------------------
QuadraticFit FitCells(
  std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners, Places points)
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
  return { NeighborLists::OfCells(starts, corners, places), places };
}
}
