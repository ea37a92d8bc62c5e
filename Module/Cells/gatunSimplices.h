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
/** The faces of a cell, as cycles of point numbers, all counterclockwise or all clockwise if seen
 * from outside. */
template <typename Id>
class CellFaces
{
public:
  void Clear()
  {
    this->Ids.clear();
    this->Ends.clear();
    this->Shells.clear();
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

  /** Turns faces over so that each edge of two faces has opposite directions in them. Faces that
   * are connected by such edges have the same shell; the first one of each shell stays as it is. */
  void Align();

  std::size_t GetShell(std::size_t face) const
  {
    return this->Shells.empty() ? 0 : this->Shells[face];
  }

private:
  std::vector<Id> Ids;
  std::vector<std::size_t> Ends;
  std::vector<std::size_t> Shells; // of each face, or empty: there is one
};

template <typename Id>
void CellFaces<Id>::Align()
{
  // A side is an edge of a face. Two are twins if no other has the same two points.
  const std::size_t sides = this->Ids.size();
  std::vector<std::array<Id, 2>> ends;
  std::vector<std::size_t> faceOf;
  std::vector<std::size_t> sorted;
  for (std::size_t face = 0; face < this->GetNumber(); ++face)
  {
    const auto ids = this->Get(face);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      sorted.push_back(ends.size());
      ends.push_back({ ids[i], ids[(i + 1) % ids.size()] });
      faceOf.push_back(face);
    }
  }
  const auto keyOf = [&](std::size_t side) {
    return std::minmax({ ends[side][0], ends[side][1] });
  };
  std::sort(sorted.begin(), sorted.end(),
    [&](std::size_t a, std::size_t b) { return keyOf(a) < keyOf(b); });
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> twins(sides, none);
  for (std::size_t i = 0, next = 0; i < sides; i = next)
  {
    while (next < sides && keyOf(sorted[next]) == keyOf(sorted[i]))
    {
      ++next;
    }
    if (next == i + 2)
    {
      twins[sorted[i]] = sorted[i + 1];
      twins[sorted[i + 1]] = sorted[i];
    }
  }
  this->Shells.assign(this->GetNumber(), none);
  std::vector<bool> turned(this->GetNumber());
  std::vector<std::size_t> reached;
  std::size_t shells = 0;
  for (std::size_t start = 0; start < this->GetNumber(); ++start)
  {
    if (this->Shells[start] != none)
    {
      continue;
    }
    this->Shells[start] = shells;
    reached.assign(1, start);
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      const std::size_t face = reached[i];
      for (std::size_t side = face == 0 ? 0 : this->Ends[face - 1]; side < this->Ends[face]; ++side)
      {
        const std::size_t twin = twins[side];
        if (twin != none && this->Shells[faceOf[twin]] == none)
        {
          turned[faceOf[twin]] = turned[face] != (ends[twin][0] == ends[side][0]);
          this->Shells[faceOf[twin]] = shells;
          reached.push_back(faceOf[twin]);
        }
      }
    }
    ++shells;
  }
  for (std::size_t face = 0; face < this->GetNumber(); ++face)
  {
    if (turned[face])
    {
      const std::size_t begin = face == 0 ? 0 : this->Ends[face - 1];
      std::reverse(this->Ids.begin() + static_cast<std::ptrdiff_t>(begin),
        this->Ids.begin() + static_cast<std::ptrdiff_t>(this->Ends[face]));
    }
  }
}

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

/** Six times the volume of a tetrahedron; negative if its last three corners are clockwise, seen
 * from outside. NaN or 0 if coordinates are too large or not finite. */
template <typename Id, typename Order>
double GetSixfoldVolume(const std::array<Id, 4>& tet, const Order& order)
{
  const auto apex = order.GetPlace(tet[0]);
  std::array<std::array<double, 3>, 3> e{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto place = order.GetPlace(tet[i + 1]);
    e[i] = { place[0] - apex[0], place[1] - apex[1], place[2] - apex[2] };
  }
  const double x = e[1][1] * e[2][2] - e[1][2] * e[2][1];
  const double y = e[1][2] * e[2][0] - e[1][0] * e[2][2];
  const double z = e[1][0] * e[2][1] - e[1][1] * e[2][0];
  return e[0][0] * x + e[0][1] * y + e[0][2] * z;
}

/** Calls use with the face and the corners of each tetrahedron of a cell, as its faces are
 * directed. */
template <typename Id, typename Order, typename Use>
void DivideCell(const CellFaces<Id>& faces, const Order& order, Use&& use)
{
  const auto ids = faces.GetIds();
  if (ids.empty())
  {
    return;
  }
  const Id apex = *std::min_element(ids.begin(), ids.end(), order);
  for (std::size_t i = 0; i < faces.GetNumber(); ++i)
  {
    const auto face = faces.Get(i);
    if (std::find(face.begin(), face.end(), apex) != face.end())
    {
      continue;
    }
    const auto least =
      static_cast<std::size_t>(std::min_element(face.begin(), face.end(), order) - face.begin());
    const auto at = [&](std::size_t corner) { return face[(least + corner) % face.size()]; };
    for (std::size_t corner = 1; corner + 1 < face.size(); ++corner)
    {
      const std::array<Id, 4> tet{ apex, at(0), at(corner), at(corner + 1) };
      if (tet[1] != tet[2] && tet[1] != tet[3] && tet[2] != tet[3])
      {
        use(i, tet);
      }
    }
  }
}

/** What SplitCell needs beside the cell; kept from cell to cell. */
template <typename Id>
struct SplitSpace
{
  std::vector<std::array<Id, 4>> Tets;
  std::vector<std::size_t> Shells; // of each tetrahedron
  std::vector<double> Volumes;     // of each shell
};

/**
 * Calls use with the corners of each tetrahedron of a cell. Faces are divided by the diagonals from
 * their least corner, and the cell by the planes through its least corner; of corners at the same
 * place, the first one counts. The volume of all tetrahedra of a shell together is positive,
 * however the faces are directed. Tetrahedra with a corner twice, as in degenerate cells, are left
 * out.
 *
 * order: of points, such as PointOrder.
 */
template <typename Id, typename Order, typename Use>
void SplitCell(const CellFaces<Id>& faces, const Order& order, SplitSpace<Id>& space, Use&& use)
{
  space.Tets.clear();
  space.Shells.clear();
  space.Volumes.clear();
  DivideCell(faces, order,
    [&](std::size_t face, const std::array<Id, 4>& tet)
    {
      const std::size_t shell = faces.GetShell(face);
      space.Tets.push_back(tet);
      space.Shells.push_back(shell);
      space.Volumes.resize(std::max(space.Volumes.size(), shell + 1));
      space.Volumes[shell] += GetSixfoldVolume(tet, order);
    });
  for (std::size_t i = 0; i < space.Tets.size(); ++i)
  {
    auto& tet = space.Tets[i];
    if (space.Volumes[space.Shells[i]] < 0)
    {
      std::swap(tet[2], tet[3]);
    }
    use(tet);
  }
}
}

#endif
