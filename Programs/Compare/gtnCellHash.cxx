// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnCellHash.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

namespace gtn
{
namespace
{

// The points of a tetrahedron: sorted, with the parity of the permutation. If two are equal, the
// parity says nothing.
Hash HashOfTet(std::span<const std::int64_t> ids, const std::vector<Hash>& points, const Hash& seed)
{
  std::array<Hash, 5> key{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    key[i] = points[static_cast<std::size_t>(ids[i])];
    for (std::size_t j = i; j > 0 && key[j] < key[j - 1]; --j)
    {
      std::swap(key[j], key[j - 1]);
      key[4].Low ^= 1;
    }
  }
  if (std::adjacent_find(key.begin(), key.begin() + 4) != key.begin() + 4)
  {
    key[4] = {};
  }
  return HashOf(key.data(), sizeof(key), seed);
}

// The points of a cell in their order.
Hash HashOfList(
  std::span<const std::int64_t> ids, const std::vector<Hash>& points, const Hash& seed)
{
  std::vector<Hash> key;
  for (const std::int64_t id : ids)
  {
    key.push_back(points[static_cast<std::size_t>(id)]);
  }
  return HashOf(key.data(), key.size() * sizeof(Hash), seed);
}

// A triangle, or a face of a polyhedron, whatever its first point is: as if it began with its least
// point.
Hash HashOfFace(
  std::span<const std::int64_t> ids, const std::vector<Hash>& points, const Hash& seed)
{
  const auto isLess = [&](std::int64_t a, std::int64_t b)
  { return points[static_cast<std::size_t>(a)] < points[static_cast<std::size_t>(b)]; };
  std::vector<Hash> all;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (!isLess(*std::min_element(ids.begin(), ids.end(), isLess), ids[i]))
    {
      std::vector<std::int64_t> turned(ids.begin(), ids.end());
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(i), turned.end());
      all.push_back(HashOfList(turned, points, seed));
    }
  }
  return all.empty() ? seed : *std::min_element(all.begin(), all.end());
}

// Points and faces of a polyhedron: in order or as sets.
Hash HashOfPolyhedron(const GridView& grid, std::size_t cell, const std::vector<Hash>& points,
  bool keepOrder, const Hash& seed)
{
  const auto ids = grid.GetIds(cell);
  const auto faces = grid.GetFaces(cell);
  std::vector<Hash> key;
  for (std::size_t at = 0; at < faces.size();)
  {
    const auto size = static_cast<std::size_t>(faces[at]);
    const auto face = faces.subspan(at + 1, size);
    const Hash begin{ size, 2 };
    key.push_back(keepOrder ? HashOfList(face, points, begin) : HashOfFace(face, points, begin));
    at += 1 + size;
  }
  const std::size_t count = key.size();
  for (const std::int64_t id : ids)
  {
    key.push_back(points[static_cast<std::size_t>(id)]);
  }
  if (!keepOrder)
  {
    std::sort(key.begin(), key.begin() + static_cast<std::ptrdiff_t>(count));
    std::sort(key.begin() + static_cast<std::ptrdiff_t>(count), key.end());
  }
  key.push_back({ count, ids.size() });
  return HashOf(key.data(), key.size() * sizeof(Hash), seed);
}

} // anonymous namespace

//------------------------------------------------------------------------------
Hash HashOfCell(const GridView& grid, std::size_t cell, const std::vector<Hash>& points,
  bool keepCorners, Hash seed)
{
  const int type = grid.GetType(cell);
  const auto ids = grid.GetIds(cell);
  seed.High += static_cast<std::uint64_t>(type) << 32;
  if (type == VTK_POLYHEDRON)
  {
    return HashOfPolyhedron(grid, cell, points, keepCorners, seed);
  }
  if (type == VTK_TRIANGLE && !keepCorners)
  {
    return HashOfFace(ids, points, seed);
  }
  return type == VTK_TETRA && !keepCorners && ids.size() == 4 ? HashOfTet(ids, points, seed)
                                                              : HashOfList(ids, points, seed);
}
}
