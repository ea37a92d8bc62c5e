// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSimplifiedFile_h
#define gatunSimplifiedFile_h

#include "gatunExport.h"
#include "gatunFileReader.h"
#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace gatun
{
/**
 * A file with a merge tree and its base meshes. Base meshes are opened, trees and dependencies
 * between merges decoded at their first use, and all are kept. Thread safe.
 */
class GATUN_EXPORT SimplifiedFile
{
public:
  /** The source of a simplified mesh. */
  struct Place
  {
    std::shared_ptr<const FileReader> File; ///< the file itself or a base mesh in it
    std::shared_ptr<const MergeTree> Tree;  ///< its merge tree, null if no merges remain
    std::size_t Merges = 0;                 ///< the merges to apply
  };

  /** Throws Error(InvalidInput) if the file has no merge tree. */
  explicit SimplifiedFile(std::shared_ptr<const FileReader> file);

  const std::shared_ptr<const FileReader>& GetFile() const { return this->Levels.front().File; }

  /** The merge tree of the whole mesh. */
  const MergeTree& GetTree();

  /** The coarsest base mesh from which a number of merges can be reached, or the file itself. In a
   * surface, merges that belong together are not separated: some of the last ones may be left out.
   */
  Place Find(std::size_t merges, bool withBaseMeshes = true);

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

  /** The merge tree of the file itself or of a base mesh, the File of a place. Never null. */
  std::shared_ptr<const MergeTree> GetTree(const FileReader& file);

  /** The approximate number of tetrahedra, or cells of a surface, after a number of merges. */
  std::uint64_t EstimateCells(std::size_t merges) const;

  /** The number of bytes read from the file, including base meshes. */
  std::uint64_t GetBytesRead() const;

private:
  /** The whole mesh, or a base mesh. */
  struct Level
  {
    std::uint32_t Merges; // that lead to it
    std::shared_ptr<const FileReader> File;
    std::shared_ptr<const MergeTree> Tree;
    std::shared_ptr<const MergeDependencies> Dependencies;
  };

  std::size_t FindLevel(const FileReader& file) const;
  void Open(std::size_t level);
  const std::shared_ptr<const MergeTree>& GetTree(Level& level);

  std::mutex DependencyGuard; // of the dependencies of the levels; locked before the other one
  mutable std::mutex Guard;   // of their files and trees
  std::vector<Level> Levels;  // from fine to coarse
};
}

#endif
