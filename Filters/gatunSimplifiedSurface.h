// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSimplifiedSurface_h
#define gatunSimplifiedSurface_h

#include "gatunMergeGrid.h"
#include "gatunMergeTree.h"
#include "gatunSurfaceTriangles.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <memory>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPolyData;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** A surface after any number of merges. */
class SimplifiedSurface
{
public:
  /** Finds the order of merges. The input may be given something else later. Throws gatun::Error
   * for wrong cells and weights, and when progress returns false. */
  SimplifiedSurface(vtkPolyData* input, const MergeWeights& weights,
    const SurfaceMergeSettings& settings, const std::function<bool(double)>& progress);

  /** The tree is moved out once; other methods take it. */
  MergeTree TakeTree() { return std::move(this->Tree); }

  /** Fills the output: vertices and lines as they are, then the triangles that are left, with their
   * data, and the points that are left. */
  void Fill(const MergeTree& tree, std::size_t merges, vtkPolyData* output) const;

private:
  vtkSmartPointer<vtkPolyData> Surface;
  SurfaceTriangles Triangles;
  MergeTree Tree;
};
}

#endif
