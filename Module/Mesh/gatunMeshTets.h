// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshTets_h
#define gatunMeshTets_h

#include "gatunCellSplitter.h"
#include "gatunMeshAccess.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Calls use(cell, corners) for each tetrahedron of a mesh, in the order of its cells. corners are
 * the ids of its four points. The cells must have been checked, and there must be less than 2^32
 * points.
 */
template <typename Use>
void ForEachTet(const MeshAccess& mesh, Use&& use)
{
  using Tet = std::array<std::uint32_t, 4>;
  const MeshInput& input = mesh.GetMesh();
  if (mesh.IsTetrahedral())
  {
    for (std::uint64_t cell = 0; cell < input.Cells; ++cell)
    {
      const auto id = [&](unsigned i)
      { return static_cast<std::uint32_t>(mesh.GetTetId(cell, i)); };
      use(cell, Tet{ id(0), id(1), id(2), id(3) });
    }
    return;
  }
  const auto splitAll = [&](const auto* coordinates)
  {
    using Order = PointOrder<std::remove_cv_t<std::remove_pointer_t<decltype(coordinates)>>>;
    CellSplitter<std::uint32_t, Order> splitter{ Order(coordinates) };
    std::vector<std::uint32_t> corners;
    for (std::uint64_t cell = 0; cell < input.Cells; ++cell)
    {
      corners.clear();
      for (auto i = mesh.GetBegin(cell); i < mesh.GetEnd(cell); ++i)
      {
        corners.push_back(static_cast<std::uint32_t>(mesh.GetId(i)));
      }
      splitter.Split(mesh.GetType(cell), std::span<const std::uint32_t>(corners),
        mesh.GetFaces(cell), [&](const Tet& tet) { use(cell, tet); });
    }
  };
  if (input.CoordinateType == ScalarType::Float32)
  {
    splitAll(static_cast<const float*>(input.Coordinates));
  }
  else
  {
    splitAll(static_cast<const double*>(input.Coordinates));
  }
}
}

#endif
