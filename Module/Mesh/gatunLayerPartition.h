// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLayerPartition_h
#define gatunLayerPartition_h

// Sorts the tetrahedra of a mesh by the layers of their values.

#include "gatunLayers.h"
#include "gatunMeshAccess.h"
#include "gatunWithType.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The requested layers of a mesh and the result. */
struct LayerPartition
{
  ArrayDescription Array;
  LayerRequest Request;
  Layers Result;
};

/** The values of points that define the layers: a component of an array, or lengths of tuples. */
class LayerValues
{
public:
  LayerValues(const ArrayDescription& array, const LayerRequest& request)
    : Reader(array.Type, request.Values, array.Components)
    , Component(request.Component)
  {
  }

  double Get(std::uint64_t point) const
  {
    return this->Reader.Get(static_cast<std::size_t>(point), this->Component);
  }

  /** The range of the points of a cell. Infinity is a value here. */
  Range GetRange(const MeshAccess& mesh, std::uint64_t cell) const
  {
    Range range = Range::MakeEmpty();
    mesh.ForEachPoint(cell, [&](std::uint64_t point) { range.Include(this->Get(point)); });
    return range;
  }

private:
  ComponentReader Reader;
  int Component;
};

/** The default number of layers: 10, more for meshes of more than ten million tetrahedra, fewer
 * where a layer would have less than 16384 tetrahedra. */
std::uint32_t GetDefaultLayers(std::uint64_t tets);

/** The bounds between count layers, or fewer layers if some would be empty. */
std::vector<double> FindLayerBounds(
  const MeshAccess& mesh, const LayerValues& values, LayerSpacing spacing, std::uint32_t count);

/** All cells, sorted by bucket and then by number. */
struct LayerBuckets
{
  std::vector<std::uint32_t> Cells;
  std::vector<std::size_t> Start; // the first one of each bucket, and the end
};

/**
 * Puts each cell into the bucket of its first and last layer. Buckets of fewer than smallest
 * cells are joined with others such that the joint bucket spans few layers. The buckets are
 * sorted by their layers.
 */
LayerBuckets SortByLayers(
  const MeshAccess& mesh, const LayerValues& values, const Layers& layers, std::size_t smallest);

/** The first and the last layer of the values of some cells; the first layer if there are no
 * values. */
LayerSpan FindLayerSpan(const MeshAccess& mesh, const LayerValues& values, const Layers& layers,
  std::span<const std::uint32_t> cells);
}

#endif
