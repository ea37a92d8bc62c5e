// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurfaceDetail_h
#define gatunSurfaceDetail_h

#include "gatunCutChooser.h"
#include "gatunExport.h"
#include "gatunRayView.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
class SharedFile;

/** Requirements of an image for a surface. */
struct SurfaceDetailView
{
  RayView View;                ///< for the coordinates of the surface, with a ray for each pixel
  double Scale = 1;            ///< world units of a unit of these coordinates, above 0
  bool CullsBackFaces = false; ///< by the order of corners in these coordinates
  bool CullsFrontFaces = false;
  bool IsOpaque = false; ///< whether the far side of a closed surface cannot be seen

  /** Approximate limit of remaining points. */
  std::uint64_t Points = std::numeric_limits<std::uint64_t>::max();

  /** The largest error in pixels, 0 or more. It is exceeded if too many points would be left. */
  double PixelError = 0;

  bool operator==(const SurfaceDetailView&) const = default;
};

/**
 * Chooses the merges of a surface that a view allows. Errors outside of the view and on hidden back
 * faces do not count. Errors count in full at the silhouette, and less where the surface faces the
 * eye.
 *
 * Immutable and thread safe. Memory: 24 bytes a point, in addition to the tree and the
 * dependencies.
 */
class GATUN_EXPORT SurfaceDetail
{
public:
  using Point = std::array<double, 3>;
  using Triangle = MergeTree::Triangle;

  /** Places: of all points of the tree. Points that are not finite never count. Triangles: of the
   * surface before all merges. Throws InvalidInput if the numbers of points, merges and
   * dependencies do not fit. */
  SurfaceDetail(std::shared_ptr<const MergeTree> tree,
    std::shared_ptr<const MergeDependencies> dependencies, std::span<const Point> places,
    std::span<const Triangle> triangles);

  /** Chooses merges. first: the number of first merges that are made in any case. */
  MergeCut Choose(const SurfaceDetailView& view, std::size_t first = 0) const
  {
    return this->Chooser.Choose(this->Weigh(view), { view.Points, view.PixelError, first });
  }

  /** For each point, the pixels of an error of 1. */
  std::vector<float> Weigh(const SurfaceDetailView& view) const;

  /** An upper bound of the pixels of an error of 1 on the surface, if its points have the usual
   * distance for a surface of its size. */
  double BoundWeights(const SurfaceDetailView& view) const;

  /** Whether the surface is closed and its normals, by the order of corners, are outward. */
  bool IsSolid() const { return this->Solid; }

  /** Whether a place is inside of a solid surface, approximately; false if it is not solid. */
  bool IsInside(const Point& place) const;

private:
  using Small = std::array<float, 3>;

  Point Restore(const Small& place) const;
  void FindNormals(std::span<const Triangle> triangles);
  void FindSolid(std::span<const Triangle> triangles);

  CutChooser Chooser;
  Point Middle{};
  double Size = 0;            // diagonal of the bounds
  std::vector<Small> Places;  // from the middle
  std::vector<Small> Normals; // means over what was merged into each point; short if they differ
  std::vector<std::array<Point, 3>> Hull; // of a solid surface: some triangles, from the middle
  bool Solid = false;
};

/** Reads the points and triangles of a surface in a file, or of one of its base meshes, at a time
 * step. If progress returns false, Error(Aborted) is thrown. */
GATUN_EXPORT std::shared_ptr<const SurfaceDetail> ReadSurfaceDetail(SharedFile& file,
  std::size_t level, std::size_t step, const std::function<bool(double)>& progress);
}

#endif
