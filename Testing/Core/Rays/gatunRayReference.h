// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayReference_h
#define gatunRayReference_h

// Ray casting as its definition says, in double precision and without any cleverness: for each ray
// all tetrahedra, sorted, and the integral in thin slices. Shares nothing with the ray caster but
// the numbers that describe a view.

#include "gatunRayTable.h"
#include "gatunRayView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace gatun::test
{
using Vec = std::array<double, 3>;

inline Vec operator+(const Vec& a, const Vec& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Vec operator-(const Vec& a, const Vec& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Vec operator*(double f, const Vec& a)
{
  return { f * a[0], f * a[1], f * a[2] };
}

inline double Dot(const Vec& a, const Vec& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec Cross(const Vec& a, const Vec& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline Vec Normalize(const Vec& a)
{
  return 1 / std::sqrt(Dot(a, a)) * a;
}

/** Somebody who looks at a mesh. */
struct Viewer
{
  Vec Eye{};
  Vec Forward{ 0, 0, -1 };
  Vec Right{ 1, 0, 0 };
  Vec Up{ 0, 1, 0 };
  RayFrustum Frustum;
  int Width = 96;
  int Height = 80;
  double SampleDistance = 0.1;

  /** Towards a point, with the image's height in world units there. */
  static Viewer LookAt(const Vec& eye, const Vec& at, bool parallel, double height)
  {
    Viewer v;
    v.Eye = eye;
    v.Forward = Normalize(at - eye);
    const Vec helper = std::abs(v.Forward[1]) < 0.9 ? Vec{ 0, 1, 0 } : Vec{ 1, 0, 0 };
    v.Right = Normalize(Cross(v.Forward, helper));
    v.Up = Cross(v.Right, v.Forward);
    v.Frustum.Parallel = parallel;
    const double half = height / 2 / (parallel ? 1 : std::sqrt(Dot(at - eye, at - eye)));
    v.Frustum.Top = half;
    v.Frustum.Bottom = -half;
    v.Frustum.Right = half * v.Width / v.Height;
    v.Frustum.Left = -v.Frustum.Right;
    return v;
  }

  RayView GetView() const
  {
    const auto row = [&](const Vec& axis) {
      return std::array<double, 4>{ axis[0], axis[1], axis[2], -Dot(axis, this->Eye) };
    };
    return RayView({ row(this->Right), row(this->Up), row(-1 * this->Forward) }, this->Frustum,
      this->Width, this->Height, this->SampleDistance);
  }
};

/** A mesh with values at its points. */
struct ReferenceMesh
{
  std::vector<Vec> Points;
  std::vector<double> Values;
  std::vector<std::array<std::uint32_t, 4>> Tets;
};

/** Premultiplied red, green, blue; opacity; distance where something is seen first, or infinity;
 * the same if rounding decides whether the ray meets a tetrahedron, or sees anything of it. */
using ReferencePixel = std::array<double, 6>;

class Reference
{
public:
  RayMode Mode = RayMode::Composite;
  RayColor Color;
  std::vector<double> Breaks; // values where colors have steps or kinks, in order
  double Unit = 1;
  std::vector<std::array<double, 4>> Planes; // only what is on their positive side is seen

  /** Brings a color into the light that falls on a tetrahedron with such a gradient. */
  std::function<Vec(const Vec& color, const Vec& gradient, const Vec& middle)> Shade;

  std::vector<ReferencePixel> Render(const ReferenceMesh& mesh, const Viewer& viewer) const
  {
    std::vector<std::vector<Interval>> intervals(
      static_cast<std::size_t>(viewer.Width) * static_cast<std::size_t>(viewer.Height));
    for (const auto& tet : mesh.Tets)
    {
      const auto [x0, y0, x1, y1] = GetPixels(mesh, tet, viewer);
      for (int y = y0; y <= y1; ++y)
      {
        for (int x = x0; x <= x1; ++x)
        {
          this->Intersect(
            mesh, tet, viewer, x, y, intervals[static_cast<std::size_t>(y * viewer.Width + x)]);
        }
      }
    }
    std::vector<ReferencePixel> image;
    for (auto& ofPixel : intervals)
    {
      image.push_back(this->Composite(ofPixel, viewer));
    }
    return image;
  }

private:
  struct Interval
  {
    double In, Out;             // distances
    double AtOrigin, PerLength; // the value along the ray
    Vec Gradient, Middle;
  };

  struct Ray
  {
    Vec Origin, Direction;
  };

  /** The pixels that a tetrahedron may cover, with some to spare: first and last x and y. */
  static std::array<int, 4> GetPixels(
    const ReferenceMesh& mesh, const std::array<std::uint32_t, 4>& tet, const Viewer& v)
  {
    const auto& f = v.Frustum;
    const double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 4> box{ infinity, infinity, -infinity, -infinity };
    const auto isBehind = [&](std::uint32_t corner)
    { return Dot(mesh.Points[corner] - v.Eye, v.Forward) < 0; };
    if (std::all_of(tet.begin(), tet.end(), isBehind))
    {
      return { 0, 0, -1, -1 };
    }
    for (const auto corner : tet)
    {
      const Vec p = mesh.Points[corner] - v.Eye;
      const double depth = f.Parallel ? 1 : Dot(p, v.Forward);
      if (!(depth > 1e-9))
      {
        return { 0, 0, v.Width - 1, v.Height - 1 };
      }
      const double x = (Dot(p, v.Right) / depth - f.Left) / (f.Right - f.Left) * v.Width;
      const double y = (Dot(p, v.Up) / depth - f.Bottom) / (f.Top - f.Bottom) * v.Height;
      box = { std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y) };
    }
    const auto toPixel = [](double x, int size)
    { return static_cast<int>(std::clamp(x, -1.0, size + 1.0)); };
    return { std::max(0, toPixel(box[0] - 1, v.Width)), std::max(0, toPixel(box[1] - 1, v.Height)),
      std::min(v.Width - 1, toPixel(box[2] + 1, v.Width)),
      std::min(v.Height - 1, toPixel(box[3] + 1, v.Height)) };
  }

  static Ray GetRay(const Viewer& v, int x, int y)
  {
    const auto& f = v.Frustum;
    const double u = f.Left + (x + 0.5 + RayView::OffsetX) * (f.Right - f.Left) / v.Width;
    const double w = f.Bottom + (y + 0.5 + RayView::OffsetY) * (f.Top - f.Bottom) / v.Height;
    const Vec aside = u * v.Right + w * v.Up;
    return f.Parallel ? Ray{ v.Eye + aside, v.Forward }
                      : Ray{ v.Eye, Normalize(v.Forward + aside) };
  }

  /** Cuts an interval by where a linear function (value at the origin, slope) is positive. */
  static void Cut(Interval& i, double value, double slope)
  {
    if (slope > 0)
    {
      i.In = std::max(i.In, -value / slope);
    }
    else if (slope < 0)
    {
      i.Out = std::min(i.Out, -value / slope);
    }
    else if (value < 0)
    {
      i.Out = -1;
    }
  }

  void Intersect(const ReferenceMesh& mesh, const std::array<std::uint32_t, 4>& tet,
    const Viewer& v, int x, int y, std::vector<Interval>& intervals) const
  {
    const Ray ray = GetRay(v, x, y);
    const double perDepth = 1 / Dot(ray.Direction, v.Forward);
    Interval interval{ std::max(0.0, v.Frustum.Near * perDepth), v.Frustum.Far * perDepth, 0, 0, {},
      {} };
    for (const auto& plane : this->Planes)
    {
      const Vec n{ plane[0], plane[1], plane[2] };
      Cut(interval, Dot(n, ray.Origin) + plane[3], Dot(n, ray.Direction));
    }
    for (unsigned corner = 0; corner < 4; ++corner)
    {
      const Vec& apex = mesh.Points[tet[corner]];
      const Vec& a = mesh.Points[tet[(corner + 1) % 4]];
      const Vec& b = mesh.Points[tet[(corner + 2) % 4]];
      const Vec& c = mesh.Points[tet[(corner + 3) % 4]];
      const Vec n = Cross(b - a, c - a);
      const double height = Dot(n, apex - a);
      if (!(height != 0))
      {
        return; // flat
      }
      // The barycentric coordinate of the corner, along the ray.
      const double value = Dot(n, ray.Origin - a) / height;
      const double slope = Dot(n, ray.Direction) / height;
      Cut(interval, value, slope);
      interval.AtOrigin += value * mesh.Values[tet[corner]];
      interval.PerLength += slope * mesh.Values[tet[corner]];
      interval.Gradient = interval.Gradient + mesh.Values[tet[corner]] / height * n;
      interval.Middle = interval.Middle + 0.25 * apex;
    }
    // Also what a ray misses by no more than rounding; see Composite.
    if (interval.In < interval.Out + 1e-5)
    {
      intervals.push_back(interval);
    }
  }

  /** The sums of a ray. */
  struct Sum
  {
    ReferencePixel Pixel{ 0, 0, 0, 0, std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::infinity() };
    double Through = 1;
    double Depth = 0;
    double Largest = -std::numeric_limits<double>::infinity();
  };

  /** Color times extinction, and extinction. */
  std::array<double, 4> GetEmission(const Interval& interval, double distance) const
  {
    auto color = this->Color(interval.AtOrigin + distance * interval.PerLength);
    const double extinction = -std::log1p(-std::min(color[3], 1 - 1e-7)) / this->Unit;
    if (this->Shade)
    {
      const Vec shaded =
        this->Shade({ color[0], color[1], color[2] }, interval.Gradient, interval.Middle);
      std::copy(shaded.begin(), shaded.end(), color.begin());
    }
    return { color[0] * extinction, color[1] * extinction, color[2] * extinction, extinction };
  }

  /** Adds a slice in which color and extinction are constant. */
  void AddSlice(const std::array<double, 4>& emission, double length, Sum& sum) const
  {
    const double depth = emission[3] * length;
    const double opacity = -std::expm1(-depth);
    const double weight = this->Mode == RayMode::XRay ? depth : sum.Through * opacity;
    for (std::size_t c = 0; c < 3 && depth > 0; ++c)
    {
      sum.Pixel[c] += weight * emission[c] / emission[3];
    }
    sum.Through *= 1 - opacity;
    sum.Depth += depth;
  }

  /** Adds a part of a ray on which the color is smooth, in slices that are thin enough. */
  void AddSmooth(const Interval& interval, double begin, double end, Sum& sum) const
  {
    double largest = 0;
    for (int i = 0; i < 8; ++i)
    {
      largest =
        std::max(largest, this->GetEmission(interval, begin + (end - begin) * (i + 0.5) / 8)[3]);
    }
    const int slices = static_cast<int>(std::clamp(32 * largest * (end - begin), 6.0, 2e4));
    const double length = (end - begin) / slices;
    const double before = sum.Through;
    double seen = std::numeric_limits<double>::infinity();
    for (int i = 0; i < slices && (sum.Through > 1e-9 || this->Mode == RayMode::XRay); ++i)
    {
      // The mean by Gauss's rule with two points.
      const double from = begin + i * length;
      const double aside = std::sqrt(1.0 / 12) * length;
      auto mean = this->GetEmission(interval, from + length / 2 - aside);
      const auto other = this->GetEmission(interval, from + length / 2 + aside);
      for (std::size_t c = 0; c < 4; ++c)
      {
        mean[c] = (mean[c] + other[c]) / 2;
      }
      this->AddSlice(mean, length, sum);
      seen = std::min(seen, sum.Through < before ? from : seen);
    }
    // What a number in single precision does not show is not seen.
    if (sum.Through < (1 - 6e-8) * before && this->Mode != RayMode::XRay)
    {
      sum.Pixel[4] = std::min(sum.Pixel[4], seen);
    }
    // A ray within rounding of an edge may or may not meet the tetrahedron, of which it sees
    // nothing.
    if (sum.Through < (1 - 1e-5) * before && this->Mode != RayMode::XRay)
    {
      sum.Pixel[5] = std::min(sum.Pixel[5], seen);
    }
  }

  /** Integrates along a ray within a tetrahedron. */
  void Integrate(const Interval& interval, Sum& sum) const
  {
    std::vector<double> cuts{ interval.In, interval.Out };
    for (const double value : this->Breaks)
    {
      const double where = (value - interval.AtOrigin) / interval.PerLength;
      if (where > interval.In && where < interval.Out)
      {
        cuts.push_back(where);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
      this->AddSmooth(interval, cuts[i - 1], cuts[i], sum);
    }
  }

  ReferencePixel Composite(std::vector<Interval>& intervals, const Viewer& v) const
  {
    std::sort(intervals.begin(), intervals.end(),
      [](const Interval& a, const Interval& b) { return a.In < b.In; });
    Sum sum;
    double missed = std::numeric_limits<double>::infinity();
    for (const Interval& interval : intervals)
    {
      if (!(interval.In < interval.Out))
      {
        missed = std::min(missed, interval.In);
        continue;
      }
      const auto getValue = [&](double distance)
      { return interval.AtOrigin + distance * interval.PerLength; };
      if (this->Mode == RayMode::Maximum)
      {
        sum.Largest = std::max({ sum.Largest, getValue(interval.In), getValue(interval.Out) });
      }
      else if (this->Mode != RayMode::Sampled)
      {
        const double before = sum.Through;
        this->Integrate(interval, sum);
        missed = sum.Through < (1 - 6e-8) * before ? missed : std::min(missed, interval.In);
      }
      else
      {
        const double end = std::ceil(interval.Out / v.SampleDistance);
        for (double k = std::ceil(interval.In / v.SampleDistance); k < end; ++k)
        {
          const double distance = k * v.SampleDistance;
          const auto emission = this->GetEmission(interval, distance);
          this->AddSlice(emission, v.SampleDistance, sum);
          sum.Pixel[4] = std::min(sum.Pixel[4], emission[3] > 0 ? distance : sum.Pixel[4]);
        }
      }
    }
    auto& [pixel, through, depth, largest] = sum;
    pixel[3] = 1 - through;
    if (this->Mode == RayMode::XRay && depth > 0)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        pixel[c] *= pixel[3] / depth;
      }
    }
    if (this->Mode == RayMode::Maximum)
    {
      pixel = { 0, 0, 0, 0, std::numeric_limits<double>::infinity() };
      if (std::isfinite(largest))
      {
        const auto [r, g, b, a] = this->Color(largest);
        pixel = { r * a, g * a, b * a, a, pixel[4] };
      }
    }
    if (this->Mode != RayMode::Composite)
    {
      pixel[5] = pixel[4];
    }
    else if (missed < pixel[4])
    {
      pixel[5] = missed;
    }
    return pixel;
  }
};
}

#endif
