// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLayers_h
#define gatunLayers_h

// Files that are organized by layers. The range of an array's values is divided into layers, and a
// chunk holds tetrahedra with values in the same layers. Algorithms that need only some values,
// such as isosurfaces, then decode few chunks. See Documentation/layers.md.

#include "gatunExport.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Spacing of the layers. The numbers are those of the file format. */
enum class LayerSpacing : std::uint8_t
{
  Other = 0,    ///< unknown, from a later writer
  Uniform = 1,  ///< layers of equal width
  Normal = 2,   ///< quantiles of the normal distribution with the values' mean and deviation
  Histogram = 3 ///< about equal numbers of tetrahedra
};

constexpr std::uint32_t MaxLayers = 4096;

/** The layers of a new file. */
struct LayerRequest
{
  std::uint32_t Array = 0; ///< index of a point array

  /** A component of the array, or -1 for the length of the tuple if there are several. */
  int Component = 0;

  /** The number of layers, 1 to MaxLayers, or 0 for a default that suits the size of the mesh.
   * Empty layers are left out, so the file may have fewer. */
  std::uint32_t Count = 0;

  LayerSpacing Spacing = LayerSpacing::Histogram;

  /** The array at the first time step. It must exist until the writer has been constructed. */
  const void* Values = nullptr;
};

/** First and last layer. */
struct LayerSpan
{
  std::uint32_t First = 0;
  std::uint32_t Last = 0;

  bool operator==(const LayerSpan&) const = default;
};

/** The layers of a file, which refer to its first time step. */
struct Layers
{
  std::uint32_t Array = 0;
  int Component = 0; ///< as in LayerRequest
  LayerSpacing Spacing = LayerSpacing::Other;

  /** Ascending and finite. Layer i contains Bounds[i - 1] <= value < Bounds[i]. */
  std::vector<double> Bounds;

  std::vector<LayerSpan> Chunks; ///< the layers of the values of each chunk

  std::uint32_t GetCount() const { return static_cast<std::uint32_t>(this->Bounds.size()) + 1; }

  /** The layer of a value. NaN is in the first one. */
  std::uint32_t Find(double value) const
  {
    // Comparisons with NaN are false.
    return static_cast<std::uint32_t>(std::partition_point(this->Bounds.begin(), this->Bounds.end(),
                                        [value](double bound) { return bound <= value; }) -
      this->Bounds.begin());
  }
};
}

#endif
