// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBoundaryFaces.h"

#include "gatunCellShapes.h"
#include "gatunCellSides.h"
#include "gatunEncoderMarks.h"
#include "gatunVertexHash.h"

#include <algorithm>
#include <tuple>

namespace gatun
{
namespace
{
/** Sorts faces and leaves as many of each kind of equal ones as count(first, number) says. */
template <typename Count>
void SelectFaces(std::vector<BoundaryFace>& faces, Count&& count)
{
  const auto keyOf = [](const BoundaryFace& face)
  { return std::tie(face.Least, face.Rest, face.Size, face.Cell, face.Number); };
  std::sort(
    faces.begin(), faces.end(), [&](const auto& a, const auto& b) { return keyOf(a) < keyOf(b); });
  std::size_t kept = 0;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end)
  {
    while (end < faces.size() && faces[end].IsSame(faces[begin]))
    {
      ++end;
    }
    const std::size_t wanted = count(faces[begin], end - begin);
    for (std::size_t i = 0; i < wanted; ++i)
    {
      faces[kept++] = faces[begin + i];
    }
  }
  faces.resize(kept);
}
}

//------------------------------------------------------------------------------
std::vector<BoundaryFace> FindOpenFaces(const MeshAccess& mesh,
  std::span<const std::uint32_t> cells, const std::function<std::uint32_t(std::uint32_t)>& numberOf,
  const std::function<bool(std::uint32_t)>& isShared)
{
  constexpr std::size_t fewest = 3;
  CellSides sides(mesh);
  std::vector<BoundaryFace> faces;
  std::vector<std::uint32_t> sorted;
  for (const auto cell : cells)
  {
    if (GetCellKind(mesh.GetType(cell)).Dimension != 3)
    {
      continue;
    }
    sides.ForEachSide(cell,
      [&](std::uint16_t number, std::span<const std::uint32_t> corners)
      {
        sorted.clear();
        for (const auto corner : corners)
        {
          sorted.push_back(numberOf(corner));
        }
        std::sort(sorted.begin(), sorted.end());
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        if (sorted.size() < fewest)
        {
          return;
        }
        auto& face = faces.emplace_back();
        std::copy_n(sorted.begin(), fewest, face.Least.begin());
        const auto rest = std::span<const std::uint32_t>(sorted).subspan(fewest);
        face.Rest = rest.size() == 1
          ? rest[0]
          : static_cast<std::uint32_t>(rest.empty() ? 0 : HashVertices(rest));
        face.Size = static_cast<std::uint16_t>(sorted.size());
        face.Number = number;
        face.Cell = cell;
        face.IsShared = std::all_of(corners.begin(), corners.end(), isShared);
      });
  }
  KeepOpenFaces(faces);
  return { faces.begin(), faces.end() }; // without the room for the others
}

//------------------------------------------------------------------------------
void KeepOpenFaces(std::vector<BoundaryFace>& faces)
{
  // Of a face that is there several times, two are enough to tell that.
  SelectFaces(faces,
    [](const BoundaryFace& face, std::size_t number) -> std::size_t {
      return number == 1 ? 1 : face.IsShared ? 2 : 0;
    });
}

//------------------------------------------------------------------------------
void KeepSingleFaces(std::vector<BoundaryFace>& faces)
{
  SelectFaces(faces,
    [](const BoundaryFace&, std::size_t number) -> std::size_t { return number == 1 ? 1 : 0; });
}

//------------------------------------------------------------------------------
void FindCorners(
  const MeshAccess& mesh, const BoundaryFace& face, std::vector<std::uint32_t>& corners)
{
  CellSides(mesh).ForEachSide(face.Cell,
    [&](std::uint16_t number, std::span<const std::uint32_t> points)
    {
      if (number == face.Number)
      {
        corners.assign(points.begin(), points.end());
      }
    });
}

//------------------------------------------------------------------------------
std::optional<SurfaceList> FindSurfaceCell(
  const MeshAccess& mesh, std::uint64_t cell, std::vector<std::uint32_t>& corners)
{
  constexpr std::uint8_t polyline = 4;
  constexpr std::uint8_t polygon = 7;
  const auto type = mesh.GetType(cell);
  const int dimension = GetCellKind(type).Dimension;
  const auto first = mesh.GetBegin(cell);
  const auto size = static_cast<std::size_t>(mesh.GetEnd(cell) - first);
  const auto take = [&](std::size_t points, auto&& placeOf)
  {
    corners.clear();
    for (unsigned i = 0; i < points; ++i)
    {
      corners.push_back(static_cast<std::uint32_t>(mesh.GetId(first + placeOf(i))));
    }
  };
  const auto same = [](unsigned i) { return i; };
  if (type != 0 && (dimension == 0 || (dimension == 1 && size >= 2)))
  {
    // A curve is the line between its ends, which come first.
    take(dimension == 0 || type == polyline ? size : 2, same);
    return dimension == 0 ? SurfaceList::Vertices : SurfaceList::Lines;
  }
  if (dimension != 2)
  {
    return {};
  }
  if (GetSurfaceList(type) == SurfaceList::Strips)
  {
    take(size, same);
    return SurfaceList::Strips;
  }
  const auto degree = CountMarkCorners(type, static_cast<unsigned>(size));
  if ((type != polygon && degree == 0) || !HasAllNodes(type, degree, size))
  {
    return {};
  }
  take(degree, [type](unsigned i) { return GetMarkCorner(type, i); });
  return SurfaceList::Polygons;
}
}
