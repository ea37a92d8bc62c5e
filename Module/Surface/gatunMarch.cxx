// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMarch.h"

#include "gatunError.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gatun
{
namespace
{
// The six edges of a tetrahedron, and the edges of the triangles for each set of inside corners
// (bit i for corner i). These are the cases of vtkTetra, so that the triangles are the same.
constexpr std::uint8_t Edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
constexpr std::uint8_t Cases[16][6] = { {}, { 3, 0, 2 }, { 1, 0, 4 }, { 2, 3, 4, 2, 4, 1 },
  { 2, 1, 5 }, { 5, 3, 1, 1, 3, 0 }, { 2, 0, 5, 5, 0, 4 }, { 5, 3, 4 }, { 4, 3, 5 },
  { 4, 0, 5, 5, 0, 2 }, { 5, 0, 3, 1, 0, 5 }, { 2, 5, 1 }, { 4, 3, 1, 1, 3, 2 }, { 4, 0, 1 },
  { 2, 0, 3 }, {} };

/** The number of triangles of a case: two if two corners are inside. */
constexpr std::uint8_t TriangleCounts[16] = { 0, 1, 1, 2, 1, 2, 2, 1, 1, 2, 2, 1, 2, 1, 1, 0 };

/** Finds points by their edge and isovalue. */
class EdgeTable
{
public:
  /** Grows if there are more points than expected. With one isovalue its number is 0. */
  EdgeTable(std::vector<Crossing>& points, std::size_t expected, bool oneValue)
    : Points(points)
    , OneValue(oneValue)
    , Slots(std::bit_ceil(2 * expected + 1), None)
  {
  }

  /** Returns the point of an edge and isovalue. If it is new, it is added with the part of the edge
   * that getPart() returns. */
  template <typename GetPart>
  std::uint32_t Find(std::uint32_t low, std::uint32_t high, std::uint32_t value, GetPart&& getPart)
  {
    Crossing point{ low, high, 0 };
    if (2 * this->Points.size() >= this->Slots.size())
    {
      this->Grow();
    }
    std::uint32_t& slot = this->Seek(point, value);
    if (slot == None)
    {
      slot = static_cast<std::uint32_t>(this->Points.size());
      point.Part = getPart();
      this->Points.push_back(point);
      if (!this->OneValue)
      {
        this->Values.push_back(value);
      }
    }
    return slot;
  }

private:
  static constexpr std::uint32_t None = 0xffffffffu;

  std::uint32_t GetValue(std::size_t point) const
  {
    return this->OneValue ? 0 : this->Values[point];
  }

  /** The slot of a point, or the free one where it belongs. */
  std::uint32_t& Seek(const Crossing& point, std::uint32_t value)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::uint64_t hash = (std::uint64_t{ point.High } << 32 | point.Low) * 0x9e3779b97f4a7c15ull;
    hash = (hash ^ (hash >> 29) ^ value) * 0xbf58476d1ce4e5b9ull;
    const auto isOther = [&](std::uint32_t other)
    {
      const Crossing& found = this->Points[other];
      return found.Low != point.Low || found.High != point.High || this->GetValue(other) != value;
    };
    std::size_t at = (hash >> 32) & mask;
    while (this->Slots[at] != None && isOther(this->Slots[at]))
    {
      at = (at + 1) & mask;
    }
    return this->Slots[at];
  }

  void Grow()
  {
    this->Slots.assign(2 * this->Slots.size(), None);
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->Seek(this->Points[i], this->GetValue(i)) = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<Crossing>& Points;
  const bool OneValue;
  std::vector<std::uint32_t> Slots; // places in Points, or None
  std::vector<std::uint32_t>
    Values; // for each point the number of its isovalue, if there are several
};

/** The fraction of the way from a low value to a high one at which the isovalue is. */
double Divide(double value, double low, double high)
{
  const double whole = high - low;
  return std::isfinite(whole) ? (value - low) / whole
                              : (value / 2 - low / 2) / (high / 2 - low / 2);
}

template <typename Id, typename Value>
class Marcher
{
public:
  Marcher(const MarchInput& mesh, std::uint64_t tets, std::span<const double> values)
    : Points(mesh.Points)
    , Connectivity(static_cast<const Id*>(mesh.Connectivity))
    , PointValues(static_cast<const Value*>(mesh.Values))
    , Isovalues(values)
    , Found(this->Result.Points, static_cast<std::size_t>(tets / 4), values.size() == 1)
  {
  }

  MarchedSurface March(std::uint64_t first, std::uint64_t last)
  {
    if (this->Isovalues.empty())
    {
      return {};
    }
    // Most tetrahedra are on one side of the value. The sides of all points are found at once,
    // unless these tetrahedra have few of the points.
    if (this->Isovalues.size() == 1 && this->Points <= last - first)
    {
      this->MarchSides(first, last);
    }
    else
    {
      this->MarchRanges(first, last);
    }
    return std::move(this->Result);
  }

private:
  using Values = std::array<Value, 4>;

  /** The corners of a tetrahedron, all of them points that exist. */
  const Id* GetCorners(std::uint64_t tet) const
  {
    const Id* const ids = this->Connectivity + 4 * tet;
    const auto largest = std::max(std::max(ToUnsigned(ids[0]), ToUnsigned(ids[1])),
      std::max(ToUnsigned(ids[2]), ToUnsigned(ids[3])));
    if (largest >= this->Points)
    {
      ThrowInvalid("cell " + std::to_string(tet) + " has a point that does not exist");
    }
    return ids;
  }

  Values GetValues(const Id* ids) const
  {
    return { this->PointValues[ids[0]], this->PointValues[ids[1]], this->PointValues[ids[2]],
      this->PointValues[ids[3]] };
  }

  static bool AreFinite(const Values& v)
  {
    return std::all_of(v.begin(), v.end(), [](Value x) { return std::isfinite(x); });
  }

  /** With one isovalue. */
  void MarchSides(std::uint64_t first, std::uint64_t last)
  {
    const double value = this->Isovalues.front();
    std::vector<std::uint8_t> isInside(static_cast<std::size_t>(this->Points));
    for (std::size_t i = 0; i < isInside.size(); ++i)
    {
      isInside[i] = this->PointValues[i] >= value;
    }
    for (std::uint64_t t = first; t < last; ++t)
    {
      const Id* const ids = this->GetCorners(t);
      const unsigned inside = unsigned{ isInside[ids[0]] } | unsigned{ isInside[ids[1]] } << 1 |
        unsigned{ isInside[ids[2]] } << 2 | unsigned{ isInside[ids[3]] } << 3;
      if (inside != 0 && inside != 15)
      {
        const Values v = this->GetValues(ids);
        if (AreFinite(v))
        {
          this->Cut(static_cast<std::uint32_t>(t), ids, v, 0, inside);
        }
      }
    }
  }

  void MarchRanges(std::uint64_t first, std::uint64_t last)
  {
    const auto begin = this->Isovalues.begin();
    const double lowest = this->Isovalues.front();
    const double highest = this->Isovalues.back();
    for (std::uint64_t t = first; t < last; ++t)
    {
      const Id* const ids = this->GetCorners(t);
      const Values v = this->GetValues(ids);
      const double least = std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
      const double most = std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
      if (!(least < highest && most >= lowest) || !AreFinite(v))
      {
        continue;
      }
      auto it = std::upper_bound(begin, this->Isovalues.end(), least);
      for (; it != this->Isovalues.end() && *it <= most; ++it)
      {
        unsigned inside = 0;
        for (unsigned i = 0; i < 4; ++i)
        {
          inside |= static_cast<unsigned>(v[i] >= *it) << i;
        }
        this->Cut(
          static_cast<std::uint32_t>(t), ids, v, static_cast<std::uint32_t>(it - begin), inside);
      }
    }
  }

  /** Negative ids become large, and thus out of range. */
  static std::uint64_t ToUnsigned(Id id)
  {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(id));
  }

  /** Adds the triangles of a tetrahedron for an isovalue. inside: bit i for corner i. */
  void Cut(
    std::uint32_t cell, const Id* ids, const Values& v, std::uint32_t number, unsigned inside)
  {
    const double value = this->Isovalues[number];
    std::array<std::uint32_t, 6> places{};
    const unsigned triangles = TriangleCounts[inside];
    for (unsigned k = 0; k < 3 * triangles; ++k)
    {
      const auto* const edge = Edges[Cases[inside][k]];
      const bool rises = v[edge[0]] < v[edge[1]];
      const unsigned low = edge[rises ? 0 : 1];
      const unsigned high = edge[rises ? 1 : 0];
      places[k] = this->Found.Find(static_cast<std::uint32_t>(ids[low]),
        static_cast<std::uint32_t>(ids[high]), number,
        [&] { return Divide(value, v[low], v[high]); });
    }
    for (unsigned k = 0; k < triangles; ++k)
    {
      this->Result.Triangles.push_back({ places[3 * k], places[3 * k + 1], places[3 * k + 2] });
      this->Result.Cells.push_back(cell);
    }
  }

  std::uint64_t Points;
  const Id* Connectivity;
  const Value* PointValues;
  std::span<const double> Isovalues;
  MarchedSurface Result;
  EdgeTable Found;
};
}

//------------------------------------------------------------------------------
MarchedSurface March(
  const MarchInput& mesh, std::uint64_t first, std::uint64_t last, std::span<const double> values)
{
  const auto march = [&]<typename Id, typename Value>(Id, Value)
  { return Marcher<Id, Value>(mesh, last - first, values).March(first, last); };
  if (mesh.WideIds)
  {
    return mesh.WideValues ? march(std::int64_t{}, double{}) : march(std::int64_t{}, float{});
  }
  return mesh.WideValues ? march(std::int32_t{}, double{}) : march(std::int32_t{}, float{});
}
}
