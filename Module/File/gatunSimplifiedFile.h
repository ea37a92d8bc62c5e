// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSimplifiedFile_h
#define gatunSimplifiedFile_h

#include "gatunFileReader.h"
#include "gatunMergeTree.h"
#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace gatun
{
/**
 * A file that tells how its mesh becomes simpler, and its base meshes. Base meshes are opened, and
 * trees are decoded, when they are needed first; both are kept. Thread safe.
 */
class VTKGATUNCORE_EXPORT SimplifiedFile
{
public:
  /** Where a simpler mesh is had from. */
  struct Place
  {
    std::shared_ptr<const FileReader> File; ///< the file itself or a base mesh in it
    std::shared_ptr<const MergeTree> Tree;  ///< of that; null if nothing is left to be merged
    std::size_t Merges = 0;                 ///< to be made yet
  };

  /** Throws InvalidInput if the file does not tell. */
  explicit SimplifiedFile(std::shared_ptr<const FileReader> file);

  const std::shared_ptr<const FileReader>& GetFile() const { return this->Levels.front().File; }

  /** The tree of the whole mesh. */
  const MergeTree& GetTree();

  /** The simplest base mesh that so many merges, at most as many as there are, start from; without
   * base meshes, the file itself. */
  Place Find(std::size_t merges, bool withBaseMeshes = true);

  /** About how many tetrahedra are left then. */
  std::uint64_t EstimateTets(std::size_t merges) const;

  /** Bytes read from the file, for base meshes too. */
  std::uint64_t GetBytesRead() const;

private:
  /** The whole mesh, or a base mesh. */
  struct Level
  {
    std::uint32_t Merges; // that it has behind it
    std::shared_ptr<const FileReader> File;
    std::shared_ptr<const MergeTree> Tree;
  };

  void Open(std::size_t level);
  const std::shared_ptr<const MergeTree>& GetTree(Level& level);

  mutable std::mutex Guard;  // of the files and trees of the levels
  std::vector<Level> Levels; // simpler and simpler
};
}

#endif
