// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayTable_h
#define gatunRayTable_h

#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/** What becomes of the samples of a ray. */
enum class RayMode : std::uint8_t
{
  Composite, ///< colour and opacity, front to back
  Area,      ///< the same, with one sample for all that is between two faces
  Maximum,   ///< the sample with the largest value is seen
  XRay       ///< absorption adds up, whatever lies in front
};

/** Colour and opacity of a value: red, green, blue, and opacity over the unit distance; 0 to 1. */
using RayColour = std::function<std::array<double, 4>(double value)>;

/**
 * Colours of all values between two, with what is the same for all samples worked in. Between the
 * entries of the table, what it holds is linear.
 */
struct VTKGATUNCORE_EXPORT RayTable
{
  /** A cell: what it holds at its lower end, and how much more at the upper one.
   * Composite: (r a, g a, b a, -a), a the opacity of a sample; Maximum: the same with a that of a
   * unit. Area: (r, g, b, o), o the optical depth of a sample distance. XRay: (r o, g o, b o, o).
   */
  struct alignas(32) Cell
  {
    std::array<float, 4> Value, Change;

    bool operator==(const Cell&) const = default;
  };

  static constexpr int Size = 4096;

  /**
   * Range: the values that matter; those beyond look as its ends do. Opacities are over
   * unitDistance, in world units as sampleDistance.
   */
  RayTable(RayMode mode, const RayColour& colour, const Range& range, double sampleDistance,
    double unitDistance);

  /** Whether nothing is seen of values from one to another. */
  bool IsTransparent(const Range& values) const;

  bool operator==(const RayTable&) const = default;

  RayMode Mode;
  double Low = 0;                          ///< value at the beginning
  double Scale = 0;                        ///< cells a unit of value
  std::vector<Cell> Cells;                 ///< one more than Size, the last without change
  std::vector<std::uint32_t> VisibleCells; ///< how many of those before each can be seen at all
};
}

#endif
