// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTurnedCells.h"

#include "gatunCellShapes.h"
#include "gatunOrientation.h"
#include "gatunParallel.h"

#include <algorithm>
#include <span>

namespace gatun
{
namespace
{
constexpr std::size_t TetsPerTask = 1 << 14;

using Corners = std::array<std::uint8_t, 4>; // a corner of a cell and its three neighbors

constexpr std::array<Corners, 1> Tetrahedron{ { { 0, 1, 2, 3 } } };
constexpr std::array<Corners, 8> Hexahedron{ { { 0, 1, 3, 4 }, { 1, 2, 0, 5 }, { 2, 3, 1, 6 },
  { 3, 0, 2, 7 }, { 4, 7, 5, 0 }, { 5, 4, 6, 1 }, { 6, 5, 7, 2 }, { 7, 6, 4, 3 } } };
constexpr std::array<Corners, 8> Voxel{ { { 0, 1, 2, 4 }, { 1, 3, 0, 5 }, { 3, 2, 1, 7 },
  { 2, 0, 3, 6 }, { 4, 6, 5, 0 }, { 5, 4, 7, 1 }, { 7, 5, 6, 3 }, { 6, 7, 4, 2 } } };
constexpr std::array<Corners, 6> Wedge{ { { 0, 1, 2, 3 }, { 1, 2, 0, 4 }, { 2, 0, 1, 5 },
  { 3, 5, 4, 0 }, { 4, 3, 5, 1 }, { 5, 4, 3, 2 } } };
constexpr std::array<Corners, 4> Pyramid{ { { 0, 1, 3, 4 }, { 1, 2, 0, 4 }, { 2, 3, 1, 4 },
  { 3, 0, 2, 4 } } };

/** type: in vtkCellType.h. */
std::span<const Corners> GetCorners(int type)
{
  switch (type)
  {
    case TetraType:
    case 24: // VTK_QUADRATIC_TETRA
    case 71: // VTK_LAGRANGE_TETRAHEDRON
      return Tetrahedron;
    case 12: // VTK_HEXAHEDRON
    case 25: // VTK_QUADRATIC_HEXAHEDRON
    case 33: // VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON
    case 29: // VTK_TRIQUADRATIC_HEXAHEDRON
    case 72: // VTK_LAGRANGE_HEXAHEDRON
      return Hexahedron;
    case 11: // VTK_VOXEL
      return Voxel;
    case 13: // VTK_WEDGE
    case 26: // VTK_QUADRATIC_WEDGE
    case 31: // VTK_QUADRATIC_LINEAR_WEDGE
    case 32: // VTK_BIQUADRATIC_QUADRATIC_WEDGE
    case 73: // VTK_LAGRANGE_WEDGE
      return Wedge;
    case 14: // VTK_PYRAMID
    case 27: // VTK_QUADRATIC_PYRAMID
      return Pyramid;
    default:
      return {};
  }
}

int GetSign(const std::array<std::uint32_t, 4>& tet, const CornerTets::PlaceOf& placeOf)
{
  return GetOrientation(placeOf(tet[0]), placeOf(tet[1]), placeOf(tet[2]), placeOf(tet[3]));
}
}

//------------------------------------------------------------------------------
CornerTets::CornerTets(const MeshAccess& mesh, const PlaceOf& placeOf)
{
  for (std::uint64_t cell = 0; cell < mesh.GetMesh().Cells; ++cell)
  {
    const auto begin = mesh.GetBegin(cell);
    const auto id = [&](std::uint8_t i)
    { return static_cast<std::uint32_t>(mesh.GetId(begin + i)); };
    for (const Corners& of : GetCorners(mesh.GetType(cell)))
    {
      this->Tets.push_back({ id(of[0]), id(of[1]), id(of[2]), id(of[3]) });
    }
  }
  this->Signs.resize(this->Tets.size());
  ParallelFor(this->Tets.size() / TetsPerTask + 1,
    [&](std::size_t task)
    {
      const auto end = std::min(this->Tets.size(), (task + 1) * TetsPerTask);
      for (std::size_t i = task * TetsPerTask; i < end; ++i)
      {
        this->Signs[i] = static_cast<std::int8_t>(GetSign(this->Tets[i], placeOf));
      }
    });
}

//------------------------------------------------------------------------------
std::size_t CornerTets::MarkTurned(const PlaceOf& placeOf, std::vector<std::uint8_t>& marks) const
{
  std::vector<std::vector<std::size_t>> turned(this->Tets.size() / TetsPerTask + 1);
  ParallelFor(turned.size(),
    [&](std::size_t task)
    {
      const auto end = std::min(this->Tets.size(), (task + 1) * TetsPerTask);
      for (std::size_t i = task * TetsPerTask; i < end; ++i)
      {
        if (GetSign(this->Tets[i], placeOf) != this->Signs[i])
        {
          turned[task].push_back(i);
        }
      }
    });
  std::size_t count = 0;
  std::vector<bool> isMarked(marks.size());
  for (const auto& list : turned)
  {
    count += list.size();
    for (const auto i : list)
    {
      for (const auto p : this->Tets[i])
      {
        marks[p] = static_cast<std::uint8_t>(marks[p] + (isMarked[p] ? 0 : 1));
        isMarked[p] = true;
      }
    }
  }
  return count;
}
}
