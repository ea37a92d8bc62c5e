// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLayerPartition_h
#define gatunLayerPartition_h

// Sorts the tetrahedra of a mesh by the layers in which their values lie.

#include "gatunDomain.h"
#include "gatunLayers.h"
#include "gatunMeshAccess.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace gatun
{
/** By which values a mesh is cut, and what comes out of that. */
struct LayerPartition
{
  ArrayDescription Array;
  LayerRequest Request;
  Layers Result;
};

/** The numbers on points that layers are made of: a component of an array, or lengths. */
class LayerValues
{
public:
  LayerValues(const ArrayDescription& array, const LayerRequest& request)
    : Type(array.Type)
    , Components(array.Components)
    , Component(request.Component)
    , Values(static_cast<const std::uint8_t*>(request.Values))
  {
  }

  double Get(std::uint64_t point) const
  {
    if (this->Component < this->Components)
    {
      return this->Get(point, this->Component);
    }
    double square = 0;
    for (std::uint32_t c = 0; c < this->Components; ++c)
    {
      const double value = this->Get(point, c);
      square += value * value;
    }
    return std::sqrt(square);
  }

  /** Of the corners of a tetrahedron, without what is not a number. */
  Range GetRange(const MeshAccess& mesh, std::uint64_t tet) const
  {
    // Not Range's own bounds, as infinity is a value here.
    Range range{ std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity() };
    for (unsigned i = 0; i < 4; ++i)
    {
      const double value = this->Get(mesh.GetId(tet, i));
      range.Min = value < range.Min ? value : range.Min;
      range.Max = value > range.Max ? value : range.Max;
    }
    return range;
  }

private:
  double Get(std::uint64_t point, std::uint32_t component) const
  {
    const auto* at = this->Values + (point * this->Components + component) * SizeOf(this->Type);
    return Domain::PlainToNumber(this->Type, Domain::ReadPlain(this->Type, at));
  }

  ScalarType Type;
  std::uint32_t Components;
  std::uint32_t Component;
  const std::uint8_t* Values;
};

/** How many layers pay with a mesh of so many tetrahedra: 12, more of more than ten million, fewer
 * if they would have less than 16384 tetrahedra each. */
std::uint32_t GetDefaultLayers(std::uint64_t tets);

/** Bounds of so many layers, or of fewer if some would be empty. */
std::vector<double> FindLayerBounds(
  const MeshAccess& mesh, const LayerValues& values, LayerSpacing spacing, std::uint32_t count);

/** All tetrahedra, bucket by bucket, ascending in each. */
struct LayerBuckets
{
  std::vector<std::uint32_t> Tets;
  std::vector<std::size_t> Start; // of each bucket, and the end
};

/**
 * Puts each tetrahedron into the bucket of its first and last layer, and joins buckets of fewer
 * than so many tetrahedra with those that get the least wider by it. In the order of their layers.
 */
LayerBuckets SortByLayers(
  const MeshAccess& mesh, const LayerValues& values, const Layers& layers, std::size_t smallest);

/** The layers of the values of these tetrahedra; the first one if there is none. */
LayerSpan FindLayerSpan(const MeshAccess& mesh, const LayerValues& values, const Layers& layers,
  std::span<const std::uint32_t> tets);
}

#endif
