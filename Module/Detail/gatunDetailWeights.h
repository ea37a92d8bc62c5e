// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDetailWeights_h
#define gatunDetailWeights_h

#include "gatunExport.h"
#include "gatunParallel.h"
#include "gatunRayView.h"
#include "gatunTypes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace gatun
{
/** The length of the diagonal of a box, in which axes without extent do not count; 0 if it is
 * empty.
 */
GATUN_EXPORT double GetDiagonal(const Bounds& box);

/**
 * Weight of the error of a merge at a place, for a view: the length of an object in pixels, if it
 * were there. It is 0 outside of the view, and falls to 0 over a tenth of the size of the object,
 * because simplified meshes with sharp changes of detail need many more tetrahedra.
 *
 * Distances are those from the plane of the eye. Places nearer than the near clipping plane, or a
 * thousandth of the size of the object, count as if they were there.
 */
class GATUN_EXPORT DetailWeights
{
public:
  using Point = std::array<double, 3>;

  /** Size: a length of the object, such as the diagonal of its bounds; in world units, above 0. */
  DetailWeights(const RayView& view, double size);

  /** 0 or more. Of a point that is not finite: 0. */
  float Get(const Point& point) const;

  /** At least the weight of any point within a box; 0 if the box is empty. */
  float Get(const Bounds& box) const;

  /** The weights of many places. place(i): the point. share(i): the factor for errors there, 0
   * where nothing can be seen; asked only within the view. Both are called by several threads. */
  template <typename Place, typename Share>
  std::vector<float> GetAll(std::size_t count, const Place& place, const Share& share) const
  {
    std::vector<float> weights(count, 0);
    constexpr std::size_t run = 8192;
    ParallelFor((count + run - 1) / run,
      [&](std::size_t part)
      {
        for (auto i = part * run; i < std::min(count, (part + 1) * run); ++i)
        {
          const double weight = this->Get(place(i));
          weights[i] = weight > 0 ? static_cast<float>(weight * share(i)) : 0;
        }
      });
    return weights;
  }

  /** Where the eye is, or ray coordinates are 0. */
  const Point& GetEye() const { return this->Eye; }

  /** From a place towards the eye. */
  Point GetWay(const Point& place) const
  {
    const Point& to = this->Perspective ? this->Eye : this->Back;
    const Point& from = this->Perspective ? place : Point{};
    return { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  }

private:
  float Weigh(double depth, double outside) const;

  using Plane = std::array<double, 4>;

  std::vector<Plane> Sides; // of the view; distances in world units, inside above 0
  Plane Depth{};            // from the eye, in world units
  Point Eye{};
  Point Back{};     // against the rays of a parallel projection
  double Size;      // of the object
  double Scale = 0; // pixels for a world unit, at depth 1 in perspective
  double LeastDepth = 0;
  bool Perspective;
};
}

#endif
