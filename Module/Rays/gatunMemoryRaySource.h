// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMemoryRaySource_h
#define gatunMemoryRaySource_h

#include "gatunExport.h"
#include "gatunMeshInput.h"
#include "gatunRaySource.h"
#include "gatunRayValues.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace gatun
{
class BlockMesh;

/**
 * A mesh in the caller's memory, in compact blocks of tetrahedra. The mesh must not change or move.
 * Blocks are kept within a budget.
 */
class GATUN_EXPORT MemoryRaySource final : public RaySource
{
public:
  static constexpr std::uint32_t DefaultBlockTets = 32768;

  /** Hidden: null, or for each tetrahedron whether to leave it out. Budget: in bytes. Throws
   * InvalidInput if a tetrahedron has a point that does not exist. */
  MemoryRaySource(const MeshInput& mesh, const RayValuesInput& values, const unsigned char* hidden,
    std::uint64_t budget, std::uint32_t blockTets = DefaultBlockTets,
    const Progress& progress = {});

  /** For meshes that bring their own blocks. */
  MemoryRaySource(std::unique_ptr<const BlockMesh> mesh, std::uint64_t budget);

  ~MemoryRaySource() override;

  std::size_t GetNumberOfBlocks() const override;
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
