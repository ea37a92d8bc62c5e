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
/** Blend modes: how the samples of a ray become a pixel. */
enum class RayMode : std::uint8_t
{
  Composite, ///< color and opacity, front to back
  Area,      ///< the same, with one sample for each segment between two faces
  Maximum,   ///< maximum intensity: the sample with the largest value
  XRay       ///< sum of absorption, independent of the order
};

/** The color and opacity of a value: red, green, blue, and opacity over the unit distance; 0 to 1.
 */
using RayColor = std::function<std::array<double, 4>(double value)>;

/**
 * A table of the transfer function over a range of values, prepared for the samples of one image.
 * Between the entries of the table, colors and opacities are linear.
 */
struct VTKGATUNCORE_EXPORT RayTable
{
  /** A cell: its entry at the lower end, and the difference to that at the upper end.
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
   * Range: values outside of it get the color of its nearer end. Opacities are over
   * unitDistance, in world units as sampleDistance.
   */
  RayTable(RayMode mode, const RayColor& color, const Range& range, double sampleDistance,
    double unitDistance);

  /** Whether all values of a range are fully transparent. */
  bool IsTransparent(const Range& values) const;

  bool operator==(const RayTable&) const = default;

  RayMode Mode;
  double Low = 0;                          ///< value of the first entry
  double Scale = 0;                        ///< cells for each unit of value
  std::vector<Cell> Cells;                 ///< Size + 1, the last without change
  std::vector<std::uint32_t> VisibleCells; ///< number of visible cells before each
};
}

#endif
