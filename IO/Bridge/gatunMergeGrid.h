// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMergeGrid_h
#define gatunMergeGrid_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkIndent.h"

#include "gatunMergeBuilder.h"
#include "gatunMergeTree.h"
#include "gatunSurfaceMergeBuilder.h"
#include "gatunTypes.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <ostream>
#include <span>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPointSet;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Weights of the point arrays in the cost of simplification. */
class VTKGATUNIO_EXPORT MergeWeights
{
public:
  /** Both return whether a weight changed. */
  bool Set(const char* name, double weight);
  bool Clear();

  double Get(const char* name) const; ///< 0 if unset
  const std::map<std::string, double>& GetAll() const { return this->Weights; }

  /** The weight of each array: of point arrays that are named, or else the default ones. Throws
   * InvalidInput if there is no point array of a name. */
  std::vector<double> Find(const std::vector<ArrayDescription>& arrays) const;
  void Print(std::ostream& os, vtkIndent indent) const;

  bool operator==(const MergeWeights&) const = default;

private:
  std::map<std::string, double> Weights;
};

/**
 * Builds the merge tree of a grid of tetrahedra. Without weights, the cost is that of the active
 * scalars or, if there are none, of all point arrays with equal weights. Throws gatun::Error
 * (InvalidInput) if a cell refers to a missing point or a weight to a missing array. Exported for
 * the filters.
 *
 * isKept: see MergeInput.
 */
VTKGATUNIO_EXPORT MergeTree BuildMergeTree(vtkUnstructuredGrid* tets, const MergeWeights& weights,
  const MergeSettings& settings, const std::function<bool(double)>& progress,
  std::span<const std::uint8_t> isKept = {});

/** Builds the merge tree of the grid of a surface (MakeSurfaceGrid), which must not have polygons
 * other than triangles, nor strips. Points of vertices and lines are kept. */
VTKGATUNIO_EXPORT MergeTree BuildSurfaceMergeTree(vtkUnstructuredGrid* surface,
  const MergeWeights& weights, const SurfaceMergeSettings& settings,
  const std::function<bool(double)>& progress);

/** The same for triangles over the points of a point set. */
VTKGATUNIO_EXPORT MergeTree BuildMergeTree(vtkPointSet* surface,
  std::span<const std::array<std::uint32_t, 3>> triangles, const MergeWeights& weights,
  const SurfaceMergeSettings& settings, const std::function<bool(double)>& progress,
  std::span<const std::uint8_t> isKept = {});
}

#endif
