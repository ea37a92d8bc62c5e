// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayTable_h
#define gatunRayTable_h

#include "gatunExport.h"
#include "gatunRayPieces.h"
#include "gatunTypes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/** Blend modes: how the values along a ray become a pixel. */
enum class RayMode : std::uint8_t
{
  Composite, ///< the emission-absorption integral of color and opacity, front to back
  Sampled,   ///< the same, approximated by samples at the sample distance
  Maximum,   ///< maximum intensity: color and opacity of the largest value
  XRay       ///< the integral of absorption, independent of the order
};

/** The color and opacity of a value: red, green, blue, and opacity over the unit distance; 0 to 1.
 */
using RayColor = std::function<std::array<double, 4>(double value)>;

/**
 * A table of the transfer function over a range of values, prepared for one image. Between the
 * entries of the table, premultiplied colors and opacities are linear. Integrals along rays use
 * few pieces instead, on which they are parabolas. The unit of length is the sample distance.
 */
struct GATUN_EXPORT RayTable
{
  /** A cell: its entry at the lower end, and the difference to that at the upper end.
   * Sampled: (r a, g a, b a, -a), a the opacity of a sample; Maximum: the same with a that of a
   * unit. Composite, XRay: (r o, g o, b o, o), o the optical depth of a sample distance. */
  struct alignas(32) Cell
  {
    std::array<float, 4> Value, Change;

    bool operator==(const Cell&) const = default;
  };

  static constexpr int Size = 4096;

  using Piece = RayPiece;

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
  RayPieces Pieces;                        ///< Composite and XRay
};
}

#endif
