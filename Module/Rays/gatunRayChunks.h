// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayChunks_h
#define gatunRayChunks_h

#include "gatunRayBlock.h"
#include "gatunRayBlockCache.h"
#include "gatunRayValues.h"

#include <cstdint>
#include <memory>

namespace gatun
{
class ChunkCache;
class FileReader;

/** The chunks of a file with the values that are drawn, decoded and not prepared. Thread safe. */
class RayChunks
{
public:
  /** Keeps: whether decoded chunks are kept within the budget of parts, for sources that simplify
   * them again and again. Throws InvalidInput if the file has no such array or step. */
  RayChunks(std::shared_ptr<ChunkCache> parts, const RayValues& values, bool keeps);

  const std::shared_ptr<const FileReader>& GetFile() const;
  const RayValues& GetValues() const { return this->Values; }

  /** A chunk: its shared points, then its own. */
  std::shared_ptr<const RayBlock> Get(std::uint32_t chunk);

private:
  const std::shared_ptr<ChunkCache> Parts;
  const RayValues Values;
  std::unique_ptr<RayBlockCache> Kept; // null: none
};
}

#endif
