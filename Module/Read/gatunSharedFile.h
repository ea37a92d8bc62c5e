// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSharedFile_h
#define gatunSharedFile_h

#include "gatunCacheBudget.h"
#include "gatunChunkCache.h"
#include "gatunExport.h"
#include "gatunFileReader.h"
#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace gatun
{
/**
 * An open file and everything that its consumers share: one FileReader, the merge tree, the base
 * meshes and the boundary, the caches of decoded parts, and one budget for all of them. The file is
 * opened once. Base meshes, the boundary and other meshes of the series are opened, trees and
 * dependencies between merges decoded at their first use, and all are kept. Thread safe.
 */
class GATUN_EXPORT SharedFile
{
public:
  /** Opens the file. Budget: memory for decoded parts and the data that consumers derive from them,
   * in bytes. Throws Error as FileReader does. */
  SharedFile(const std::string& path, std::uint64_t budget);

  /** The same for an open file. */
  explicit SharedFile(std::shared_ptr<const FileReader> file, std::uint64_t budget = 0);

  const std::shared_ptr<const FileReader>& GetFile() const { return this->File; }

  /** Another mesh of the series, from 1 (FileReader::OpenMesh), opened at the first call. It has
   * the same budget, and is counted in the statistics and bytes of this file. */
  std::shared_ptr<SharedFile> GetMesh(std::size_t mesh);

  const std::shared_ptr<CacheBudget>& GetBudget() const { return this->Budget; }

  /** The boundary of the mesh in the file, with the same budget. Throws InvalidInput if there is
   * none. */
  std::shared_ptr<SharedFile> GetBoundary();

  /** Throws InvalidInput if the file has no hierarchy. */
  void RequireHierarchy() const;

  /** The source of a simplified mesh. */
  struct Place
  {
    std::shared_ptr<const FileReader> File; ///< the file itself or a base mesh in it
    std::shared_ptr<const MergeTree> Tree;  ///< its merge tree, null if no merges remain
    std::size_t Merges = 0;                 ///< the merges to apply
  };

  /** The coarsest base mesh from which a number of merges can be reached, or the file itself.
   * Merges of a round, and those that belong together, are not separated: there may be some more.
   * Throws InvalidInput if there are merges and no hierarchy. */
  Place Find(std::size_t merges, bool withBaseMeshes = true);

  //@{
  /** The merge tree of the whole mesh, or of the File of a place; never null. Throws InvalidInput
   * if there is no hierarchy. */
  const MergeTree& GetTree();
  std::shared_ptr<const MergeTree> GetTree(const FileReader& file);
  //@}

  /** The number of meshes in the file: the whole one and the base meshes. */
  std::size_t GetNumberOfLevels() const { return this->Levels.size(); }

  /** The number of merges that lead to a level, from 0 for the whole mesh. */
  std::size_t GetMergesOfLevel(std::size_t level) const { return this->Levels[level].Merges; }

  /** The whole mesh or a base mesh with its tree, which may have no merges. */
  Place GetLevel(std::size_t level);

  /**
   * The dependencies between the merges of the file itself or of a base mesh, the File of a place.
   * They are read at their first use and kept. Null if they are not in the file and the mesh has
   * more than 4 million tetrahedra, or cells of a surface, or merges that no builder makes: finding
   * them by decoding the mesh would take long. Other threads wait only if they want dependencies,
   * too.
   *
   * progress: of finding them by decoding the mesh; Error(Aborted) is thrown if it returns false,
   * and the next call begins again. Throws InvalidInput if the file is none of this object's.
   */
  std::shared_ptr<const MergeDependencies> GetDependencies(
    const FileReader& file, const std::function<bool(double)>& progress = {});

  /** Whether GetDependencies has a result for a level, unless no builder made its merges. */
  bool MayHaveDependencies(std::size_t level);

  /** The approximate number of tetrahedra, or cells of a surface, after a number of merges. */
  std::uint64_t EstimateCells(std::size_t merges) const;

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

  /** The whole mesh, or a base mesh. */
  struct Level
  {
    std::uint32_t Merges; // that lead to it
    std::shared_ptr<const FileReader> File;
    std::shared_ptr<const MergeTree> Tree;
    std::shared_ptr<const MergeDependencies> Dependencies;
  };

  // With the lock on files and trees:
  std::size_t FindLevel(const FileReader& file) const;
  void Open(std::size_t level);
  const std::shared_ptr<const MergeTree>& GetTree(Level& level);

  const std::shared_ptr<const FileReader> File;
  bool IsPart = false; // whether it is a mesh with some of the cells of another one
  const std::shared_ptr<CacheBudget> Budget;

  // Trees and dependencies take long. Who wants other things does not wait for them.
  std::mutex DependencyGuard;    // of the dependencies of levels; locked before the next one
  mutable std::mutex LevelGuard; // of their files and trees
  std::vector<Level> Levels;     // from fine to coarse

  mutable std::mutex Guard; // of what follows
  std::shared_ptr<SharedFile> Boundary;
  std::map<const FileReader*, std::shared_ptr<ChunkCache>> Caches; // each keeps its mesh alive
  std::map<std::size_t, std::shared_ptr<SharedFile>> Meshes;       // other ones of the series
};
}

#endif
