// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLayout_h
#define gatunHartleyLayout_h

#include "vtkGatunCoreModule.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace gatun
{
/**
 * How a regular volume is cut into blocks, and the blocks into chunks. Everything is numbered x
 * fastest, then y, then z. The last blocks along an axis reach beyond the volume; voxels there are
 * 0 in the block (that is, the volume's base value, see HartleySource).
 */
struct VTKGATUNCORE_EXPORT HartleyLayout
{
  using Triple = std::array<std::uint32_t, 3>;

  static constexpr std::uint32_t SmallestBlock = 2;
  static constexpr std::uint32_t LargestBlock = 64;
  static constexpr std::uint32_t ChunkVoxels = 64; ///< along an axis, at most, of several blocks

  Triple Size{};  ///< voxels of the volume along x, y and z
  Triple Block{}; ///< voxels of a block
  Triple Chunk{}; ///< blocks of a chunk

  /** Cubes of blockSize voxels, 2 to 64, thinner where the volume is; 0: one block for the whole
   * volume, a little larger where that makes its transform fast. Throws Error(InvalidInput) for
   * other sizes, and for volumes that are empty or have more than 2^40 voxels. */
  static HartleyLayout Make(const Triple& size, std::uint32_t blockSize);

  bool IsWhole() const { return this->GetNumberOfBlocks() == 1; }

  Triple GetBlocks() const; ///< along each axis
  Triple GetChunks() const; ///< along each axis
  std::size_t GetNumberOfBlocks() const;
  std::size_t GetNumberOfChunks() const;
  std::size_t GetVoxelsPerBlock() const;

  /** A chunk's blocks: from First up to, not including, End. */
  struct Box
  {
    Triple First{};
    Triple End{};
  };
  Box GetBlocksOfChunk(std::size_t chunk) const;

  std::size_t GetBlockNumber(const Triple& place) const;
  Triple GetBlockPlace(std::size_t block) const;
  std::size_t GetChunkOfBlock(const Triple& place) const;

  /** How many of a block's voxels lie in the volume, along each axis. */
  Triple GetFilled(const Triple& place) const;

  bool operator==(const HartleyLayout&) const = default;
};
}

#endif
