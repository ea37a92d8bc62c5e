// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunQuadraticFit.h"

#include "gatunQuadraticLanes.h"
#include "gatunTopology.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
using Places = NeighborLists::Places;

/** Sets a lane to the offsets of neighbors from the center. */
void SetLane(QuadraticLanes& lanes, std::size_t lane, const std::array<double, 3>& center,
  std::span<const Vertex> neighbors, std::span<const std::uint8_t> isShared, Places places)
{
  for (std::size_t i = 0; i < neighbors.size(); ++i)
  {
    const auto& place = places[neighbors[i]];
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      lanes.Offsets[axis][i][lane] = place[axis] - center[axis];
    }
    lanes.Share[i][lane] = isShared[neighbors[i]] != 0 ? 0 : 1; // no error is known there
  }
  for (std::size_t i = neighbors.size(); i < NeighborLists::MaxNeighbors; ++i)
  {
    for (auto& offsets : lanes.Offsets)
    {
      offsets[i][lane] = 0;
    }
    lanes.Share[i][lane] = 0;
  }
  const auto count = static_cast<float>(std::max<std::size_t>(neighbors.size(), 1));
  lanes.PerNeighbor[lane] = 3 / count;
  lanes.Equal[lane] = 1 / count;
  lanes.Size[lane] = static_cast<float>(neighbors.size());
  lanes.Neighbors = std::max(lanes.Neighbors, neighbors.size());
}
}

//------------------------------------------------------------------------------
QuadraticFit::QuadraticFit(const Topology& topology, Places places)
  : Lists(NeighborLists::OfWalk(topology, places))
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
  this->FindWeights(places, centers, isShared);
}

QuadraticFit::QuadraticFit(NeighborLists lists, Places places)
  : Lists(std::move(lists))
{
  std::vector<Vertex> centers(places.size());
  std::iota(centers.begin(), centers.end(), 0u);
  this->FindWeights(places, centers, std::vector<std::uint8_t>(places.size()));
}

void QuadraticFit::FindWeights(
  Places places, std::span<const Vertex> centers, std::span<const std::uint8_t> isShared)
{
  const auto own = centers.size();
  const auto all = this->Lists.GetNeighbors();
  for (auto* weights : { &this->Quadratic, &this->Linear, &this->Shares })
  {
    *weights = std::make_unique_for_overwrite<float[]>(all);
  }

  const auto findWeights = GetBestQuadraticWeights();
  QuadraticLanes lanes;
  std::size_t at = 0;
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
      SetLane(lanes, lane, places[centers[i]], this->Lists.Of(i), isShared, places);
    }
    findWeights(lanes);
    for (std::size_t i = first; i < end; ++i)
    {
      const auto lane = i - first;
      const auto count = this->Lists.Of(i).size();
      for (std::size_t k = 0; k < count; ++k, ++at)
      {
        this->Quadratic[at] = lanes.Quadratic[k][lane];
        this->Linear[at] = lanes.Linear[k][lane];
        this->Shares[at] = lanes.Share[k][lane];
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
