// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMemoryLevelsOfDetail_h
#define gatunMemoryLevelsOfDetail_h

#include "gatunExport.h"
#include "gatunLevelsOfDetail.h"
#include "gatunMergeTree.h"
#include "gatunMeshInput.h"
#include "gatunRaySource.h"
#include "gatunRayValues.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/**
 * An immutable copy of a mesh with the values that are drawn. Other threads may use it after the
 * original has changed. Memory: 16 bytes for each tetrahedron, 32 bytes for each point, and 8 bytes
 * for each tetrahedron if values of tetrahedra are drawn.
 */
class GATUN_EXPORT MemoryRayMesh
{
public:
  using Progress = RaySource::Progress;

  /** Hidden: see MemoryRaySource. Throws InvalidInput if a tetrahedron has a point that does not
   * exist. */
  MemoryRayMesh(const MeshInput& mesh, const RayValuesInput& values, const unsigned char* hidden,
    const Progress& progress = {});
  ~MemoryRayMesh();
  MemoryRayMesh(const MemoryRayMesh&) = delete;
  MemoryRayMesh& operator=(const MemoryRayMesh&) = delete;

  std::uint64_t GetNumberOfPoints() const;

  /** Returns the merges that change the drawn values least. Values of tetrahedra are averaged at
   * their points. Throws as BuildMergeTree does. */
  MergeTree BuildTree(const Progress& progress = {}) const;

  class Internals;
  const Internals& GetInternals() const { return *this->Self; }

private:
  std::unique_ptr<Internals> Self;
};

/** Returns the whole mesh in the blocks of MemoryRaySource. Images are the same to the last bit. */
GATUN_EXPORT std::shared_ptr<RaySource> MakeWholeSource(
  std::shared_ptr<const MemoryRayMesh> mesh, std::uint64_t budget);

/**
 * The levels of detail of a mesh in memory with a merge tree.
 *
 * Tetrahedra of the levels with half of the points, a quarter, and so on, are kept once they have
 * been made. A level is made from the next of these, which has at most twice as many points.
 * Together they take about as much memory as the whole mesh. A level for a view is made from one of
 * these that is fine enough for the view. The dependencies between its merges are found at its
 * first use and take some 40 bytes a point.
 */
class GATUN_EXPORT MemoryLevelsOfDetail final : public LevelsOfDetail
{
public:
  /** Budget: for the blocks of a level, in bytes. Throws InvalidInput if the tree has another
   * number of points. */
  MemoryLevelsOfDetail(
    std::shared_ptr<const MemoryRayMesh> mesh, MergeTree tree, std::uint64_t budget);
  ~MemoryLevelsOfDetail() override;

  std::uint64_t GetNumberOfPoints() const override;
  std::uint64_t GetFewestPoints() const override;
  DetailLevel MakeLevel(const DetailRequest& request, const RaySource::Progress& progress) override;
  std::uint64_t EstimateTets(std::uint64_t points) const override;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
