// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNeighborLists_h
#define gatunNeighborLists_h

#include "gatunFront.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
class NearestPicker;
struct Topology;

/**
 * For each center, the nearest places around it of which values are known before its own one. See
 * Documentation/format.md, 10.8.
 */
class NeighborLists
{
public:
  using Places = std::span<const std::array<double, 3>>;

  /** The length of a list. Centers deep in a mesh have full lists. */
  static constexpr std::size_t MaxNeighbors = 24;

  /** The length of a list of cells, which are more than vertices. */
  static constexpr std::size_t MaxCells = 16;

  /** The number of edges of a vertex that count. This bounds the time that a hostile mesh can take.
   */
  static constexpr std::size_t MaxEdges = 32;

  /** For each own vertex of a chunk: vertices at most two edges away that are shared, or were met
   * earlier. places: of all vertices in the order of the walk. */
  static NeighborLists OfWalk(const Topology& topology, Places places);

  /** For each cell: earlier cells with a common corner, the last 16 of each. Cells of more than 66
   * corners, which are polyhedra, have none. starts, corners: cell c has the corners
   * corners[starts[c]] to corners[starts[c + 1] - 1]. places: of the cells. */
  static NeighborLists OfCells(
    std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners, Places places);

  /** For each point of a block: earlier points around it. */
  static NeighborLists OfBlock(Places places);

  std::size_t GetCenters() const { return this->Start.size() - 1; }

  /** The number of neighbors in all lists, and in those before one. */
  std::size_t GetNeighbors() const { return this->Start.back(); }
  std::size_t GetStart(std::size_t center) const { return this->Start[center]; }

  std::size_t GetBytes() const
  {
    return this->Start.capacity() * sizeof(std::uint32_t) + this->List.capacity() * sizeof(Vertex);
  }

  /** Neighbors from the nearest one on. The number decides between equal distances. */
  std::span<const Vertex> Of(std::size_t center) const
  {
    return { this->List.data() + this->Start[center],
      this->Start[center + 1] - this->Start[center] };
  }

private:
  NeighborLists(std::size_t centers, std::size_t most);
  void Append(NearestPicker& candidates, Places places);

  std::vector<std::uint32_t> Start;
  std::vector<Vertex> List;
};
}

#endif
