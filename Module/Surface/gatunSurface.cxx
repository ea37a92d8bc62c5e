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

/** Moves the points of all parts, one part after the other, to one list. */
std::vector<std::uint8_t> TakePoints(
  std::vector<SurfacePart>& parts, const std::vector<std::size_t>& first, std::size_t size)
{
  std::vector<std::uint8_t> points(first.back() * size);
  ParallelFor(parts.size(),
    [&](std::size_t p)
    {
      const auto own = std::move(parts[p].Points);
      std::copy(
        own.begin(), own.end(), points.begin() + static_cast<std::ptrdiff_t>(first[p] * size));
    });
  return points;
}

/** Finds the first point with the same coordinates for each point. */
template <typename T>
class Joiner
{
public:
  Joiner(const std::vector<std::uint8_t>& points, const std::vector<std::size_t>& first)
    : Points(reinterpret_cast<const T*>(points.data()))
    , Hashes(first.back())
    , Same(first.back())
  {
    ParallelFor(first.size() - 1,
      [&](std::size_t p)
      {
        for (std::size_t i = first[p]; i < first[p + 1]; ++i)
        {
          this->Hashes[i] = Hash(this->Points + 3 * i);
        }
      });
  }

  std::vector<std::uint32_t> Join()
  {
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

  bool AreSame(std::size_t a, std::size_t b) const
  {
    const T* const x = this->Points + 3 * a;
    return std::equal(x, x + 3, this->Points + 3 * b);
  }

  void Fill(std::size_t table)
  {
    const auto count = static_cast<std::size_t>(std::count_if(this->Hashes.begin(),
      this->Hashes.end(), [table](std::uint32_t hash) { return GetTable(hash) == table; }));
    std::vector<Slot> slots(std::bit_ceil(2 * count + 1), Slot{ 0, None });
    const std::size_t mask = slots.size() - 1;
    for (std::size_t i = 0; i < this->Hashes.size(); ++i)
    {
      const std::uint32_t hash = this->Hashes[i];
      if (GetTable(hash) != table)
      {
        continue;
      }
      std::size_t at = (hash / Tables) & mask;
      while (
        slots[at].Point != None && (slots[at].Hash != hash || !this->AreSame(slots[at].Point, i)))
      {
        at = (at + 1) & mask;
      }
      if (slots[at].Point == None)
      {
        slots[at] = { hash, static_cast<std::uint32_t>(i) };
      }
      this->Same[i] = slots[at].Point;
    }
  }

  const T* Points;
  std::vector<std::uint32_t> Hashes;
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
  this->Coordinates = TakePoints(this->Parts, this->First, 3 * SizeOf(coordinateType));
  this->Same = coordinateType == ScalarType::Float32
    ? Joiner<float>(this->Coordinates, this->First).Join()
    : Joiner<double>(this->Coordinates, this->First).Join();

  // The points of the remaining triangles are numbered in their order.
  this->Places.assign(this->Same.size(), None);
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    const auto own = std::move(this->Parts[p].Triangles);
    if (std::binary_search(ghosts.begin(), ghosts.end(), p))
    {
      continue;
    }
    const bool hasCells = !this->Parts[p].CellArrays.empty();
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      std::array<std::uint32_t, 3> corners;
      std::transform(own[i].begin(), own[i].end(), corners.begin(),
        [&](std::uint32_t corner) { return this->Same[this->First[p] + corner]; });
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      {
        this->Triangles.push_back(corners);
        if (hasCells)
        {
          this->Kept[p].push_back(static_cast<std::uint32_t>(i));
        }
        for (const std::uint32_t corner : corners)
        {
          this->Places[corner] = 0;
        }
      }
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
  for (auto& triangle : this->Triangles)
  {
    for (std::uint32_t& corner : triangle)
    {
      corner = this->Places[corner];
    }
  }
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
    [&](std::size_t p)
    { this->Copy(p, this->Coordinates.data() + this->First[p] * size, size, to); });
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
