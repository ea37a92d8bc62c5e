// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellGraph_h
#define gatunCellGraph_h

#include "gatunExport.h" // For export macro

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/**
 * The edges of a cell and the corners of its quadrilaterals, in local numbers, for predictions of a
 * corner from others.
 */
class CellGraph
{
public:
  using Local = std::uint16_t;
  static constexpr Local None = 0xffff;

  /** A quadrilateral with a corner between two others and opposite to a third one. */
  struct Quad
  {
    Local Before, Opposite, After;
  };

  CellGraph() = default;

  /** The graph of a surface. faces: for each one the number of corners, then the corners. */
  GATUN_EXPORT CellGraph(std::size_t corners, std::span<const Local> faces);

  /** The graph of a VTK cell type with any number of points. */
  GATUN_EXPORT static CellGraph OfType(int type, std::size_t points);

  std::size_t GetCorners() const { return this->NeighborStarts.size() - 1; }

  /** Each edge once, smaller number first, ascending. */
  std::span<const std::array<Local, 2>> GetEdges() const { return this->Edges; }

  /** The other ends of a corner's edges, ascending. */
  std::span<const Local> GetNeighbors(std::size_t corner) const
  {
    return std::span(this->Neighbors)
      .subspan(this->NeighborStarts[corner],
        this->NeighborStarts[corner + 1] - this->NeighborStarts[corner]);
  }

  std::span<const Quad> GetQuads(std::size_t corner) const
  {
    return std::span(this->Quads)
      .subspan(this->QuadStarts[corner], this->QuadStarts[corner + 1] - this->QuadStarts[corner]);
  }

  /** The far end of the diagonal through a hexahedron, None if the corner is none of one. */
  Local GetOpposite(std::size_t corner) const { return this->Opposites[corner]; }

private:
  Local FindOpposite(std::size_t corner) const;
  void Finish(std::size_t corners, std::vector<std::pair<Local, Quad>> quads);

  std::vector<std::array<Local, 2>> Edges;
  std::vector<std::uint32_t> NeighborStarts{ 0 };
  std::vector<Local> Neighbors;
  std::vector<std::uint32_t> QuadStarts{ 0 };
  std::vector<Quad> Quads;
  std::vector<Local> Opposites;
};
}

#endif
