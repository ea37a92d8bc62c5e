// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Based on: Adriaan van Oosterom, Jan Strackee: The solid angle of a plane triangle. IEEE
// Transactions on Biomedical Engineering, 1983.

#include "gatunSurfaceDetail.h"

#include "gatunDetailWeights.h"
#include "gatunError.h"
#include "gatunTypes.h"
#include "gatunVector.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
using Point = SurfaceDetail::Point;
using Triangle = SurfaceDetail::Triangle;

// How much errors count where the surface faces the eye: there they change the shading only.
constexpr double Facing = 0.4;

// Radians from the silhouette to where errors of what is turned away do not count.
constexpr double Ramp = 0.2;

// Points of the surface that tells inside from outside.
constexpr std::uint64_t HullPoints = 2000;

constexpr double RightAngle = std::numbers::pi / 2;

//------------------------------------------------------------------------------
/** Of the errors of a part of a surface, how much counts: 0 to 1. Normal: mean, shorter than 1 if
 * the part is bent. */
double Face(const glm::dvec3& normal, const glm::dvec3& way, bool hidesBack, bool hidesFront)
{
  const double length = glm::length(normal);
  const double distance = glm::length(way);
  if (!(length > 0) || !(distance > 0))
  {
    return 1;
  }
  const double cosine = glm::dot(normal, way) / (length * distance);
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double spread = std::acos(std::min(length, 1.0));
  // From the silhouette, 0 where a part of it is at it.
  const double beyond = std::max(0.0, std::abs(angle - RightAngle) - spread);
  const bool isHidden = angle > RightAngle ? hidesBack : hidesFront;
  return isHidden ? std::max(0.0, 1 - beyond / Ramp)
                  : Facing + (1 - Facing) * std::cos(std::min(beyond, RightAngle));
}

//------------------------------------------------------------------------------
/** A random number for an edge, and its negative for the opposite direction. */
std::uint64_t HashEdge(std::uint32_t from, std::uint32_t to)
{
  // The finalizer of SplitMix64.
  std::uint64_t x = std::uint64_t{ std::min(from, to) } << 32 | std::max(from, to);
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  x ^= x >> 31;
  return from < to ? x : ~x + 1;
}

//------------------------------------------------------------------------------
/** Whether each edge has as many triangles on one side as on the other one. */
bool IsClosed(std::span<const Triangle> triangles)
{
  std::uint64_t sum = 0;
  for (const Triangle& t : triangles)
  {
    sum += HashEdge(t[0], t[1]) + HashEdge(t[1], t[2]) + HashEdge(t[2], t[0]);
  }
  return sum == 0;
}

//------------------------------------------------------------------------------
std::uint32_t FindRoot(std::vector<std::uint32_t>& parents, std::uint32_t point)
{
  while (parents[point] != point)
  {
    parents[point] = parents[parents[point]];
    point = parents[point];
  }
  return point;
}

//------------------------------------------------------------------------------
/** The part of all directions in which a triangle is seen, times 4 pi; negative from its back. */
double GetSolidAngle(const std::array<Point, 3>& triangle, const glm::dvec3& from)
{
  const glm::dvec3 a = ToVector(triangle[0]) - from;
  const glm::dvec3 b = ToVector(triangle[1]) - from;
  const glm::dvec3 c = ToVector(triangle[2]) - from;
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  return -2 *
    std::atan2(GetDeterminant(a, b, c),
      la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}
}

//------------------------------------------------------------------------------
SurfaceDetail::SurfaceDetail(std::shared_ptr<const MergeTree> tree,
  std::shared_ptr<const MergeDependencies> dependencies, std::span<const Point> places,
  std::span<const Triangle> triangles)
  : Chooser(tree, std::move(dependencies), tree->GetNumberOfPoints())
{
  const std::size_t count = tree->GetNumberOfPoints();
  const bool fits = std::all_of(triangles.begin(), triangles.end(),
    [count](const Triangle& triangle)
    { return *std::max_element(triangle.begin(), triangle.end()) < count; });
  if (places.size() != count || !fits)
  {
    ThrowInvalid("the points and triangles are not those of the merges");
  }
  Bounds box;
  for (const Point& place : places)
  {
    if (std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]))
    {
      box.Include(place);
    }
  }
  if (!box.IsEmpty())
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Middle[c] = 0.5 * box[c].Min + 0.5 * box[c].Max;
    }
    this->Size = GetDiagonal(box);
  }
  this->Places.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Places[i][c] = static_cast<float>(places[i][c] - this->Middle[c]);
    }
  }
  this->FindNormals(triangles);
  this->FindSolid(triangles);
}

//------------------------------------------------------------------------------
SurfaceDetail::Point SurfaceDetail::Restore(const Small& place) const
{
  return { this->Middle[0] + double{ place[0] }, this->Middle[1] + double{ place[1] },
    this->Middle[2] + double{ place[2] } };
}

//------------------------------------------------------------------------------
void SurfaceDetail::FindNormals(std::span<const Triangle> triangles)
{
  this->Normals.resize(this->Places.size());
  std::vector<float> areas(this->Places.size());
  const auto at = [this](std::uint32_t i)
  {
    const Small& place = this->Places[i];
    return glm::dvec3(place[0], place[1], place[2]);
  };
  for (const Triangle& t : triangles)
  {
    const glm::dvec3 first = at(t[0]);
    const glm::dvec3 normal = glm::cross(at(t[1]) - first, at(t[2]) - first);
    const double area = glm::length(normal);
    if (!std::isfinite(area))
    {
      continue;
    }
    for (const std::uint32_t corner : t)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        this->Normals[corner][c] += static_cast<float>(normal[static_cast<int>(c)]);
      }
      areas[corner] += static_cast<float>(area);
    }
  }
  const auto finish = [&](std::uint32_t point)
  {
    for (float& x : this->Normals[point])
    {
      x = areas[point] > 0 ? x / areas[point] : 0;
    }
  };
  // What is merged into a point before it is merged itself is complete then.
  std::vector<bool> isMerged(this->Places.size(), false);
  for (const Merge& merge : this->Chooser.GetTree().GetMerges())
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Normals[merge.Into][c] += this->Normals[merge.Point][c];
    }
    areas[merge.Into] += areas[merge.Point];
    finish(merge.Point);
    isMerged[merge.Point] = true;
  }
  for (std::uint32_t point = 0; point < isMerged.size(); ++point)
  {
    if (!isMerged[point])
    {
      finish(point);
    }
  }
}

//------------------------------------------------------------------------------
void SurfaceDetail::FindSolid(std::span<const Triangle> triangles)
{
  if (triangles.empty() || !IsClosed(triangles))
  {
    return;
  }
  // Six times the volume of each part.
  std::vector<std::uint32_t> parents(this->Places.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (const Triangle& t : triangles)
  {
    parents[FindRoot(parents, t[1])] = FindRoot(parents, t[0]);
    parents[FindRoot(parents, t[2])] = FindRoot(parents, t[0]);
  }
  const auto corners = [this](const Triangle& t)
  {
    std::array<Point, 3> at{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Small& place = this->Places[t[i]];
      at[i] = { place[0], place[1], place[2] };
    }
    return at;
  };
  std::vector<double> volumes(this->Places.size());
  for (const Triangle& t : triangles)
  {
    const auto at = corners(t);
    volumes[FindRoot(parents, t[0])] +=
      GetDeterminant(ToVector(at[0]), ToVector(at[1]), ToVector(at[2]));
  }
  this->Solid =
    std::all_of(volumes.begin(), volumes.end(), [](double volume) { return volume >= 0; });
  if (this->Solid)
  {
    const auto ancestors = this->Chooser.GetTree().FindAncestors(
      this->Chooser.GetTree().CountMergesForPoints(HullPoints));
    for (Triangle t : triangles)
    {
      if (Simplify(t, ancestors))
      {
        this->Hull.push_back(corners(t));
      }
    }
  }
}

//------------------------------------------------------------------------------
bool SurfaceDetail::IsInside(const Point& place) const
{
  const glm::dvec3 from = ToVector(place) - ToVector(this->Middle);
  double sum = 0;
  for (const auto& triangle : this->Hull)
  {
    sum += GetSolidAngle(triangle, from);
  }
  // 4 pi inside and 0 outside, and in between near the triangles. Not a number counts as inside.
  return !this->Hull.empty() && !(std::abs(sum) < std::numbers::pi);
}

//------------------------------------------------------------------------------
std::vector<float> SurfaceDetail::Weigh(const SurfaceDetailView& view) const
{
  if (!(this->Size > 0) || !(view.Scale > 0))
  {
    return std::vector<float>(this->Places.size(), 0);
  }
  const DetailWeights weights(view.View, this->Size);
  const bool hidesBack =
    view.CullsBackFaces || (view.IsOpaque && this->Solid && !this->IsInside(weights.GetEye()));
  const auto place = [this](std::size_t i) { return this->Restore(this->Places[i]); };
  const auto share = [&](std::size_t i)
  {
    const Small& n = this->Normals[i];
    return view.Scale *
      Face(
        { n[0], n[1], n[2] }, ToVector(weights.GetWay(place(i))), hidesBack, view.CullsFrontFaces);
  };
  return weights.GetAll(this->Places.size(), place, share);
}

//------------------------------------------------------------------------------
double SurfaceDetail::BoundWeights(const SurfaceDetailView& view) const
{
  if (!(this->Size > 0) || !(view.Scale > 0))
  {
    return 0;
  }
  const DetailWeights distances(view.View, this->Size);
  const double reach = this->Size / std::sqrt(static_cast<double>(this->Places.size()));
  double most = 0;
  for (const Small& small : this->Places)
  {
    const Point place = this->Restore(small);
    Bounds box;
    for (std::size_t c = 0; c < 3 && std::isfinite(place[c]); ++c)
    {
      box[c] = { place[c] - reach, place[c] + reach };
    }
    most = std::max(most, double{ distances.Get(box) });
  }
  return view.Scale * most;
}
}
