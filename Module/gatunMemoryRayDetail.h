// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMemoryRayDetail_h
#define gatunMemoryRayDetail_h

#include "gatunMergeTree.h"
#include "gatunRayDetail.h"
#include "gatunRaySource.h"
#include "vtkGatunCoreModule.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/**
 * A mesh in the caller's memory, which must stay there, with the merges that make it simpler.
 *
 * Of the mesh with half of its points, a quarter, and so on, the tetrahedra are kept once they were
 * needed, so that what is made for a number of points begins with at most twice as many. That is
 * about 20 bytes for each tetrahedron of the whole mesh, all together, besides 32 bytes a point.
 * The whole mesh is drawn in the blocks of MemoryRaySource, and looks the same to the last bit.
 */
class VTKGATUNCORE_EXPORT MemoryRayDetail final : public RayDetail
{
public:
  using Progress = RaySource::Progress;

  /** Hidden: as of MemoryRaySource. Throws InvalidInput if a tetrahedron names a point that is not
   * there, or if the tree is not that of so many points. */
  MemoryRayDetail(const MeshInput& mesh, const RayValuesInput& values, const unsigned char* hidden,
    MergeTree tree, const Progress& progress = {});
  ~MemoryRayDetail() override;

  std::uint64_t GetNumberOfPoints() const override;
  std::uint64_t GetFewestPoints() const override;
  std::shared_ptr<RaySource> MakeSource(std::uint64_t points, std::uint64_t budget) override;
  std::uint64_t EstimateTets(std::uint64_t points) const override;

private:
  class Internals;
  std::shared_ptr<Internals> Self; // sources have it, too
};

/** The merges of a mesh that change what is drawn least. Values of tetrahedra count as those of
 * their points, on average; hidden tetrahedra do not count. Throws as BuildMergeTree does. */
VTKGATUNCORE_EXPORT MergeTree BuildRayTree(const MeshInput& mesh, const RayValuesInput& values,
  const unsigned char* hidden, const RaySource::Progress& progress = {});
}

#endif
