// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLayout_h
#define gatunHartleyLayout_h

#include "gatunExport.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace gatun
{
/**
 * The division of a regular volume into blocks, and of the blocks into chunks. Indices run fastest
 * along x, then y, then z. The last blocks along an axis may extend beyond the volume. Their values
 * are 0 there, which corresponds to the base value of the volume; see HartleySource.
 */
struct GATUN_EXPORT HartleyLayout
{
  using Triple = std::array<std::uint32_t, 3>;

  static constexpr std::uint32_t SmallestBlock = 2;
  static constexpr std::uint32_t LargestBlock = 64;
  static constexpr std::uint32_t ChunkVoxels =
    64; ///< along an axis, at most, of a chunk of several blocks

  Triple Size{};  ///< voxels of the volume along x, y and z
  Triple Block{}; ///< voxels of a block
  Triple Chunk{}; ///< blocks of a chunk

  /** Cubic blocks of blockSize (2 to 64) voxels along each axis, clipped to the size of the volume.
   * 0: one block for the whole volume, slightly enlarged if that makes its transform faster. Throws
   * Error(InvalidInput) for other block sizes and for volumes that are empty or have more than 2^40
   * voxels. */
  static HartleyLayout Make(const Triple& size, std::uint32_t blockSize);

  bool IsWhole() const { return this->GetNumberOfBlocks() == 1; }

  Triple GetBlocks() const; ///< along each axis
  Triple GetChunks() const; ///< along each axis
  std::size_t GetNumberOfBlocks() const;
  std::size_t GetNumberOfChunks() const;
  std::size_t GetVoxelsPerBlock() const;

  /** The blocks [First, End) of a chunk. */
  struct Box
  {
    Triple First{};
    Triple End{};
  };
  Box GetBlocksOfChunk(std::size_t chunk) const;

  std::size_t GetBlockNumber(const Triple& place) const;
  Triple GetBlockPlace(std::size_t block) const;
  std::size_t GetChunkOfBlock(const Triple& place) const;

  /** The number of a block's voxels inside the volume, along each axis. */
  Triple GetFilled(const Triple& place) const;

  bool operator==(const HartleyLayout&) const = default;
};
}

#endif
