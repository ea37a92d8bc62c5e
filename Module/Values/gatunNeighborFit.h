// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNeighborFit_h
#define gatunNeighborFit_h

#include "gatunFront.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
struct Topology;

/** The neighbors of each own vertex of a chunk that are known before it, and their weights. */
class NeighborFit
{
public:
  struct Neighbor
  {
    Vertex Id;
    double Weight;
  };

  /** places: coordinates of all vertices of the topology in the order of the walk. */
  NeighborFit(const Topology& topology, std::span<const std::array<double, 3>> places);

  std::span<const Neighbor> Of(std::size_t ownVertex) const
  {
    return { this->List.data() + this->Start[ownVertex],
      this->Start[ownVertex + 1] - this->Start[ownVertex] };
  }

  /** The memory of the lists. */
  std::size_t GetBytes() const
  {
    return this->Start.capacity() * sizeof(std::uint32_t) +
      this->List.capacity() * sizeof(Neighbor);
  }

private:
  std::vector<std::uint32_t> Start;
  std::vector<Neighbor> List;
};
}

#endif
