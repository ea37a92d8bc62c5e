// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunDetailView_h
#define gatunDetailView_h

#include "gatunRayTable.h"
#include "gatunRayView.h"
#include "gatunTypes.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace gatun
{
/** A sphere in the coordinates of a mesh. */
struct DetailSphere
{
  std::array<double, 3> Center{};
  double Radius = 0;

  bool operator==(const DetailSphere&) const = default;
};

/** Places that are not simplified: those in the box or the sphere, and those with such a value. */
struct DetailRegion
{
  std::optional<Bounds> Box;
  std::optional<DetailSphere> Sphere;
  std::optional<Range> Values;

  bool operator==(const DetailRegion&) const = default;
};

/** What an image needs of a mesh. */
struct DetailView
{
  RayView View; ///< for the coordinates of the mesh, with a ray for each pixel

  /** The largest error of the shape and the values, relative to the size of the mesh and the range
   * of the values, times the size in pixels where it is; 0 or more. */
  double PixelError = 0;

  DetailRegion Region;

  /** Colors and opacities of values. Null: all values are visible. */
  std::shared_ptr<const RayTable> Table;

  bool operator==(const DetailView& other) const
  {
    return this->View == other.View && this->PixelError == other.PixelError &&
      this->Region == other.Region &&
      (this->Table == other.Table || (this->Table && other.Table && *this->Table == *other.Table));
  }
};

/** A level of detail: the same everywhere, or finer where a view needs it. */
struct DetailRequest
{
  /** The number of points that are left, about; fewer where the pixel error of the view allows it.
   */
  std::uint64_t Points = 0;

  std::shared_ptr<const DetailView> View; ///< null: the same everywhere

  bool operator==(const DetailRequest& other) const
  {
    return this->Points == other.Points &&
      (this->View == other.View || (this->View && other.View && *this->View == *other.View));
  }
};
}

#endif
