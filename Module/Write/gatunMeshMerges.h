// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshMerges_h
#define gatunMeshMerges_h

#include "gatunExport.h"
#include "gatunMergeInput.h"
#include "gatunMergeTree.h"
#include "gatunMeshInput.h"
#include "gatunTypes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** The weight of each array in the cost of merges if none is given: 1 for the active scalars, or
 * else for all point arrays. */
GATUN_EXPORT std::vector<double> FindDefaultWeights(const std::vector<ArrayDescription>& arrays);

/** The points and weighted fields of a mesh, from which its merge tree is built. */
class GATUN_EXPORT MeshMerges
{
public:
  using Progress = std::function<bool(double)>;

  explicit MeshMerges(std::vector<std::array<double, 3>> points)
    : Points(std::move(points))
  {
  }

  /** The points of a mesh. */
  explicit MeshMerges(const MeshInput& mesh);

  /** Adds a field of one value for each point. */
  void AddField(std::vector<double> values, double weight);

  /** Adds the components of a point array, which share the weight. */
  void AddArray(ScalarType type, const void* values, std::uint32_t components, double weight);

  /** The tree of the tetrahedra of which the cells of a mesh consist. isKept: BasicMergeInput. */
  MergeTree Build(const MeshInput& mesh, const MergeSettings& settings = {},
    const Progress& progress = {}, std::span<const std::uint8_t> isKept = {}) const;

  /** The tree of a surface of triangles and of cells of a lower dimension, whose points are kept.
   * Throws Error (InvalidInput) for other polygons and for strips. */
  MergeTree BuildSurface(const MeshInput& mesh, const SurfaceMergeSettings& settings = {},
    const Progress& progress = {}) const;

  /** The same with the triangles themselves. */
  MergeTree BuildSurface(std::span<const std::array<std::uint32_t, 3>> triangles,
    const SurfaceMergeSettings& settings, const Progress& progress,
    std::span<const std::uint8_t> isKept) const;

private:
  template <std::size_t Corners>
  BasicMergeInput<Corners> GetInput(std::span<const std::array<std::uint32_t, Corners>> cells,
    std::span<const std::uint8_t> isKept) const;

  std::vector<std::array<double, 3>> Points;
  std::vector<std::vector<double>> Values;
  std::vector<double> Weights;
};
}

#endif
