// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunBlockMesh_h
#define gatunBlockMesh_h

#include "gatunRayBlock.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** A mesh in memory whose tetrahedra are in blocks. Thread safe. */
class BlockMesh
{
public:
  virtual ~BlockMesh() = default;

  virtual std::size_t GetNumberOfBlocks() const = 0;

  /** Fills empty lists with the tetrahedra of a block, by points of the mesh, and with their
   * values, if values of tetrahedra are drawn. */
  virtual void GetTets(
    std::size_t block, std::vector<RayBlock::Tet>& tets, std::vector<double>& values) const = 0;

  /** Writes points with their values, or with 0 if values of tetrahedra are drawn. */
  virtual void GetPoints(std::span<const std::uint32_t> points, RayPoint* result) const = 0;
};
}

#endif
