// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSharedFile_h
#define gatunSharedFile_h

#include "gatunCacheBudget.h"
#include "gatunChunkCache.h"
#include "gatunExport.h"
#include "gatunFileReader.h"
#include "gatunSimplifiedFile.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace gatun
{
/**
 * An open file and everything that its consumers share: one FileReader, the merge tree, the base
 * meshes and the boundary, the caches of decoded parts, and one budget for all of them. The file is
 * opened once, in the constructor. Thread safe.
 */
class GATUN_EXPORT SharedFile
{
public:
  /** Opens the file. Budget: memory for decoded parts and the data that consumers derive from them,
   * in bytes. Throws Error as FileReader does. */
  SharedFile(const std::string& path, std::uint64_t budget);

  const std::shared_ptr<const FileReader>& GetFile() const { return this->File; }

  /** Another mesh of the series, from 1 (FileReader::OpenMesh), opened at the first call. It has
   * the same budget, and is counted in the statistics and bytes of this file. */
  std::shared_ptr<SharedFile> GetMesh(std::size_t mesh);

  const std::shared_ptr<CacheBudget>& GetBudget() const { return this->Budget; }

  /** The merge tree and the base meshes. Throws InvalidInput if the file has no hierarchy. */
  SimplifiedFile& GetHierarchy();

  /** The boundary of the mesh in the file, opened at the first call. Throws InvalidInput if there
   * is none. */
  std::shared_ptr<const FileReader> GetBoundary();

  /** The merge tree of the boundary. Throws InvalidInput if there is no boundary, or it has no
   * hierarchy. */
  SimplifiedFile& GetBoundaryHierarchy();

  /** The decoded parts of the file, of its boundary, or of one of its base meshes, for one
   * consumer: every call returns another view of the same cache, with statistics of its own. A view
   * that does not keep chunks finds the chunks of the others. */
  std::shared_ptr<ChunkCache> MakeView(
    const std::shared_ptr<const FileReader>& mesh, bool keepsChunks);

  /** The decoding that all consumers have done, and the memory of decoded parts. */
  ChunkCacheStatistics GetStatistics() const;

  /** Bytes read from the file since it was opened, for base meshes and the boundary too. */
  std::uint64_t GetBytesRead() const;

private:
  SharedFile(std::shared_ptr<const FileReader> file, std::shared_ptr<CacheBudget> budget);

  std::shared_ptr<ChunkCache> GetCache(const std::shared_ptr<const FileReader>& mesh);

  const std::shared_ptr<const FileReader> File;
  bool IsPart = false; // whether it is a mesh with some of the cells of another one
  const std::shared_ptr<CacheBudget> Budget;
  mutable std::mutex Guard; // of what follows
  std::unique_ptr<SimplifiedFile> Hierarchy;
  std::shared_ptr<const FileReader> Boundary;
  std::unique_ptr<SimplifiedFile> BoundaryHierarchy;
  std::map<const FileReader*, std::shared_ptr<ChunkCache>> Caches; // each keeps its mesh alive
  std::map<std::size_t, std::shared_ptr<SharedFile>> Meshes;       // other ones of the series
};
}

#endif
