// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSharedGroups_h
#define gatunSharedGroups_h

#include "gatunMeshTable.h"

#include <cstdint>
#include <map>
#include <vector>

namespace gatun
{
/** Two or more chunks, ascending. */
using ChunkGroup = std::vector<std::uint32_t>;

/** The number of shared points of each set of chunks in a file. */
class SharedGroups
{
public:
  /** Adds points to a set, or removes them if points is negative. */
  void Add(const ChunkGroup& chunks, std::int64_t points);

  /** The groups for another process, with the given number added to those of chunks. */
  void Put(ByteWriter& out, std::uint32_t firstChunk) const;

  /** Adds the groups of another process. */
  void Add(ByteReader& in);

  /** The groups in blocks, in the order of the file. Large groups are blocks of their own. The
   * small groups with the same first chunk are one block. Throws Error(InvalidInput) if there are
   * too many points in a group or block. */
  std::vector<BlockEntry> MakeBlocks() const;

private:
  std::map<ChunkGroup, std::int64_t> Points;
};
}

#endif
