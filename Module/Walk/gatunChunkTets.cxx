// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkTets.h"

#include "gatunCellSplitter.h"

namespace gatun
{
namespace
{
/** Calls use(cell, tetrahedron) for all of them. */
template <typename Use>
void EachTet(const ChunkMesh& mesh, Use&& use)
{
  const auto places = mesh.GetPlaces();
  const PointOrder<double> order(places.empty() ? nullptr : places.front().data());
  CellSplitter<Vertex, PointOrder<double>> splitter(order);
  const CellList& cells = mesh.Cells;
  for (std::uint32_t cell = 0; cell < cells.GetNumber(); ++cell)
  {
    splitter.Split(cells.Types[cell], cells.GetCorners(cell), cells.GetFaces(cell),
      [&](const std::array<Vertex, 4>& tet) { use(cell, tet); });
  }
}
}

//------------------------------------------------------------------------------
ChunkSize SplitCells(const ChunkMesh& mesh)
{
  ChunkSize result;
  EachTet(mesh,
    [&](std::uint32_t cell, const std::array<Vertex, 4>& tet)
    {
      result.Tets.push_back(tet);
      result.Cells.push_back(cell);
    });
  return result;
}

//------------------------------------------------------------------------------
std::size_t CountTets(const ChunkMesh& mesh)
{
  std::size_t count = 0;
  EachTet(mesh, [&](std::uint32_t, const std::array<Vertex, 4>&) { ++count; });
  return count;
}
}
