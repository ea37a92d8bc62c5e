// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFraming_h
#define gatunFraming_h

// Cameras from which an object just fits into the image.

#include "gatunExport.h"
#include "gatunTypes.h"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** The length of the diagonal of a box, or 1 if that is 0 or not finite. */
GATUN_EXPORT double GetPositiveDiagonal(const Bounds& box);

/**
 * Points in blocks, for a search of extremes. Only blocks whose boxes reach far enough are visited.
 */
class GATUN_EXPORT PointBlocks
{
public:
  using Point = std::array<double, 3>;
  using Use = std::function<void(const Point&)>;

  /** Calls use for all points of a block, and returns true; or returns false if they are not
   * available. The box then takes their place. */
  using Visit = std::function<bool(std::size_t block, const Use& use)>;

  /** Boxes: of the blocks. Blocks without points are left out. */
  explicit PointBlocks(std::vector<Bounds> boxes, Visit visit = {});

  /** Points without blocks. */
  explicit PointBlocks(std::span<const Point> points);

  /** Whether there is no point. */
  bool IsEmpty() const { return this->Box.IsEmpty(); }

  const Bounds& GetBounds() const { return this->Box; }

  /** The largest value of a function at the points, and never less. Over a box, the function must
   * be largest at a corner, as linear and projective functions are. */
  double FindLargest(const std::function<double(const Point&)>& function) const;

private:
  std::vector<Bounds> Boxes;
  std::vector<std::size_t> Blocks; // the blocks that the boxes belong to
  Visit Show;
  Bounds Box;
};

/** A camera without its place. */
struct FramingView
{
  using Vector = std::array<double, 3>;

  // Of length 1 and orthogonal to each other.
  Vector Right{ 1, 0, 0 };
  Vector Up{ 0, 1, 0 };
  Vector Back{ 0, 0, 1 }; ///< towards the eye

  bool IsParallel = false;
  double TangentOfHalfAngle = 0.268; ///< of the vertical view angle
  double Aspect = 1;                 ///< width by height of the image
};

/** The place of a camera. */
struct Framing
{
  std::array<double, 3> FocalPoint{}; ///< in the middle of the image
  double Distance = 1;                ///< of the eye from it
  double ParallelScale = 1;           ///< half the height of what a parallel projection shows
};

/** The filled fraction of the image along the axis that limits the size. */
constexpr double FramingFill = 0.94;

/** The place from which the points just fit into the image, with a small margin and in its middle.
 * A lone point, or none, is seen from some distance. */
GATUN_EXPORT Framing FrameObject(const PointBlocks& points, const FramingView& view);

/** The same with a given point in the middle. */
GATUN_EXPORT Framing FrameAround(
  const PointBlocks& points, const std::array<double, 3>& middle, const FramingView& view);
}

#endif
