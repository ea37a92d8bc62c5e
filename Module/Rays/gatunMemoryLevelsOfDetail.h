// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMemoryLevelsOfDetail_h
#define gatunMemoryLevelsOfDetail_h

#include "gatunLevelsOfDetail.h"
#include "gatunMergeTree.h"
#include "gatunMeshInput.h"
#include "gatunRaySource.h"
#include "gatunRayValues.h"
#include "vtkGatunCoreModule.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/**
 * A copy of a mesh with the values that are drawn, which never changes: other threads may use it
 * whatever becomes of the original. Takes 16 bytes a tetrahedron and 32 bytes a point, and 8 bytes
 * a tetrahedron if its values are drawn.
 */
class VTKGATUNCORE_EXPORT MemoryRayMesh
{
public:
  using Progress = RaySource::Progress;

  /** Hidden: as of MemoryRaySource. Throws InvalidInput if a tetrahedron names a point that is not
   * there. */
  MemoryRayMesh(const MeshInput& mesh, const RayValuesInput& values, const unsigned char* hidden,
    const Progress& progress = {});
  ~MemoryRayMesh();
  MemoryRayMesh(const MemoryRayMesh&) = delete;
  MemoryRayMesh& operator=(const MemoryRayMesh&) = delete;

  std::uint64_t GetNumberOfPoints() const;

  /** The merges that change what is drawn least. Values of tetrahedra count as those of their
   * points, on average. Throws as BuildMergeTree does. */
  MergeTree BuildTree(const Progress& progress = {}) const;

  class Internals;
  const Internals& GetInternals() const { return *this->Self; }

private:
  std::unique_ptr<Internals> Self;
};

/** All of a mesh, in the blocks of MemoryRaySource; it looks the same to the last bit. */
VTKGATUNCORE_EXPORT std::shared_ptr<RaySource> MakeWholeSource(
  std::shared_ptr<const MemoryRayMesh> mesh, std::uint64_t budget);

/**
 * A mesh in memory with the merges that make it simpler.
 *
 * Of the mesh with half of its points, a quarter, and so on, the tetrahedra are kept once they were
 * needed, so that what is made for a number of points begins with at most twice as many. All
 * together they take about as much as the whole mesh.
 */
class VTKGATUNCORE_EXPORT MemoryLevelsOfDetail final : public LevelsOfDetail
{
public:
  /** Throws InvalidInput if the tree is not that of so many points. */
  MemoryLevelsOfDetail(std::shared_ptr<const MemoryRayMesh> mesh, MergeTree tree);
  ~MemoryLevelsOfDetail() override;

  std::uint64_t GetNumberOfPoints() const override;
  std::uint64_t GetFewestPoints() const override;
  std::shared_ptr<RaySource> MakeSource(std::uint64_t points, std::uint64_t budget) override;
  std::uint64_t EstimateTets(std::uint64_t points) const override;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
