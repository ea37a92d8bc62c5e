// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFraming.h"

#include "gatunVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gatun
{
namespace
{
using Point = PointBlocks::Point;
using Function = std::function<double(const Point&)>;

// The eye stays outside of the object by this part of its diagonal.
constexpr double LeastGap = 0.02;

// Halvings of the interval in which the eye is moved to center the image.
constexpr int CenteringRounds = 10;

double GetLargestOfCorners(const Bounds& box, const Function& function)
{
  double largest = -std::numeric_limits<double>::infinity();
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    Point point{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] = ((corner >> axis) & 1u) ? box[axis].Max : box[axis].Min;
    }
    largest = std::max(largest, function(point));
  }
  return largest;
}

bool IsPoint(const Bounds& box)
{
  return std::all_of(
    box.begin(), box.end(), [](const Range& range) { return range.Min == range.Max; });
}

Point GetMiddle(const Bounds& box)
{
  Point middle{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = box[axis].Min / 2 + box[axis].Max / 2;
  }
  return middle;
}

/** Coordinates along the axes of a view, from a point in the middle, where little is rounded. */
class Axes
{
public:
  Axes(const FramingView& view, const Point& middle)
    : Right(ToVector(view.Right))
    , Up(ToVector(view.Up))
    , Back(ToVector(view.Back))
    , Middle(ToVector(middle))
  {
  }

  glm::dvec3 Get(const Point& point) const
  {
    const glm::dvec3 from = ToVector(point) - this->Middle;
    return { glm::dot(this->Right, from), glm::dot(this->Up, from), glm::dot(this->Back, from) };
  }

  Point ToWorld(const glm::dvec3& place) const
  {
    return ToArray(
      this->Middle + place.x * this->Right + place.y * this->Up + place.z * this->Back);
  }

private:
  glm::dvec3 Right, Up, Back, Middle;
};

/** The eye along one of the image's axes in a perspective projection. */
class PerspectiveSide
{
public:
  /** Axis: 0 across, 1 up. Slope: of the border that is to be reached. */
  PerspectiveSide(const PointBlocks& points, const Axes& axes, int axis, double slope)
    : Points(points)
    , Place(axes)
    , Axis(axis)
    , Slope(slope)
    , High(this->FindBorder(1))
    , Low(this->FindBorder(-1))
  {
  }

  /** The nearest depth from which everything is between the borders. */
  double GetNearestDepth() const { return (this->High + this->Low) / (2 * this->Slope); }

  /** Where the eye must be at a depth so that both margins are as wide. */
  double Center(double depth) const
  {
    double low = this->High - this->Slope * depth;
    double high = this->Slope * depth - this->Low;
    for (int round = 0; round < CenteringRounds && high - low > 1e-9 * std::abs(depth); ++round)
    {
      const double middle = (low + high) / 2;
      (this->FindReach(1, middle, depth) > this->FindReach(-1, middle, depth) ? low : high) =
        middle;
    }
    return (low + high) / 2;
  }

private:
  double FindBorder(double side) const
  {
    return this->Points.FindLargest(
      [&](const Point& point)
      {
        const glm::dvec3 at = this->Place.Get(point);
        return side * at[this->Axis] + this->Slope * at.z;
      });
  }

  double FindReach(double side, double eye, double depth) const
  {
    return this->Points.FindLargest(
      [&](const Point& point)
      {
        const glm::dvec3 at = this->Place.Get(point);
        // Corners of a box can be behind the eye, but no points are.
        return at.z < depth ? side * (at[this->Axis] - eye) / (depth - at.z)
                            : std::numeric_limits<double>::infinity();
      });
  }

  const PointBlocks& Points;
  const Axes& Place;
  int Axis;
  double Slope;
  double High;
  double Low;
};

/** The range of the points along an axis of a view. */
Range FindRange(const PointBlocks& points, const Axes& axes, int axis)
{
  return { -points.FindLargest([&](const Point& point) { return -axes.Get(point)[axis]; }),
    points.FindLargest([&](const Point& point) { return axes.Get(point)[axis]; }) };
}
}

//------------------------------------------------------------------------------
double GetPositiveDiagonal(const Bounds& box)
{
  // By two numbers at a time, std::hypot would need a later C library.
  const double diagonal =
    std::hypot(box[0].Max - box[0].Min, box[1].Max - box[1].Min, box[2].Max - box[2].Min);
  return diagonal > 0 && std::isfinite(diagonal) ? diagonal : 1;
}

//------------------------------------------------------------------------------
PointBlocks::PointBlocks(std::vector<Bounds> boxes, Visit visit)
  : Show(std::move(visit))
{
  for (std::size_t block = 0; block < boxes.size(); ++block)
  {
    if (!boxes[block].IsEmpty())
    {
      this->Box.Include(boxes[block]);
      this->Boxes.push_back(boxes[block]);
      this->Blocks.push_back(block);
    }
  }
}

//------------------------------------------------------------------------------
PointBlocks::PointBlocks(std::span<const Point> points)
{
  for (const Point& point : points)
  {
    Bounds box;
    box.Include(point);
    this->Box.Include(point);
    this->Boxes.push_back(box);
  }
}

//------------------------------------------------------------------------------
double PointBlocks::FindLargest(const Function& function) const
{
  std::vector<std::pair<double, std::size_t>> bounds;
  bounds.reserve(this->Boxes.size());
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    bounds.emplace_back(GetLargestOfCorners(this->Boxes[i], function), i);
  }
  std::sort(bounds.begin(), bounds.end(), [](const auto& a, const auto& b) { return a > b; });
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& [bound, i] : bounds)
  {
    if (!(bound > largest))
    {
      break; // no later block can reach farther
    }
    const bool isVisited = this->Show && !IsPoint(this->Boxes[i]) &&
      this->Show(
        this->Blocks[i], [&](const Point& point) { largest = std::max(largest, function(point)); });
    largest = isVisited ? largest : bound;
  }
  return largest;
}

//------------------------------------------------------------------------------
Framing FrameObject(const PointBlocks& points, const FramingView& view)
{
  Framing framing;
  if (points.IsEmpty())
  {
    return framing;
  }
  const double diagonal = GetPositiveDiagonal(points.GetBounds());
  const Axes axes(view, GetMiddle(points.GetBounds()));
  const Range depths = FindRange(points, axes, 2);
  const double slope = FramingFill * view.TangentOfHalfAngle;
  glm::dvec3 eye(0);
  if (view.IsParallel)
  {
    const Range across = FindRange(points, axes, 0);
    const Range up = FindRange(points, axes, 1);
    const double half =
      std::max((up.Max - up.Min) / 2, (across.Max - across.Min) / 2 / view.Aspect);
    eye = { (across.Min + across.Max) / 2, (up.Min + up.Max) / 2, 0 };
    framing.ParallelScale = (half > 0 ? half : diagonal / 2) / FramingFill;
    eye.z = std::max(depths.Max + LeastGap * diagonal,
      (depths.Min + depths.Max) / 2 + framing.ParallelScale / view.TangentOfHalfAngle);
  }
  else
  {
    const PerspectiveSide across(points, axes, 0, slope * view.Aspect);
    const PerspectiveSide up(points, axes, 1, slope);
    eye.z = std::max({ across.GetNearestDepth(), up.GetNearestDepth(),
      depths.Max + (depths.Max > depths.Min ? LeastGap * diagonal : 1e-6 * diagonal) });
    if (IsPoint(points.GetBounds()))
    {
      eye.z = depths.Max + diagonal / slope;
    }
    eye.x = across.Center(eye.z);
    eye.y = up.Center(eye.z);
  }
  const double focus = (depths.Min + depths.Max) / 2;
  framing.FocalPoint = axes.ToWorld({ eye.x, eye.y, focus });
  framing.Distance = eye.z - focus;
  framing.ParallelScale =
    view.IsParallel ? framing.ParallelScale : framing.Distance * view.TangentOfHalfAngle;
  return framing;
}

//------------------------------------------------------------------------------
Framing FrameAround(
  const PointBlocks& points, const std::array<double, 3>& middle, const FramingView& view)
{
  Framing framing;
  framing.FocalPoint = middle;
  if (points.IsEmpty())
  {
    return framing;
  }
  const double diagonal = GetPositiveDiagonal(points.GetBounds());
  double distance = 0;
  double scale = 0;
  const Axes axes(view, middle);
  for (const int axis : { 0, 1 })
  {
    const double width = FramingFill * (axis == 0 ? view.Aspect : 1);
    const double slope = width * view.TangentOfHalfAngle;
    for (const double side : { -1, 1 })
    {
      const auto find = [&](double perDepth, double perWidth)
      {
        return points.FindLargest(
          [&](const Point& point)
          {
            const glm::dvec3 at = axes.Get(point);
            return perWidth * side * at[axis] + perDepth * at.z;
          });
      };
      if (view.IsParallel)
      {
        scale = std::max(scale, find(0, 1 / width));
      }
      distance = std::max(distance, find(1, view.IsParallel ? 0 : 1 / slope));
    }
  }
  distance = std::max(distance, FindRange(points, axes, 2).Max + LeastGap * diagonal);
  if (!view.IsParallel)
  {
    scale = distance * view.TangentOfHalfAngle;
  }
  framing.ParallelScale = scale > 0 ? scale : diagonal;
  framing.Distance =
    IsPoint(points.GetBounds()) ? std::max(distance, diagonal / view.TangentOfHalfAngle) : distance;
  return framing;
}
}
