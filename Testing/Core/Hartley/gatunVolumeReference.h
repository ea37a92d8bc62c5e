// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunVolumeReference_h
#define gatunVolumeReference_h

// A regular volume, looked at the plain way: voxel by voxel, sample by sample. Slow, and
// independent of everything that it is compared with.

#include "gatunHartleyProjector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun::test
{
using Vector = HartleyView::Vector;

inline double InnerProduct(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector AddTimes(const Vector& a, double times, const Vector& b)
{
  return { a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2] };
}

/** The point that a pixel sees. */
inline Vector GetPixel(const HartleyView& view, double column, double row)
{
  return AddTimes(AddTimes(view.Origin, column, view.ColumnStep), row, view.RowStep);
}

/** Where along a ray samples lie, in steps: all integers from First up to, not including, End, from
 * Phase on. */
struct RaySamples
{
  double Phase = 0;
  std::int64_t First = 0;
  std::int64_t End = 0;
};

/** The part of a ray that is within a volume's hats, in steps; empty if Begin >= End. */
struct RayPart
{
  double Begin = 0;
  double End = 0;
};

/**
 * A volume of trilinear hats around the voxels of a box, in index coordinates of the volume that
 * the box was cut from, zero outside. Nothing changes it once it is made.
 */
class ReferenceVolume
{
public:
  using Triple = std::array<std::uint32_t, 3>;

  /** Voxels from first up to, not including, end, of values[x + size[0] * (y + size[1] * z)], each
   * less base. */
  template <typename Value>
  ReferenceVolume(
    const Value* values, const Triple& size, double base, const Triple& first, const Triple& end)
    : Base(base)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = static_cast<double>(first[axis]) - 1;
      this->High[axis] = end[axis];
      this->Stored[axis] = std::size_t{ end[axis] } - first[axis] + 2;
    }
    this->Voxels.resize(this->Stored[0] * this->Stored[1] * this->Stored[2]);
    for (std::uint32_t z = first[2]; z < end[2]; ++z)
    {
      for (std::uint32_t y = first[1]; y < end[1]; ++y)
      {
        const Value* const row = values + std::size_t{ size[0] } * (y + std::size_t{ size[1] } * z);
        double* const stored = &this->Voxels[1 +
          this->Stored[0] * (y - first[1] + 1 + this->Stored[1] * (z - first[2] + 1))];
        for (std::uint32_t x = first[0]; x < end[0]; ++x)
        {
          stored[x - first[0]] = static_cast<double>(row[x]) - base;
        }
      }
    }
  }

  /** All of a volume. */
  template <typename Value>
  ReferenceVolume(const Value* values, const Triple& size, double base)
    : ReferenceVolume(values, size, base, Triple{}, size)
  {
  }

  double GetBase() const { return this->Base; }

  Vector GetCenter() const
  {
    return { (this->Low[0] + this->High[0]) / 2, (this->Low[1] + this->High[1]) / 2,
      (this->Low[2] + this->High[2]) / 2 };
  }

  /** At a point; the voxels less the base. */
  double GetSample(const Vector& point) const
  {
    return this->Interpolate(point, [this](std::size_t i) { return this->Voxels[i]; });
  }

  /** The same of a volume of ones: how much of a voxel is at a point. */
  double GetWeight(const Vector& point) const
  {
    double weight = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      weight *= std::clamp(
        std::min(point[axis] - this->Low[axis], this->High[axis] - point[axis]), 0.0, 1.0);
    }
    return weight;
  }

  RayPart Clip(const Vector& point, const Vector& step) const
  {
    RayPart part{ -1e300, 1e300 };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::abs(step[axis]) < 1e-14)
      {
        if (point[axis] <= this->Low[axis] || point[axis] >= this->High[axis])
        {
          return {};
        }
        continue;
      }
      const double one = (this->Low[axis] - point[axis]) / step[axis];
      const double other = (this->High[axis] - point[axis]) / step[axis];
      part.Begin = std::max(part.Begin, std::min(one, other));
      part.End = std::min(part.End, std::max(one, other));
    }
    return part;
  }

  /** Samples a step apart, one of them on the plane through the center at right angles to the ray.
   */
  RaySamples GetSamples(const Vector& point, const Vector& step) const
  {
    const RayPart part = this->Clip(point, step);
    RaySamples samples;
    if (part.Begin < part.End)
    {
      samples.Phase =
        InnerProduct(AddTimes(this->GetCenter(), -1, point), step) / InnerProduct(step, step);
      samples.First = static_cast<std::int64_t>(std::ceil(part.Begin - samples.Phase));
      samples.End = static_cast<std::int64_t>(std::floor(part.End - samples.Phase)) + 1;
    }
    return samples;
  }

  /** The sum of the samples. */
  double SumSamples(const Vector& point, const Vector& step) const
  {
    const RaySamples samples = this->GetSamples(point, step);
    double sum = 0;
    for (std::int64_t i = samples.First; i < samples.End; ++i)
    {
      sum += this->GetSample(AddTimes(point, samples.Phase + static_cast<double>(i), step));
    }
    return sum;
  }

  /** The line integral, by which a step counts as 1. Exact: between two planes of voxels a
   * trilinear function is cubic along a line, and two points of Gauss integrate that. */
  double Integrate(const Vector& point, const Vector& step) const
  {
    return this->IntegrateOf(point, step, [this](const Vector& p) { return this->GetSample(p); });
  }

  /** The same of a volume of ones. */
  double IntegrateWeight(const Vector& point, const Vector& step) const
  {
    return this->IntegrateOf(point, step, [this](const Vector& p) { return this->GetWeight(p); });
  }

  /** Red, green and blue, times opacity, and opacity: the samples from front to back, voxel by
   * voxel. At the border, where only part of a voxel is, a sample counts for that part. Steps:
   * how many samples are taken where there would be one, each of that part of the opacity. */
  std::array<double, 4> Cast(
    const Vector& point, const Vector& step, const HartleyShading& shading, int steps = 1) const
  {
    const Vector fine{ step[0] / steps, step[1] / steps, step[2] / steps };
    const RaySamples samples = this->GetSamples(point, fine);
    std::array<double, 4> out{};
    for (std::int64_t i = samples.First; i < samples.End; ++i)
    {
      const Vector place = AddTimes(point, samples.Phase + static_cast<double>(i), fine);
      const double weight = this->GetWeight(place);
      if (weight <= 0)
      {
        continue;
      }
      const double density = this->Base + this->GetSample(place) / weight;
      const auto [red, green, blue, opacity] = Shade(shading, density);
      const double part = 1 - std::pow(1 - opacity, weight / steps);
      const double seen = (1 - out[3]) * part;
      out[0] += seen * red;
      out[1] += seen * green;
      out[2] += seen * blue;
      out[3] += seen;
    }
    return out;
  }

  /** Color and opacity of one sample. */
  static std::array<double, 4> Shade(const HartleyShading& shading, double density)
  {
    const auto last = static_cast<double>(shading.Table.size() - 1);
    const double place =
      std::clamp((density - shading.First) / (shading.Last - shading.First) * last, 0.0, last);
    const auto low = std::min(static_cast<std::size_t>(place), shading.Table.size() - 2);
    const double part = place - static_cast<double>(low);
    std::array<double, 4> found{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      found[i] = (1 - part) * shading.Table[low][i] + part * shading.Table[low + 1][i];
    }
    if (shading.OpacityModel == HartleyOpacityModel::Exponential)
    {
      found[3] = 1 - std::exp(-shading.Extinction * std::max(0.0, density - shading.Zero));
    }
    return found;
  }

private:
  template <typename Get>
  double Interpolate(const Vector& point, const Get& get) const
  {
    std::array<std::size_t, 3> cell{};
    std::array<double, 3> part{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double place = point[axis] - this->Low[axis];
      if (!(place > 0 && point[axis] < this->High[axis]))
      {
        return 0;
      }
      // A point a hair before the end may be rounded to the end itself.
      cell[axis] = std::min(static_cast<std::size_t>(place), this->Stored[axis] - 2);
      part[axis] = place - static_cast<double>(cell[axis]);
    }
    const std::size_t dy = this->Stored[0];
    const std::size_t dz = this->Stored[0] * this->Stored[1];
    const std::size_t i = cell[0] + dy * cell[1] + dz * cell[2];
    const auto alongX = [&](std::size_t from)
    { return (1 - part[0]) * get(from) + part[0] * get(from + 1); };
    const double front = (1 - part[1]) * alongX(i) + part[1] * alongX(i + dy);
    const double back = (1 - part[1]) * alongX(i + dz) + part[1] * alongX(i + dz + dy);
    return (1 - part[2]) * front + part[2] * back;
  }

  template <typename Get>
  double IntegrateOf(const Vector& point, const Vector& step, const Get& get) const
  {
    const RayPart ray = this->Clip(point, step);
    if (!(ray.Begin < ray.End))
    {
      return 0;
    }
    // Of each axis, where the next plane of voxels is met, and how far it is from one to the next.
    Vector next{}, apart{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::abs(step[axis]) < 1e-14)
      {
        next[axis] = apart[axis] = 1e300;
        continue;
      }
      const double place = point[axis] + ray.Begin * step[axis];
      // A plane that is met at once does no harm: it only makes an empty piece.
      const double plane = step[axis] > 0 ? std::ceil(place) : std::floor(place);
      next[axis] = (plane - point[axis]) / step[axis];
      apart[axis] = 1 / std::abs(step[axis]);
    }
    const double gauss = 1 / std::sqrt(3.0);
    double sum = 0;
    for (double from = ray.Begin; from < ray.End;)
    {
      const auto axis =
        static_cast<std::size_t>(std::min_element(next.begin(), next.end()) - next.begin());
      const double to = std::min(next[axis], ray.End);
      if (to > from)
      {
        const double middle = (from + to) / 2;
        const double half = (to - from) / 2;
        sum += half *
          (get(AddTimes(point, middle - gauss * half, step)) +
            get(AddTimes(point, middle + gauss * half, step)));
        from = to;
      }
      next[axis] += apart[axis];
    }
    return sum;
  }

  double Base;
  Vector Low{}, High{}; ///< where the hats begin and end
  std::array<std::size_t, 3> Stored{};
  std::vector<double> Voxels; ///< with a border of zeros
};

/**
 * The view of a volume that was turned about x, then y, then z, by angles in units of pi, and is
 * looked at along z; the middle of the image sees the volume's middle. Scale: pixels a voxel.
 */
inline HartleyView MakeTurnedView(
  const ReferenceVolume::Triple& size, const Vector& turns, unsigned pixels, double scale)
{
  const double pi = 3.14159265358979323846;
  // Rows of the matrix that turns the volume are the image's axes, seen from the volume.
  std::array<Vector, 3> axes{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  for (std::size_t about = 3; about-- > 0;)
  {
    const double c = std::cos(pi * turns[about]);
    const double s = std::sin(pi * turns[about]);
    const std::size_t a = (about + 1) % 3;
    const std::size_t b = (about + 2) % 3;
    for (Vector& axis : axes)
    {
      const double x = axis[a];
      const double y = axis[b];
      axis[a] = c * x + s * y;
      axis[b] = c * y - s * x;
    }
  }
  for (Vector& axis : axes)
  {
    for (double& value : axis)
    {
      // Views along an axis are to be so exactly.
      value = std::abs(value - std::round(value)) < 1e-12 ? std::round(value) : value;
    }
  }
  HartleyView view;
  view.Width = view.Height = pixels;
  view.Step = axes[2];
  const double half = (pixels - 1) / 2.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    view.ColumnStep[axis] = axes[0][axis] / scale;
    view.RowStep[axis] = axes[1][axis] / scale;
    view.Origin[axis] =
      (size[axis] - 1) / 2.0 - half * (view.ColumnStep[axis] + view.RowStep[axis]);
  }
  return view;
}
}

#endif
