// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSurface.h"

#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunVector.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>
#include <span>

namespace gatun
{
namespace
{
// The number of hash tables, which are filled in parallel.
constexpr std::size_t Tables = 16;

/** A hash that is the same for equal coordinates, and for zeros of either sign. */
template <typename T>
std::uint32_t Hash(const T* x)
{
  std::uint64_t hash = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(x[axis]) + 0.0);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 32;
  }
  return static_cast<std::uint32_t>(hash);
}

/** The parts that points are in. Points are numbered part by part. */
template <typename T>
class PartPoints
{
public:
  PartPoints(const std::vector<SurfacePart>& parts, const std::vector<std::size_t>& first)
    : Parts(parts)
    , First(first)
  {
  }

  const T* Get(std::size_t part) const
  {
    return reinterpret_cast<const T*>(this->Parts[part].Points.data());
  }

  bool AreSame(std::size_t a, std::size_t b) const
  {
    const T* const x = this->Find(a);
    return std::equal(x, x + 3, this->Find(b));
  }

private:
  const T* Find(std::size_t point) const
  {
    const auto next = std::upper_bound(this->First.begin(), this->First.end(), point);
    return this->Get(static_cast<std::size_t>(next - this->First.begin() - 1)) +
      3 * (point - *(next - 1));
  }

  const std::vector<SurfacePart>& Parts;
  const std::vector<std::size_t>& First;
};

/** Finds the first point with the same coordinates for each point. */
template <typename T>
class Joiner
{
public:
  Joiner(const std::vector<SurfacePart>& parts, const std::vector<std::size_t>& first)
    : Points(parts, first)
    , Hashes(first.back())
  {
    ParallelFor(parts.size(),
      [&](std::size_t p)
      {
        const T* point = this->Points.Get(p);
        for (std::size_t i = first[p]; i < first[p + 1]; ++i, point += 3)
        {
          this->Hashes[i] = Hash(point);
        }
      });
  }

  std::vector<std::uint32_t> Join()
  {
    this->SortByTable();
    this->Same.resize(this->Hashes.size());
    ParallelFor(Tables, [&](std::size_t table) { this->Fill(table); });
    return std::move(this->Same);
  }

private:
  static constexpr std::uint32_t None = 0xffffffffu;

  struct Slot
  {
    std::uint32_t Hash;
    std::uint32_t Point;
  };

  static std::size_t GetTable(std::uint32_t hash) { return hash % Tables; }

  /** Lists the points of each table in their order. */
  void SortByTable()
  {
    for (const std::uint32_t hash : this->Hashes)
    {
      ++this->Start[GetTable(hash) + 1];
    }
    std::partial_sum(this->Start.begin(), this->Start.end(), this->Start.begin());
    auto next = this->Start;
    this->Order.resize(this->Hashes.size());
    for (std::size_t i = 0; i < this->Hashes.size(); ++i)
    {
      this->Order[next[GetTable(this->Hashes[i])]++] = static_cast<std::uint32_t>(i);
    }
  }

  void Fill(std::size_t table)
  {
    const std::size_t begin = this->Start[table];
    const auto own = std::span(this->Order).subspan(begin, this->Start[table + 1] - begin);
    std::vector<Slot> slots(std::bit_ceil(2 * own.size() + 1), Slot{ 0, None });
    const std::size_t mask = slots.size() - 1;
    for (const std::uint32_t i : own)
    {
      const std::uint32_t hash = this->Hashes[i];
      std::size_t at = (hash / Tables) & mask;
      while (slots[at].Point != None &&
        (slots[at].Hash != hash || !this->Points.AreSame(slots[at].Point, i)))
      {
        at = (at + 1) & mask;
      }
      if (slots[at].Point == None)
      {
        slots[at] = { hash, i };
      }
      this->Same[i] = slots[at].Point;
    }
  }

  PartPoints<T> Points;
  std::vector<std::uint32_t> Hashes;
  std::array<std::size_t, Tables + 1> Start{}; // of each table in Order
  std::vector<std::uint32_t> Order;
  std::vector<std::uint32_t> Same;
};
}

//------------------------------------------------------------------------------
Surface::Surface(
  std::vector<SurfacePart> parts, ScalarType coordinateType, const std::vector<std::size_t>& ghosts)
  : Parts(std::move(parts))
  , CoordinateType(coordinateType)
  , Kept(Parts.size())
{
  this->First.assign(1, 0);
  for (const SurfacePart& part : this->Parts)
  {
    this->First.push_back(this->First.back() + part.NumberOfPoints);
  }
  if (this->First.back() >= None)
  {
    ThrowInvalid("the surface has more than 2^32 points; ask for fewer values at a time");
  }
  for (const std::size_t ghost : ghosts)
  {
    this->Parts[ghost].Triangles.clear();
  }
  this->Same = coordinateType == ScalarType::Float32
    ? Joiner<float>(this->Parts, this->First).Join()
    : Joiner<double>(this->Parts, this->First).Join();
  this->Places.assign(this->Same.size(), None);
  ParallelFor(this->Parts.size(), [&](std::size_t p) { this->RemoveDegenerate(p); });
  this->NumberPoints();
  this->FirstTriangle.assign(1, 0);
  for (const SurfacePart& part : this->Parts)
  {
    this->FirstTriangle.push_back(this->FirstTriangle.back() + part.Triangles.size());
  }
}

//------------------------------------------------------------------------------
/** Removes the triangles of a part with less than three different points, and marks the points of
 * the others. */
void Surface::RemoveDegenerate(std::size_t p)
{
  SurfacePart& part = this->Parts[p];
  const bool hasCells = !part.CellArrays.empty();
  const std::uint32_t* const same = this->Same.data() + this->First[p];
  std::uint32_t* const places = this->Places.data() + this->First[p];
  std::size_t left = 0;
  for (std::size_t i = 0; i < part.Triangles.size(); ++i)
  {
    const auto corners = part.Triangles[i];
    const std::uint32_t a = same[corners[0]];
    const std::uint32_t b = same[corners[1]];
    const std::uint32_t c = same[corners[2]];
    if (a != b && b != c && c != a)
    {
      part.Triangles[left++] = corners;
      if (hasCells)
      {
        this->Kept[p].push_back(static_cast<std::uint32_t>(i));
      }
      for (const std::uint32_t corner : corners)
      {
        places[corner] = 0;
      }
    }
  }
  part.Triangles.resize(left);
}

//------------------------------------------------------------------------------
/** Numbers the marked points in their order. */
void Surface::NumberPoints()
{
  // The first point with the same coordinates is marked instead; it is not behind the point.
  for (std::size_t i = 0; i < this->Places.size(); ++i)
  {
    if (this->Places[i] != None && this->Same[i] != i)
    {
      this->Places[i] = None;
      this->Places[this->Same[i]] = 0;
    }
  }
  std::uint32_t next = 0;
  for (std::uint32_t& place : this->Places)
  {
    if (place != None)
    {
      place = next++;
    }
  }
  this->Points = next;
}

//------------------------------------------------------------------------------
void Surface::FillTriangles(void* to, bool wideIds) const
{
  const auto fill = [&](auto* ids)
  {
    ParallelFor(this->Parts.size(),
      [&](std::size_t p)
      {
        auto* out = ids + 3 * this->FirstTriangle[p];
        for (const auto& corners : this->Parts[p].Triangles)
        {
          for (const std::uint32_t corner : corners)
          {
            *out++ = this->Places[this->Same[this->First[p] + corner]];
          }
        }
      });
  };
  if (wideIds)
  {
    fill(static_cast<std::uint64_t*>(to));
  }
  else
  {
    fill(static_cast<std::uint32_t*>(to));
  }
}

//------------------------------------------------------------------------------
std::vector<std::array<std::uint32_t, 3>> Surface::GetTriangles() const
{
  std::vector<std::array<std::uint32_t, 3>> triangles(this->GetNumberOfTriangles());
  this->FillTriangles(triangles.data(), false);
  return triangles;
}

//------------------------------------------------------------------------------
void Surface::Copy(
  std::size_t part, const std::uint8_t* tuples, std::size_t tupleSize, void* to) const
{
  for (std::size_t n = this->First[part]; n < this->First[part + 1]; ++n, tuples += tupleSize)
  {
    if (this->Places[n] != None)
    {
      std::memcpy(static_cast<std::uint8_t*>(to) + this->Places[n] * tupleSize, tuples, tupleSize);
    }
  }
}

//------------------------------------------------------------------------------
void Surface::FillPoints(void* to) const
{
  const std::size_t size = 3 * SizeOf(this->CoordinateType);
  ParallelFor(this->Parts.size(),
    [&](std::size_t p) { this->Copy(p, this->Parts[p].Points.data(), size, to); });
}

//------------------------------------------------------------------------------
void Surface::FillPointArray(std::size_t i, std::size_t tupleSize, void* to) const
{
  ParallelFor(this->Parts.size(),
    [&](std::size_t p)
    {
      if (this->Parts[p].NumberOfPoints > 0)
      {
        this->Copy(p, this->Parts[p].PointArrays[i].data(), tupleSize, to);
      }
    });
}

//------------------------------------------------------------------------------
void Surface::FillCellArray(std::size_t i, std::size_t tupleSize, void* to) const
{
  auto* out = static_cast<std::uint8_t*>(to);
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    for (const std::uint32_t triangle : this->Kept[p])
    {
      std::memcpy(out, this->Parts[p].CellArrays[i].data() + triangle * tupleSize, tupleSize);
      out += tupleSize;
    }
  }
}

//------------------------------------------------------------------------------
void Surface::FillNormals(float* to) const
{
  std::vector<glm::dvec3> sums(this->Points, glm::dvec3(0));
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    for (std::size_t i = 0; i < this->Parts[p].NumberOfPoints; ++i)
    {
      const std::uint32_t place = this->Places[this->Same[this->First[p] + i]];
      if (place != None)
      {
        sums[place] += ToVector(this->Parts[p].Gradients[i]);
      }
    }
  }
  for (const auto& sum : sums)
  {
    const double length = std::hypot(sum.x, sum.y, sum.z);
    for (int axis = 0; axis < 3; ++axis)
    {
      *to++ = length > 0 && std::isfinite(length) ? static_cast<float>(-sum[axis] / length) : 0;
    }
  }
}
}
