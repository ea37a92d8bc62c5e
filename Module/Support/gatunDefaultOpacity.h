// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunDefaultOpacity_h
#define gatunDefaultOpacity_h

#include "gatunExport.h"
#include "gatunTypes.h"
#include "gatunValueHistogram.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** The values of an object and its size, from which a default transfer function is made. */
struct ValueSurvey
{
  ValueHistogram Values{ Range{ 0, 0 } };
  Bounds Box;
  double Volume = 0; ///< of the object itself, which need not fill the box
};

/** A color of the default color map, for a value from 0 to 1. */
struct DefaultColor
{
  double Value;
  std::array<double, 3> RGB;
};

/** The default color map: lightness increases evenly, from violet over blue and green to yellow,
 * for all kinds of color vision. To be interpolated in CIE L*a*b*. */
GATUN_EXPORT std::span<const DefaultColor> GetDefaultColors();

struct OpacityNode
{
  double Value;
  double Opacity;

  bool operator==(const OpacityNode&) const = default;
};

/** Opacities that grow with the values, from 0 to 1, for images that show one value of each ray. */
GATUN_EXPORT std::span<const OpacityNode> GetDefaultRamp();

/** A default transfer function. */
struct DefaultTransfer
{
  /** The range of the default colors, Min < Max. */
  Range Colors;

  /** By strictly ascending value, from Colors.Min to Colors.Max; linear in between, constant
   * outside. */
  std::vector<OpacityNode> Opacities;
};

/**
 * Makes a transfer function that shows structure: values that fill most of the object are nearly
 * transparent, and values that are rare or far from the median are opaque.
 *
 * Extinction is w(v) / (h(v) + e), where h is the density of the object's values. With a constant
 * weight w, all values would contribute the same to an image, as in histogram equalization. The
 * weight grows with the distance from the median. The opacity of the whole is scaled to that of an
 * object of its size which is neither empty nor solid, and is lower if little of the object
 * contributes.
 *
 * Colors span the given range, or else all values; without 0.05 % of the object at each end, if
 * that makes the range a twentieth narrower or more. UnitDistance: length to which opacities refer,
 * above 0.
 *
 * Background: C. Correa, K.-L. Ma:
 * Visibility histograms and visibility-driven transfer functions, IEEE TVCG 17(2), 2011.
 */
GATUN_EXPORT DefaultTransfer MakeDefaultTransfer(
  const ValueSurvey& survey, double unitDistance, const std::optional<Range>& range = {});

/** The length of a ray to which opacities refer by default: a hundredth of the diagonal of a box.
 */
GATUN_EXPORT double GetDefaultUnitDistance(const Bounds& box);
}

#endif
