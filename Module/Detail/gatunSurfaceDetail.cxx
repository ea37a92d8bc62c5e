// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Based on: Hugues Hoppe: View-dependent refinement of progressive meshes. SIGGRAPH 1997. David
// Luebke, Carl Erikson: View-dependent simplification of arbitrary polygonal environments. SIGGRAPH
// 1997. Adriaan van Oosterom, Jan Strackee: The solid angle of a plane triangle. IEEE Transactions
// on Biomedical Engineering, 1983.

#include "gatunSurfaceDetail.h"

#include "gatunDetailWeights.h"
#include "gatunError.h"
#include "gatunMergeSelection.h"
#include "gatunParallel.h"
#include "gatunTypes.h"

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
Point Subtract(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

template <typename A, typename B>
double Dot(const A& a, const B& b)
{
  return double{ a[0] } * double{ b[0] } + double{ a[1] } * double{ b[1] } +
    double{ a[2] } * double{ b[2] };
}

template <typename A>
double Norm(const A& a)
{
  return std::sqrt(Dot(a, a));
}

//------------------------------------------------------------------------------
/** Where the eye is, or which way rays go in a parallel projection. */
struct Eye
{
  Point Place{};
  Point Direction{}; // of length 1
  bool IsParallel;

  explicit Eye(const RayView& view)
    : IsParallel(!view.Perspective)
  {
    const auto row = [&](std::size_t i) {
      return Point{ view.ToRays[i][0], view.ToRays[i][1], view.ToRays[i][2] };
    };
    const std::array<Point, 3> crosses{ Cross(row(1), row(2)), Cross(row(2), row(0)),
      Cross(row(0), row(1)) };
    const double determinant = Dot(row(0), crosses[0]);
    const double length = Norm(crosses[2]) * (determinant < 0 ? -1 : 1);
    for (std::size_t c = 0; c < 3; ++c)
    {
      // By the rule of Cramer: where ray coordinates are 0, and along which the first two are.
      for (std::size_t i = 0; i < 3; ++i)
      {
        this->Place[c] -= crosses[i][c] * view.ToRays[i][3] / determinant;
      }
      this->Direction[c] = crosses[2][c] / length;
    }
  }

  /** From a place towards the eye. */
  Point GetWay(const Point& place) const
  {
    return this->IsParallel ? Point{ -this->Direction[0], -this->Direction[1], -this->Direction[2] }
                            : Subtract(this->Place, place);
  }
};

//------------------------------------------------------------------------------
/** Of the errors of a part of a surface, how much counts: 0 to 1. Normal: mean, shorter than 1 if
 * the part is bent. */
template <typename Normal>
double Face(const Normal& normal, const Point& way, bool hidesBack, bool hidesFront)
{
  const double length = Norm(normal);
  const double distance = Norm(way);
  if (!(length > 0) || !(distance > 0))
  {
    return 1;
  }
  const double angle = std::acos(std::clamp(Dot(normal, way) / (length * distance), -1.0, 1.0));
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
double GetSolidAngle(const std::array<Point, 3>& triangle, const Point& from)
{
  const Point a = Subtract(triangle[0], from);
  const Point b = Subtract(triangle[1], from);
  const Point c = Subtract(triangle[2], from);
  const double la = Norm(a);
  const double lb = Norm(b);
  const double lc = Norm(c);
  return -2 *
    std::atan2(
      Dot(a, Cross(b, c)), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
}
}

//------------------------------------------------------------------------------
SurfaceDetail::SurfaceDetail(std::shared_ptr<const MergeTree> tree,
  std::shared_ptr<const MergeDependencies> dependencies, std::span<const Point> places,
  std::span<const Triangle> triangles)
  : Tree(std::move(tree))
  , Dependencies(std::move(dependencies))
{
  const std::size_t count = this->Tree->GetNumberOfPoints();
  const bool fits = std::all_of(triangles.begin(), triangles.end(),
    [count](const Triangle& triangle)
    { return *std::max_element(triangle.begin(), triangle.end()) < count; });
  if (places.size() != count || !fits ||
    this->Dependencies->GetNumberOfMerges() != this->Tree->GetMerges().size())
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
    Point diagonal{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Middle[c] = 0.5 * box[c].Min + 0.5 * box[c].Max;
      diagonal[c] = box[c].Max - box[c].Min;
    }
    this->Size = Norm(diagonal);
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
    return Point{ place[0], place[1], place[2] };
  };
  for (const Triangle& t : triangles)
  {
    const Point first = at(t[0]);
    const Point normal = Cross(Subtract(at(t[1]), first), Subtract(at(t[2]), first));
    const double area = Norm(normal);
    if (!std::isfinite(area))
    {
      continue;
    }
    for (const std::uint32_t corner : t)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        this->Normals[corner][c] += static_cast<float>(normal[c]);
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
  for (const Merge& merge : this->Tree->GetMerges())
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
    volumes[FindRoot(parents, t[0])] += Dot(at[0], Cross(at[1], at[2]));
  }
  this->Solid =
    std::all_of(volumes.begin(), volumes.end(), [](double volume) { return volume >= 0; });
  if (this->Solid)
  {
    const auto ancestors = this->Tree->FindAncestors(this->Tree->CountMergesForPoints(HullPoints));
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
  const Point from = Subtract(place, this->Middle);
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
  std::vector<float> weights(this->Places.size(), 0);
  if (!(this->Size > 0) || !(view.Scale > 0))
  {
    return weights;
  }
  const DetailWeights distances(view.View, this->Size);
  const Eye eye(view.View);
  const bool hidesBack =
    view.CullsBackFaces || (view.IsOpaque && this->Solid && !this->IsInside(eye.Place));
  constexpr std::size_t run = 16384;
  ParallelFor(weights.size() / run + 1,
    [&](std::size_t part)
    {
      const std::size_t end = std::min(weights.size(), (part + 1) * run);
      for (std::size_t i = part * run; i < end; ++i)
      {
        const Point place = this->Restore(this->Places[i]);
        const double pixels = view.Scale * double{ distances.Get(place) };
        weights[i] = pixels > 0
          ? static_cast<float>(
              pixels * Face(this->Normals[i], eye.GetWay(place), hidesBack, view.CullsFrontFaces))
          : 0;
      }
    });
  return weights;
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

//------------------------------------------------------------------------------
MergeCut SurfaceDetail::Choose(const SurfaceDetailView& view, std::size_t first) const
{
  const MergeTree& tree = *this->Tree;
  const std::vector<float> weights = this->Weigh(view);
  const std::uint64_t all = tree.GetNumberOfPoints();
  const auto choose = [&](std::uint64_t points)
  {
    const double tolerance =
      points < all ? FindTolerance(tree, weights, static_cast<std::size_t>(all - points)) : 0;
    std::vector<bool> wanted = SelectMerges(tree, weights, std::max(tolerance, view.PixelError));
    std::fill_n(wanted.begin(), std::min(first, wanted.size()), true);
    return MergeCut(tree, *this->Dependencies, std::move(wanted));
  };
  MergeCut cut = choose(view.Points);
  const std::uint64_t left = all - cut.GetNumberOfMerges();
  if (view.Points < all && left > view.Points + view.Points / 20)
  {
    // Some that are wanted depend on others that are not.
    cut = choose(static_cast<std::uint64_t>(static_cast<double>(view.Points) *
      static_cast<double>(view.Points) / static_cast<double>(left)));
  }
  return cut;
}
}
