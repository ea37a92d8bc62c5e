// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLayers_h
#define gatunLayers_h

// Files that are organised by layers: the range of an array's values is cut into layers, and a
// chunk holds tetrahedra whose values lie in the same ones, so that what needs only some values, as
// an isosurface does, is in few chunks. See Documentation/layers.md.

#include "vtkGatunCoreModule.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** How the range of values is cut into layers. The numbers are those of the file format. */
enum class LayerSpacing : std::uint8_t
{
  Other = 0,    ///< of a file by a later writer
  Uniform = 1,  ///< layers as wide as each other
  Normal = 2,   ///< by the normal distribution that has the values' mean and deviation
  Histogram = 3 ///< about as many tetrahedra in each
};

constexpr std::uint32_t MaxLayers = 4096;

/** By which values to organise a file that is to be written. */
struct LayerRequest
{
  std::uint32_t Array = 0; ///< of the descriptions, one on points

  /** Which of the array's ranges (see ArrayRanges): a component, or, if there are several, their
   * number for the length of the tuple. */
  std::uint32_t Component = 0;

  /** 1 to MaxLayers, or 0 for as many as pay with a mesh of this size. There may be fewer in the
   * end, as none is without any value. */
  std::uint32_t Count = 0;

  LayerSpacing Spacing = LayerSpacing::Histogram;

  /** The array at the first time step, which must stay there until the writer is made. */
  const void* Values = nullptr;
};

/** First and last layer. */
struct LayerSpan
{
  std::uint32_t First = 0;
  std::uint32_t Last = 0;

  bool operator==(const LayerSpan&) const = default;
};

/** By which values, at its first time step, a file is organised. */
struct Layers
{
  std::uint32_t Array = 0;
  std::uint32_t Component = 0; ///< as in LayerRequest
  LayerSpacing Spacing = LayerSpacing::Other;

  /** Ascending, finite: layer i has values from Bounds[i - 1] to below Bounds[i]. */
  std::vector<double> Bounds;

  std::vector<LayerSpan> Chunks; ///< of each, where its values are

  std::uint32_t GetCount() const { return static_cast<std::uint32_t>(this->Bounds.size()) + 1; }

  /** The layer of a value; the first one of what is not a number. */
  std::uint32_t Find(double value) const
  {
    // Comparisons with what is not a number are false.
    return static_cast<std::uint32_t>(std::partition_point(this->Bounds.begin(), this->Bounds.end(),
                                        [value](double bound) { return bound <= value; }) -
      this->Bounds.begin());
  }
};
}

#endif
