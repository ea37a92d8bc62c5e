// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayBlock.h"

#include "gatunVector.h"

#include <algorithm>
#include <span>

namespace gatun
{
namespace
{
constexpr auto None = RayBlock::NoNeighbor;

/** Faces whose second tetrahedron has not come yet, in one list for each first corner. */
class WaitingFaces
{
public:
  explicit WaitingFaces(std::size_t points)
    : Lists(points, None)
  {
  }

  /** Removes and returns the face with these corners. If there is none, adds this one and returns
   * None. */
  std::uint32_t Match(
    std::uint32_t first, std::uint32_t second, std::uint32_t third, std::uint32_t face)
  {
    auto* link = &this->Lists[first];
    while (*link != None)
    {
      Waiting& other = this->Faces[*link];
      if (other.Second == second && other.Third == third)
      {
        const auto place = *link;
        *link = other.Next;
        other.Next = this->Free;
        this->Free = place;
        return other.Face;
      }
      link = &other.Next;
    }
    auto place = this->Free;
    if (place == None)
    {
      place = static_cast<std::uint32_t>(this->Faces.size());
      this->Faces.emplace_back();
    }
    else
    {
      this->Free = this->Faces[place].Next;
    }
    this->Faces[place] = { second, third, face, this->Lists[first] };
    this->Lists[first] = place;
    return None;
  }

private:
  struct Waiting
  {
    std::uint32_t Second, Third, Face, Next;
  };
  std::vector<std::uint32_t> Lists;
  std::vector<Waiting> Faces;
  std::uint32_t Free = None;
};

/** Makes two tetrahedra neighbors that have all corners in common but one each, which is last in
 * one of them. */
void LinkToParent(std::span<const RayBlock::Tet> tets, std::size_t child, std::size_t parent,
  std::uint32_t last, std::vector<RayBlock::Tet>& neighbors)
{
  const auto& one = tets[child];
  const auto& other = tets[parent];
  std::uint32_t side = 0;
  std::uint32_t otherSide = 0;
  unsigned apart = 0;
  for (std::uint32_t k = 0; k < 4; ++k)
  {
    side = one[k] == last ? k : side;
    const bool isShared = other[k] != last &&
      ((other[k] == one[0]) | (other[k] == one[1]) | (other[k] == one[2]) | (other[k] == one[3]));
    otherSide = isShared ? otherSide : k;
    apart += isShared ? 0 : 1;
  }
  if (apart == 1 && neighbors[child][side] == None && neighbors[parent][otherSide] == None)
  {
    neighbors[child][side] = static_cast<std::uint32_t>(4 * parent + otherSide);
    neighbors[parent][otherSide] = static_cast<std::uint32_t>(4 * child + side);
  }
}

/** Finds the neighbors that are not known yet. */
void FindNeighbors(
  std::span<const RayBlock::Tet> tets, std::size_t points, std::vector<RayBlock::Tet>& neighbors)
{
  WaitingFaces waiting(points);
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    const auto& tet = tets[i];
    for (std::uint32_t side = 0; side < 4; ++side)
    {
      if (neighbors[i][side] != None)
      {
        continue;
      }
      const auto face = static_cast<std::uint32_t>(4 * i + side);
      const auto other =
        waiting.Match(tet[side == 0 ? 1 : 0], tet[side <= 1 ? 2 : 1], tet[side <= 2 ? 3 : 2], face);
      if (other != None)
      {
        neighbors[i][side] = other;
        neighbors[other / 4][other % 4] = face;
      }
    }
  }
}

bool IsBefore(const RayPoint& a, const RayPoint& b)
{
  return a.X != b.X ? a.X < b.X : a.Y != b.Y ? a.Y < b.Y : a.Z < b.Z;
}

bool HasNegativeVolume(const RayPoint& a, const RayPoint& b, const RayPoint& c, const RayPoint& d)
{
  const auto fromA = [&](const RayPoint& p) { return glm::dvec3(p.X - a.X, p.Y - a.Y, p.Z - a.Z); };
  return GetDeterminant(fromA(d), fromA(b), fromA(c)) < 0;
}
}

//------------------------------------------------------------------------------
void RayBlock::Prepare()
{
  this->Turned.resize(this->Tets.size());
  this->Neighbors.assign(this->Tets.size(), { None, None, None, None });
  for (std::size_t i = 0; i < this->Tets.size(); ++i)
  {
    auto& tet = this->Tets[i];
    const auto last = tet[3];
    const auto arrange = [&](unsigned first, unsigned second)
    {
      const auto a = tet[first];
      const auto b = tet[second];
      const bool swap = IsBefore(this->Points[b], this->Points[a]) ||
        (b < a && !IsBefore(this->Points[a], this->Points[b]));
      tet[first] = swap ? b : a;
      tet[second] = swap ? a : b;
    };
    arrange(0, 1);
    arrange(2, 3);
    arrange(0, 2);
    arrange(1, 3);
    arrange(1, 2);
    this->Turned[i] = HasNegativeVolume(
      this->Points[tet[0]], this->Points[tet[1]], this->Points[tet[2]], this->Points[tet[3]]);
    if (i < this->Parents.size() && this->Parents[i] < i)
    {
      LinkToParent(this->Tets, i, this->Parents[i], last, this->Neighbors);
    }
  }
  std::vector<std::uint32_t>().swap(this->Parents);
  FindNeighbors(this->Tets, this->Points.size(), this->Neighbors);
}

//------------------------------------------------------------------------------
std::size_t RayBlock::GetMemorySize() const
{
  return this->Points.capacity() * sizeof(RayPoint) + this->Turned.capacity() +
    (this->CellValues.capacity() + this->Hues.Values.capacity()) * sizeof(double) +
    (this->Tets.capacity() + this->Neighbors.capacity()) * sizeof(Tet);
}
}
