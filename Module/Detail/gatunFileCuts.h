// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileCuts_h
#define gatunFileCuts_h

#include "gatunLevelsOfDetail.h"
#include "gatunRayChunks.h"
#include "gatunVolumeDetail.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
class CacheBudget;
class CoarseRaySource;

/**
 * Meshes for views from some successive base meshes of a file. The finest of them determines how
 * fine a mesh can be. Coarse places come from the coarsest base mesh with all merges that lead to
 * them, so that of finer ones only the chunks that a view needs are decoded.
 *
 * A tetrahedron of a base mesh is one of the mesh of a cut, after its remaining merges, if the cut
 * has all merges that led to the corners of the tetrahedron in the base mesh. Of the tetrahedra
 * that come from one in the file, one base mesh draws one.
 *
 * The points of base meshes are identified by their merges: the merges of a base mesh are the last
 * ones of all finer ones. Where points take part in no more merges, the coarsest base mesh draws
 * either all of them or none.
 */
class FileCuts
{
public:
  /** A base mesh, or the whole mesh. */
  struct Base
  {
    std::shared_ptr<RayChunks> Chunks;
    std::shared_ptr<const MergeTree> Tree;
  };

  /**
   * Bases: from fine to coarse, at least one; all chunks of the coarsest are decoded. Dependencies:
   * those of the finest. Budget: for blocks. Throws Error(Corrupt) if the trees do not belong
   * together.
   */
  FileCuts(std::vector<Base> bases, std::shared_ptr<const MergeDependencies> dependencies,
    std::shared_ptr<CacheBudget> budget, const RaySource::Progress& progress);
  ~FileCuts();

  /** Makes the mesh for a view, with about this number of points. Blocks of the last mesh that do
   * not change are reused. */
  DetailLevel Make(const DetailView& view, std::uint64_t points);

private:
  struct Level
  {
    Base Of;
    std::vector<std::uint32_t> Next; // for each point, that of the next base mesh it is merged into
    std::vector<std::uint32_t> Unmerged; // points without merges
  };

  /** For each level, whether points are too coarse; and one more, for all points without merges. */
  std::vector<std::vector<bool>> FindTooCoarse(const MergeCut& cut) const;

  std::vector<Level> Levels;
  std::unique_ptr<VolumeDetail> Detail;
  std::shared_ptr<CacheBudget> Budget;
  std::weak_ptr<CoarseRaySource> Last; // the last mesh
};
}

#endif
