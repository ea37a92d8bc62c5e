// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyLayout.h"

#include "gatunError.h"
#include "gatunFourier.h"

#include <algorithm>
#include <string>

namespace gatun
{
namespace
{
constexpr std::uint64_t MostVoxels = std::uint64_t{ 1 } << 40;
constexpr std::uint64_t MostVoxelsOfBlock = std::uint64_t{ 1 } << 30;
constexpr std::uint64_t MostAlongBlock = 65535; // frequencies are at most half of it: 16 bits

std::string ToText(const HartleyLayout::Triple& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
    std::to_string(size[2]);
}

std::size_t GetProduct(const HartleyLayout::Triple& sizes)
{
  return std::size_t{ sizes[0] } * sizes[1] * sizes[2];
}

HartleyLayout::Triple GetPlace(std::size_t number, const HartleyLayout::Triple& sizes)
{
  return { static_cast<std::uint32_t>(number % sizes[0]),
    static_cast<std::uint32_t>(number / sizes[0] % sizes[1]),
    static_cast<std::uint32_t>(number / sizes[0] / sizes[1]) };
}

std::size_t GetNumber(const HartleyLayout::Triple& place, const HartleyLayout::Triple& sizes)
{
  return place[0] + std::size_t{ sizes[0] } * (place[1] + std::size_t{ sizes[1] } * place[2]);
}

/** Division, rounded up. */
HartleyLayout::Triple Divide(const HartleyLayout::Triple& whole, const HartleyLayout::Triple& part)
{
  HartleyLayout::Triple count{};
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    count[axis] = whole[axis] / part[axis] + (whole[axis] % part[axis] != 0);
  }
  return count;
}
}

//------------------------------------------------------------------------------
HartleyLayout HartleyLayout::Make(const Triple& size, std::uint32_t blockSize)
{
  if (size[0] == 0 || size[1] == 0 || size[2] == 0)
  {
    ThrowInvalid("the volume of " + ToText(size) + " voxels is empty");
  }
  // The product of two sizes cannot overflow.
  if (std::uint64_t{ size[0] } * size[1] > MostVoxels / size[2])
  {
    ThrowInvalid("the volume of " + ToText(size) + " voxels is too large; 2^40 are the most");
  }
  if (blockSize != 0 && (blockSize < SmallestBlock || blockSize > LargestBlock))
  {
    ThrowInvalid("blocks of " + std::to_string(blockSize) +
      " voxels along an axis are not possible; it is 2 to 64, or 0 for the whole volume");
  }
  HartleyLayout layout;
  layout.Size = size;
  std::uint64_t voxels = 1;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    layout.Block[axis] = blockSize == 0
      ? static_cast<std::uint32_t>(GetFastSize(std::min(size[axis], std::uint32_t{ 1 } << 31)))
      : std::min(size[axis], blockSize);
    layout.Chunk[axis] =
      blockSize == 0 ? 1 : std::max(1u, ChunkVoxels / std::max(1u, layout.Block[axis]));
    voxels = std::min(MostVoxels, voxels * std::min<std::uint64_t>(MostVoxels, layout.Block[axis]));
  }
  const auto& block = layout.Block;
  if (voxels > MostVoxelsOfBlock || *std::max_element(block.begin(), block.end()) > MostAlongBlock)
  {
    ThrowInvalid("the volume of " + ToText(size) +
      " voxels is too large for one block; 2^30 are the most, and 65535 along an axis. Choose a "
      "block size");
  }
  const auto blocks = layout.GetBlocks();
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    layout.Chunk[axis] = std::min(layout.Chunk[axis], blocks[axis]);
  }
  return layout;
}

//------------------------------------------------------------------------------
HartleyLayout::Triple HartleyLayout::GetBlocks() const
{
  return Divide(this->Size, this->Block);
}

//------------------------------------------------------------------------------
HartleyLayout::Triple HartleyLayout::GetChunks() const
{
  return Divide(this->GetBlocks(), this->Chunk);
}

//------------------------------------------------------------------------------
std::size_t HartleyLayout::GetNumberOfBlocks() const
{
  return GetProduct(this->GetBlocks());
}

//------------------------------------------------------------------------------
std::size_t HartleyLayout::GetNumberOfChunks() const
{
  return GetProduct(this->GetChunks());
}

//------------------------------------------------------------------------------
std::size_t HartleyLayout::GetVoxelsPerBlock() const
{
  return GetProduct(this->Block);
}

//------------------------------------------------------------------------------
HartleyLayout::Box HartleyLayout::GetBlocksOfChunk(std::size_t chunk) const
{
  const auto place = GetPlace(chunk, this->GetChunks());
  const auto blocks = this->GetBlocks();
  Box box;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    box.First[axis] = place[axis] * this->Chunk[axis];
    box.End[axis] = std::min(box.First[axis] + this->Chunk[axis], blocks[axis]);
  }
  return box;
}

//------------------------------------------------------------------------------
std::size_t HartleyLayout::GetBlockNumber(const Triple& place) const
{
  return GetNumber(place, this->GetBlocks());
}

//------------------------------------------------------------------------------
HartleyLayout::Triple HartleyLayout::GetBlockPlace(std::size_t block) const
{
  return GetPlace(block, this->GetBlocks());
}

//------------------------------------------------------------------------------
std::size_t HartleyLayout::GetChunkOfBlock(const Triple& place) const
{
  return GetNumber(
    { place[0] / this->Chunk[0], place[1] / this->Chunk[1], place[2] / this->Chunk[2] },
    this->GetChunks());
}

//------------------------------------------------------------------------------
HartleyLayout::Triple HartleyLayout::GetFilled(const Triple& place) const
{
  Triple filled{};
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    filled[axis] = std::min(this->Block[axis], this->Size[axis] - place[axis] * this->Block[axis]);
  }
  return filled;
}
}
