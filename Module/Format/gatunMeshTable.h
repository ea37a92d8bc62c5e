// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshTable_h
#define gatunMeshTable_h

#include "gatunCellTable.h"
#include "gatunContainer.h"
#include "gatunTableParts.h"
#include "gatunTypes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/** Points that are shared by the same set of chunks. */
struct SharedGroup
{
  std::vector<std::uint32_t> Chunks; // two or more, ascending
  std::uint32_t Points = 0;
};

/** Shared points that are decoded together, or the unused points, which have no groups. */
struct BlockEntry
{
  std::vector<SharedGroup> Groups;
  std::uint64_t Points = 0;
  StreamRef Geometry;
  StreamRef Order; // original ids, if KeepPoints

  std::uint64_t FirstPoint = 0; // not stored: blocks are consecutive
};

struct ChunkEntry
{
  ChunkInfo Info;
  StreamRef Connectivity;
  StreamRef Geometry;
  StreamRef PointOrder; // original ids, if KeepPoints
  StreamRef CellOrder;  // original ids, if KeepCells
  StreamRef Corners;    // if KeepCorners: rotations; for other cells than tetrahedra, maybe nothing
  CellSizes Sizes;      // not stored here, but in the table of cells

  // Not stored: the groups that contain this chunk's shared points, in the order of the file.
  struct Part
  {
    std::uint32_t Block = 0;
    std::uint32_t Group = 0;
    std::uint32_t Points = 0;
    std::uint64_t FirstInBlock = 0;
    std::uint64_t FirstPoint = 0; // its number in the file
  };
  std::vector<Part> Shared;
};

/** The maximum number of groups in the blocks that a chunk has points of, and of the chunks that
 * the groups of a chunk name, counted once for each group. They bound the time to find neighbors.
 */
constexpr std::uint64_t MaxGroupsOfChunk = 1u << 22;

/** Provides the group of a part of a chunk. */
using GetGroupFunction = std::function<const SharedGroup&(const ChunkEntry::Part& part)>;

/** Throws Error(Corrupt) if a chunk shares its points with too many others, see MaxGroupsOfChunk.
 */
void CheckGroups(const ChunkEntry& entry, const GetGroupFunction& groupOf);

/** The other chunks that share points with a chunk, ascending. */
std::vector<std::uint32_t> FindNeighbors(
  const ChunkEntry& entry, std::uint32_t chunk, const GetGroupFunction& groupOf);

/** The neighbors that use each shared point of a chunk: bit i for the i-th neighbor, bit 31 for
 * the 32nd and all further ones. */
std::vector<std::uint32_t> FindSharedUsers(
  const ChunkEntry& entry, std::uint32_t chunk, const GetGroupFunction& groupOf);

/** The chunks and blocks of a file that is being written. Readers have MeshIndex and MeshPage. */
struct MeshTable
{
  std::array<PaletteRef, 3> Palettes;
  std::vector<BlockEntry> Blocks; // ascending by the first chunk of their groups
  BlockEntry Unused;
  std::vector<ChunkEntry> Chunks;

  /** Computes the fields that are not stored from the groups: positions and parts. */
  void LinkGroups();

  std::vector<std::uint32_t> GetSharedUsers(std::uint32_t chunk) const;
  std::uint64_t GetSharedPoints() const;

private:
  const SharedGroup& GetGroup(const ChunkEntry::Part& part) const
  {
    return this->Blocks[part.Block].Groups[part.Group];
  }
};
}

#endif
