// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSurfaceCosts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{

/** The cosine of the largest angle by which a merge may turn a triangle. */
constexpr double LargestTurn = 0.5;

/** New triangles must not be thinner than this part of their longest edge, unless they were. */
constexpr double Thinnest = 1e-3;

/** Places with more points than this, which few surfaces have, are not merged: it would take memory
 * with the square of their number. */
constexpr std::size_t MostSides = 64;

/** So many neighbors are searched one by one. */
constexpr std::size_t ShortList = 12;

/** Where all is alike, short edges come first: their length counts as a distance of this part of
 * it, squared. */
constexpr double LengthWeight = 1e-6;
}

//------------------------------------------------------------------------------
void MergeSurface::Merge(std::uint32_t place, std::uint32_t into)
{
  const auto offset = this->GetPosition(into) - this->GetPosition(place);
  for (const Pair& pair : this->MergeTriangles::Merge(place, into))
  {
    this->Quadrics.Add(pair[0], pair[1], offset);
    this->Pairs.push_back(pair);
  }
}

//------------------------------------------------------------------------------
void SurfaceCosts::MarkNeighbors()
{
  for (std::uint32_t i = 0; i < this->Neighbors.size(); ++i)
  {
    this->Marks[this->Neighbors[i].Place] = i + 1;
  }
}

//------------------------------------------------------------------------------
std::uint32_t SurfaceCosts::FindNeighbor(std::uint32_t place)
{
  const auto add = [&]
  {
    const Vec offset = this->Mesh.GetPosition(place) - this->Mesh.GetPosition(this->Place);
    this->Neighbors.push_back({ place, 0, offset, MergeChoice::Never, 0 });
    return static_cast<std::uint32_t>(this->Neighbors.size());
  };
  // Marks of points all over the mesh are slower than a short list.
  std::uint32_t number = 0;
  if (this->Neighbors.size() <= ShortList)
  {
    while (number < this->Neighbors.size() && this->Neighbors[number].Place != place)
    {
      ++number;
    }
    number = number < this->Neighbors.size() ? number + 1 : add();
    if (number > ShortList)
    {
      this->MarkNeighbors();
    }
  }
  else
  {
    std::uint32_t& mark = this->Marks[place];
    mark = mark == 0 ? add() : mark;
    number = mark;
  }
  ++this->Neighbors[number - 1].Triangles;
  return number - 1;
}

//------------------------------------------------------------------------------
void SurfaceCosts::SetTarget(std::uint32_t neighbor, std::uint32_t side, std::uint32_t point)
{
  std::uint32_t& target = this->Targets[neighbor * this->Sides.size() + side];
  target = target == None || target == point ? point : Several;
}

//------------------------------------------------------------------------------
void SurfaceCosts::Gather(std::uint32_t place)
{
  this->Place = place;
  this->Neighbors.clear();
  this->Triangles.clear();
  const auto ring = this->Mesh.GetRing(place);
  for (const auto cell : ring)
  {
    const auto& corners = this->Mesh.GetCell(cell);
    const unsigned at = MergeTriangles::FindKnownCorner(corners, place);
    const std::uint32_t a = this->FindNeighbor(corners[(at + 1) % 3]);
    const std::uint32_t b = this->FindNeighbor(corners[(at + 2) % 3]);
    this->Triangles.push_back(
      { a, b, glm::cross(this->Neighbors[a].Offset, this->Neighbors[b].Offset) });
  }
  this->FindTargets();
  this->IsOnBorder = false;
  for (const Neighbor& neighbor : this->Neighbors)
  {
    if (this->Neighbors.size() > ShortList)
    {
      this->Marks[neighbor.Place] = 0;
    }
    this->IsOnBorder = this->IsOnBorder || neighbor.Triangles == 1;
  }
}

//------------------------------------------------------------------------------
/** For each point of the place and each neighbor, the point there that it can be merged into. */
void SurfaceCosts::FindTargets()
{
  this->Sides.clear();
  this->Targets.clear();
  if (!this->Mesh.HasSeams())
  {
    this->Sides.push_back(this->Mesh.GetFirstPoint(this->Place));
    for (const Neighbor& neighbor : this->Neighbors)
    {
      this->Targets.push_back(this->Mesh.GetFirstPoint(neighbor.Place));
    }
    return;
  }
  const auto ring = this->Mesh.GetRing(this->Place);
  const auto getCorner = [&](std::size_t i)
  { return MergeTriangles::FindKnownCorner(this->Mesh.GetCell(ring[i]), this->Place); };
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const std::uint32_t side = this->Mesh.GetPoint(ring[i], getCorner(i));
    if (std::find(this->Sides.begin(), this->Sides.end(), side) == this->Sides.end())
    {
      this->Sides.push_back(side);
      if (this->Sides.size() > MostSides)
      {
        return;
      }
    }
  }
  this->Targets.assign(this->Neighbors.size() * this->Sides.size(), None);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const unsigned at = getCorner(i);
    const auto side = static_cast<std::uint32_t>(
      std::find(this->Sides.begin(), this->Sides.end(), this->Mesh.GetPoint(ring[i], at)) -
      this->Sides.begin());
    this->SetTarget(this->Triangles[i].First, side, this->Mesh.GetPoint(ring[i], (at + 1) % 3));
    this->SetTarget(this->Triangles[i].Second, side, this->Mesh.GetPoint(ring[i], (at + 2) % 3));
  }
}

//------------------------------------------------------------------------------
void SurfaceCosts::FindCost(std::size_t index)
{
  Neighbor& into = this->Neighbors[index];
  if (this->IsOnBorder && (into.Triangles != 1 || !this->Mesh.IsRegular(into.Place)))
  {
    return;
  }
  double weight = 0;
  double change = 0;
  for (std::size_t side = 0; side < this->Sides.size(); ++side)
  {
    const std::uint32_t target = this->Targets[index * this->Sides.size() + side];
    if (target >= Several)
    {
      return; // the seam would open
    }
    change += this->Mesh.Quadrics.GetError(this->Sides[side], target, into.Offset);
    weight += this->Mesh.Quadrics.GetWeight(this->Sides[side]);
  }
  into.Change = change;
  // Between the sum of the squares of distances, whose mean stays small, and their mean around
  // the place, whose maximum does.
  into.Cost = (change + LengthWeight * weight * glm::dot(into.Offset, into.Offset)) /
    std::sqrt(std::sqrt(weight));
}

//------------------------------------------------------------------------------
/** Whether all triangles that remain keep about their normal, and do not become flat. */
bool SurfaceCosts::TurnsNone(std::uint32_t neighbor) const
{
  const Vec& to = this->Neighbors[neighbor].Offset;
  for (const Triangle& triangle : this->Triangles)
  {
    if (triangle.First == neighbor || triangle.Second == neighbor)
    {
      continue;
    }
    const Vec a = this->Neighbors[triangle.First].Offset - to;
    const Vec b = this->Neighbors[triangle.Second].Offset - to;
    const Vec normal = glm::cross(a, b);
    const double square = glm::dot(normal, normal);
    const double old = glm::dot(triangle.Normal, triangle.Normal);
    const double cosine = glm::dot(normal, triangle.Normal);
    if (!(cosine > 0 && cosine * cosine > LargestTurn * LargestTurn * square * old))
    {
      return false;
    }
    const double longest = std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(b - a, b - a) });
    if (square < Thinnest * Thinnest * longest * longest && square < old)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
MergeChoice SurfaceCosts::Choose(
  std::uint32_t place, std::uint32_t /*tryFirst*/, bool checkTopology)
{
  this->Gather(place);
  if (this->Sides.size() > MostSides)
  {
    return {};
  }
  for (std::size_t i = 0; i < this->Neighbors.size(); ++i)
  {
    this->FindCost(i);
  }
  for (;;)
  {
    std::uint32_t best = None;
    for (std::uint32_t i = 0; i < this->Neighbors.size(); ++i)
    {
      const double cost = this->Neighbors[i].Cost;
      const bool isBetter = cost < MergeChoice::Never &&
        (best == None || cost < this->Neighbors[best].Cost ||
          (cost == this->Neighbors[best].Cost &&
            this->Neighbors[i].Place < this->Neighbors[best].Place));
      best = isBetter ? i : best;
    }
    if (best == None)
    {
      return {};
    }
    Neighbor& into = this->Neighbors[best];
    if (this->TurnsNone(best) && (!checkTopology || this->MayMerge(place, into.Place)))
    {
      return { into.Place, into.Cost, into.Change };
    }
    into.Cost = MergeChoice::Never;
  }
}

//------------------------------------------------------------------------------
/** Whether an edge between common neighbors, which are marked as Shared, has triangles with both
 * places: all of them are those of a tetrahedron. An edge of the border and its only common
 * neighbor: whether they are a triangle that has no other ones around. */
bool SurfaceCosts::ShareOppositeEdge(std::uint32_t place, std::uint32_t into, bool isOfBorder) const
{
  const auto isShared = [&](std::uint32_t corner) { return (this->Marks[corner] & Shared) != 0; };
  const auto countShared = [&](std::uint32_t of, std::uint32_t without)
  {
    std::size_t edges = 0;
    for (const auto cell : this->Mesh.GetRing(of))
    {
      const auto& corners = this->Mesh.GetCell(cell);
      const auto found = std::count_if(corners.begin(), corners.end(),
        [&](std::uint32_t corner)
        { return corner != of && corner != without && isShared(corner); });
      edges += isOfBorder ? static_cast<std::size_t>(found) : static_cast<std::size_t>(found == 2);
    }
    return edges;
  };
  const std::size_t ofPlace = countShared(place, into);
  return isOfBorder ? ofPlace == 1 && countShared(into, place) == 1
                    : ofPlace > 0 && countShared(into, place) > 0;
}

//------------------------------------------------------------------------------
bool SurfaceCosts::MayMerge(std::uint32_t place, std::uint32_t into)
{
  const auto forEachEnd = [&](std::uint32_t of, auto&& body)
  {
    for (const auto cell : this->Mesh.GetRing(of))
    {
      for (const auto corner : this->Mesh.GetCell(cell))
      {
        if (corner != of)
        {
          body(corner);
        }
      }
    }
  };
  forEachEnd(place, [&](std::uint32_t end) { this->Marks[end] += 2; });
  const std::uint32_t triangles = this->Marks[into] / 2;
  std::size_t common = 0;
  forEachEnd(into,
    [&](std::uint32_t end)
    {
      if (this->Marks[end] >= 2 && (this->Marks[end] & Shared) == 0)
      {
        this->Marks[end] |= Shared;
        ++common;
      }
    });
  // The third corners of the triangles on the edge are common neighbors, and no others may be.
  const bool may = triangles >= 1 && triangles <= 2 && common == triangles &&
    !this->ShareOppositeEdge(place, into, triangles == 1);
  forEachEnd(place, [&](std::uint32_t end) { this->Marks[end] = 0; });
  return may;
}
}
