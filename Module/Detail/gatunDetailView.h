// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunDetailView_h
#define gatunDetailView_h

#include "gatunRayTable.h"
#include "gatunRayView.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/** Requirements of an image for a mesh. */
struct DetailView
{
  RayView View; ///< for the coordinates of the mesh, with a ray for each pixel

  /** The largest error of the shape and the values, relative to the size of the mesh and the range
   * of the values, times the size in pixels where it is; 0 or more. */
  double PixelError = 0;

  /** Colors and opacities of values. Null: all values are visible. */
  std::shared_ptr<const RayTable> Table;

  bool operator==(const DetailView& other) const
  {
    return this->View == other.View && this->PixelError == other.PixelError &&
      (this->Table == other.Table || (this->Table && other.Table && *this->Table == *other.Table));
  }
};

/** A level of detail: uniform, or finer where a view needs it. */
struct DetailRequest
{
  /** The approximate number of remaining points; fewer where the pixel error of the view allows
   * it. */
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
