// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFindCells.h"

#include "gatunMeshAccess.h"

#include <algorithm>
#include <cstring>

namespace gatun
{
namespace
{
/** Whether two cells have the same type and the same points. placeOf: the point of the mesh for
 * each one of the part; empty if they have the same numbers. */
bool IsSame(const MeshAccess& mesh, std::uint64_t cell, const MeshAccess& part, std::uint64_t other,
  const std::vector<std::uint64_t>& placeOf)
{
  const auto begin = mesh.GetBegin(cell);
  const auto otherBegin = part.GetBegin(other);
  const auto size = mesh.GetEnd(cell) - begin;
  if (mesh.GetType(cell) != part.GetType(other) || part.GetEnd(other) - otherBegin != size)
  {
    return false;
  }
  for (std::uint64_t i = 0; i < size; ++i)
  {
    const auto id = part.GetId(otherBegin + i);
    const auto count = part.GetMesh().Points;
    if (id >= count ||
      mesh.GetId(begin + i) != (placeOf.empty() ? id : placeOf[static_cast<std::size_t>(id)]))
    {
      return false;
    }
  }
  return true;
}

/** The points of the mesh at the places of those of the part, which come in the same order. */
std::optional<std::vector<std::uint64_t>> FindPoints(const MeshInput& mesh, const MeshInput& part)
{
  const auto size = 3 * SizeOf(mesh.CoordinateType);
  const auto* at = static_cast<const std::uint8_t*>(mesh.Coordinates);
  const auto* of = static_cast<const std::uint8_t*>(part.Coordinates);
  std::vector<std::uint64_t> found;
  found.reserve(static_cast<std::size_t>(part.Points));
  for (std::uint64_t p = 0; p < mesh.Points && found.size() < part.Points; ++p)
  {
    if (std::memcmp(at + p * size, of + found.size() * size, size) == 0)
    {
      found.push_back(p);
    }
  }
  return found.size() == part.Points ? std::optional(std::move(found)) : std::nullopt;
}

/** Whether cells use all points. */
bool UsesAllPoints(const MeshAccess& mesh)
{
  std::vector<bool> isUsed(static_cast<std::size_t>(mesh.GetMesh().Points), false);
  for (std::uint64_t cell = 0; cell < mesh.GetMesh().Cells; ++cell)
  {
    mesh.ForEachPoint(
      cell, [&](std::uint64_t point) { isUsed[static_cast<std::size_t>(point)] = true; });
  }
  return std::find(isUsed.begin(), isUsed.end(), false) == isUsed.end();
}
}

//------------------------------------------------------------------------------
std::optional<FoundCells> FindCells(const MeshInput& mesh, const MeshInput& part)
{
  const bool mayBe = part.Cells < mesh.Cells && part.Cells >= mesh.Cells - part.Cells &&
    part.Points <= mesh.Points && part.Points > 0 && part.CoordinateType == mesh.CoordinateType &&
    part.WideIds == mesh.WideIds;
  if (!mayBe ||
    (part.Types &&
      std::find(part.Types, part.Types + part.Cells, PolyhedronType) != part.Types + part.Cells))
  {
    return {};
  }
  FoundCells found;
  found.DropsPoints = part.Points < mesh.Points;
  if (found.DropsPoints)
  {
    auto points = FindPoints(mesh, part);
    if (!points)
    {
      return {};
    }
    found.Points = std::move(*points);
  }
  const MeshAccess all(mesh);
  const MeshAccess some(part);
  std::uint64_t cell = 0;
  for (std::uint64_t other = 0; other < part.Cells; ++other)
  {
    while (cell < mesh.Cells && !IsSame(all, cell, some, other, found.Points))
    {
      ++cell;
    }
    if (cell == mesh.Cells)
    {
      return {};
    }
    found.Cells.push_back(cell++);
  }
  if (found.DropsPoints && !UsesAllPoints(some))
  {
    return {};
  }
  found.HaveMoved = !found.DropsPoints &&
    std::memcmp(mesh.Coordinates, part.Coordinates,
      static_cast<std::size_t>(3 * SizeOf(mesh.CoordinateType) * mesh.Points)) != 0;
  return found;
}
}
