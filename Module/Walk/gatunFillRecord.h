// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFillRecord_h
#define gatunFillRecord_h

#include "gatunCellGraph.h"
#include "gatunHexForm.h"
#include "gatunTopology.h"

#include <array>

namespace gatun
{
/**
 * Finds the known vertices around a corner of a cell. getVertex(local) returns the vertex of a
 * corner, or NoVertex if it is not known. Smaller numbers come first. B1 to B3 do not change.
 */
template <typename GetVertex>
std::array<CellGraph::Local, 3> FillRecord(
  CellRecord& record, const CellGraph& graph, std::size_t corner, GetVertex&& getVertex)
{
  std::array<CellGraph::Local, 3> near{ CellGraph::None, CellGraph::None, CellGraph::None };
  unsigned count = 0;
  for (const auto local : graph.GetNeighbors(corner))
  {
    const auto v = getVertex(local);
    if (v != NoVertex && count < near.size())
    {
      near[count] = local;
      record.Known[CellRecord::N1 + count] = v;
      ++count;
    }
  }
  for (const auto& quad : graph.GetQuads(corner))
  {
    // N1 and N2 have the slot after N3, N1 and N3 the next one.
    unsigned sum = 0;
    unsigned found = 0;
    for (unsigned i = 0; i < count; ++i)
    {
      const bool between = near[i] == quad.Before || near[i] == quad.After;
      sum += between ? i : 0;
      found += between;
    }
    if (found == 2)
    {
      record.Known[CellRecord::D12 + sum - 1] = getVertex(quad.Opposite);
    }
  }
  const auto opposite = graph.GetOpposite(corner);
  if (opposite != CellGraph::None)
  {
    record.Known[CellRecord::O] = getVertex(opposite);
  }
  return near;
}

/** The same for a corner of a hexahedron. */
template <typename GetVertex>
std::array<CellGraph::Local, 3> FillHexRecord(
  CellRecord& record, unsigned corner, GetVertex&& getVertex)
{
  const auto& around = HexForm::Around[corner];
  const auto& neighbors = HexForm::Neighbors[corner];
  std::array<CellGraph::Local, 3> near{ CellGraph::None, CellGraph::None, CellGraph::None };
  std::array<unsigned, 3> places{};
  unsigned count = 0;
  for (unsigned i = 0; i < 3; ++i)
  {
    const auto v = getVertex(neighbors[i]);
    if (v != NoVertex)
    {
      near[count] = neighbors[i];
      places[count] = i;
      record.Known[CellRecord::N1 + count] = v;
      ++count;
    }
  }
  for (unsigned b = 1; b < count; ++b)
  {
    for (unsigned a = 0; a < b; ++a)
    {
      record.Known[CellRecord::D12 + a + b - 1] =
        getVertex(around.Diagonals[places[a] + places[b] - 1]);
    }
  }
  record.Known[CellRecord::O] = getVertex(around.Opposite);
  return near;
}
}

#endif
