// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunNeighborLists.h"

#include "gatunNearestPicker.h"
#include "gatunTopology.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace gatun
{
namespace
{
/** The known vertices at the edges of each vertex, which become more along the walk. */
class KnownEdges
{
public:
  explicit KnownEdges(const Topology& topology)
    : Start(topology.Sources.size() + 1, 0)
    , End(topology.Sources.size())
  {
    for (const auto& edge : topology.EdgeLog)
    {
      ++this->Start[edge[0] + 1];
      ++this->Start[edge[1] + 1];
    }
    for (std::size_t v = 0; v < this->End.size(); ++v)
    {
      this->Start[v + 1] += this->Start[v];
      this->End[v] = this->Start[v];
    }
    this->Far.resize(this->Start.back());
    for (const auto& edge : topology.EdgeLog)
    {
      const Vertex low = std::min(edge[0], edge[1]);
      const Vertex high = std::max(edge[0], edge[1]);
      const bool isHighShared = topology.IsShared(high);
      if (!isHighShared)
      {
        this->Append(high, low);
      }
      else
      {
        this->Append(low, high);
        if (topology.IsShared(low))
        {
          this->Append(high, low);
        }
      }
    }
  }

  /** Makes an own vertex known to its neighbors. */
  void Publish(Vertex v)
  {
    const auto end = this->End[v];
    for (auto i = this->Start[v]; i < end; ++i)
    {
      this->Append(this->Far[i], v);
    }
  }

  /** The last vertices of a list. */
  std::span<const Vertex> GetLast(Vertex v) const
  {
    const std::size_t count = this->End[v] - this->Start[v];
    const auto used = std::min(count, NeighborLists::MaxEdges);
    return { this->Far.data() + this->End[v] - used, used };
  }

private:
  void Append(Vertex to, Vertex v) { this->Far[this->End[to]++] = v; }

  std::vector<std::uint32_t> Start;
  std::vector<std::uint32_t> End;
  std::vector<Vertex> Far;
};
}

//------------------------------------------------------------------------------
static_assert(NeighborLists::MaxNeighbors <= NearestPicker::MaxTaken);
static_assert(
  NeighborLists::MaxEdges * (NeighborLists::MaxEdges + 1) <= NearestPicker::MaxCandidates);

NeighborLists::NeighborLists(std::size_t centers, std::size_t most)
{
  this->Start.reserve(centers + 1);
  this->Start.push_back(0);
  this->List.resize(centers * most);
}

void NeighborLists::Append(NearestPicker& candidates, Places places)
{
  const auto end = this->Start.back();
  this->Start.push_back(
    end + static_cast<std::uint32_t>(candidates.TakeNearest(places, this->List.data() + end)));
}

NeighborLists NeighborLists::OfWalk(const Topology& topology, Places places)
{
  KnownEdges edges(topology);
  NeighborLists lists(topology.GetOwnVertices(), MaxNeighbors);
  NearestPicker candidates(places.size(), MaxNeighbors);
  for (Vertex v = 0; v < places.size(); ++v)
  {
    if (topology.IsShared(v))
    {
      continue;
    }
    candidates.Begin(v);
    const auto ring = edges.GetLast(v);
    for (const Vertex u : ring)
    {
      candidates.Add(u);
    }
    for (const Vertex u : ring)
    {
      for (const Vertex w : edges.GetLast(u))
      {
        candidates.Add(w);
      }
    }
    lists.Append(candidates, places);
    edges.Publish(v);
  }
  return lists;
}
}
