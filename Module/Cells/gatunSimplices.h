// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSimplices_h
#define gatunSimplices_h

// The tetrahedra of a cell, by a rule that depends on nothing but the places of its corners. Cells
// with a common face split it alike, wherever they are: in another chunk, piece or file, among
// ghost cells, or in memory.

#include "gatunCellShapes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace gatun
{
/** The faces of a cell, as cycles of point numbers, counterclockwise if seen from outside. */
template <typename Id>
class CellFaces
{
public:
  void Clear()
  {
    this->Ids.clear();
    this->Ends.clear();
  }

  /** Adds a face with a value for each of its corners. */
  template <typename Corners, typename GetId>
  void Add(const Corners& corners, GetId&& getId)
  {
    for (const auto corner : corners)
    {
      this->Ids.push_back(getId(corner));
    }
    this->Ends.push_back(this->Ids.size());
  }

  /** Replaces the faces by those of a shape. */
  void Set(const CellShape& shape, const Id* corners)
  {
    this->Clear();
    for (std::size_t at = 0; at < shape.Faces.size(); at += 1u + shape.Faces[at])
    {
      this->Add(shape.Faces.subspan(at + 1, shape.Faces[at]),
        [corners](std::uint8_t corner) { return corners[corner]; });
    }
  }

  std::size_t GetNumber() const { return this->Ends.size(); }

  std::span<const Id> Get(std::size_t face) const
  {
    const std::size_t begin = face == 0 ? 0 : this->Ends[face - 1];
    return { this->Ids.data() + begin, this->Ends[face] - begin };
  }

  std::span<const Id> GetIds() const { return this->Ids; }

private:
  std::vector<Id> Ids;
  std::vector<std::size_t> Ends;
};

/** The order of points by their coordinates: by x, then y, then z. It is total: -0 is before 0, and
 * NaN is beyond infinity. */
template <typename T>
class PointOrder
{
public:
  /** coordinates: three for each point. */
  explicit PointOrder(const T* coordinates)
    : Coordinates(coordinates)
  {
  }

  template <typename Id>
  bool operator()(Id a, Id b) const
  {
    const T* const one = this->Coordinates + 3 * static_cast<std::size_t>(a);
    const T* const other = this->Coordinates + 3 * static_cast<std::size_t>(b);
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const Key l = GetKey(one[axis]);
      const Key r = GetKey(other[axis]);
      if (l != r)
      {
        return l < r;
      }
    }
    return false;
  }

  template <typename Id>
  std::array<double, 3> GetPlace(Id point) const
  {
    const T* const place = this->Coordinates + 3 * static_cast<std::size_t>(point);
    return { place[0], place[1], place[2] };
  }

private:
  using Key = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

  /** An integer with the order of the values. */
  static Key GetKey(T value)
  {
    const auto bits = std::bit_cast<Key>(value);
    constexpr Key most = std::numeric_limits<Key>::max();
    return bits < 0 ? bits ^ most : bits;
  }

  const T* Coordinates;
};

/**
 * Calls use with the corners of each tetrahedron of a cell. Faces are divided by the diagonals from
 * their least corner, and the cell by the planes through its least corner; of corners at the same
 * place, the first one counts. Tetrahedra are oriented as the cell is. Tetrahedra with a corner
 * twice, as in degenerate cells, are left out.
 *
 * isLess: the order of points, such as PointOrder.
 */
template <typename Id, typename IsLess, typename Use>
void SplitCell(const CellFaces<Id>& faces, IsLess&& isLess, Use&& use)
{
  const auto ids = faces.GetIds();
  if (ids.empty())
  {
    return;
  }
  const Id apex = *std::min_element(ids.begin(), ids.end(), isLess);
  for (std::size_t i = 0; i < faces.GetNumber(); ++i)
  {
    const auto face = faces.Get(i);
    if (std::find(face.begin(), face.end(), apex) != face.end())
    {
      continue;
    }
    const auto least =
      static_cast<std::size_t>(std::min_element(face.begin(), face.end(), isLess) - face.begin());
    const auto at = [&](std::size_t corner) { return face[(least + corner) % face.size()]; };
    for (std::size_t corner = 1; corner + 1 < face.size(); ++corner)
    {
      const std::array<Id, 4> tet{ apex, at(0), at(corner), at(corner + 1) };
      if (tet[1] != tet[2] && tet[1] != tet[3] && tet[2] != tet[3])
      {
        use(tet);
      }
    }
  }
}
}

#endif
