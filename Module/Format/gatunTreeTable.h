// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeTable_h
#define gatunTreeTable_h

// The TREE and TRNG sections, which describe the merge tree. See Documentation/format.md, 13.

#include "gatunContainer.h"
#include "gatunMetaTable.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The number of points that merges may be about, the first ones of a mesh. In a surface, a point
 * that no cell has may be merged, such as one of a seam in a base mesh. */
std::uint32_t CountMergeablePoints(const MetaTable& meta, bool isSurface);

/** Where merges are that lead from a mesh to its first base mesh, or from one base mesh to the next
 * one; the last part has all the others. */
struct TreePart
{
  std::uint32_t Points = 0; ///< that merges may be about, the first ones of the mesh
  StreamRef Merges;         ///< in the numbers of the mesh
  StreamRef Map;            ///< the numbers of the points that are left in the next base mesh
  StreamRef Dependencies;   ///< of these and all later merges on these; none if nothing is stored
};

/** The merge tree and the bounds of chunks after merges. */
struct TreeTable
{
  static constexpr std::size_t MaxMergeCounts = 64;

  std::uint32_t Merges = 0;

  /** The number of merges that lead to each base mesh, ascending. */
  std::vector<std::uint32_t> Levels;

  /** One more than base meshes. In a base mesh none: they are those of the whole file. */
  std::vector<TreePart> Parts;

  /** Numbers of merges, ascending. The last one is the number of all merges. */
  std::vector<std::uint32_t> MergeCounts;

  /** For each chunk and merge count, the bounds of its points after any number of merges up to the
   * merge count.
   */
  std::vector<std::vector<Bounds>> Boxes;

  /** The number of merges before a part and of those that it has. */
  std::uint32_t GetFirstMerge(std::size_t part) const
  {
    return part == 0 ? 0 : this->Levels[part - 1];
  }
  std::uint32_t GetMergesOfPart(std::size_t part) const
  {
    return (part < this->Levels.size() ? this->Levels[part] : this->Merges) -
      this->GetFirstMerge(part);
  }

  Bytes Write() const;
  static TreeTable Read(std::span<const std::uint8_t> bytes, const MetaTable& meta,
    std::size_t numberOfChunks, bool isSurface = false);

  /** The first merge count that is not below a number of merges. */
  std::size_t FindMergeCount(std::size_t merges) const;
};

/** The ranges of point arrays after merges, at one time step. */
struct TreeStepTable
{
  /** For each point array (none for cell arrays), chunk and merge count. */
  std::vector<std::vector<std::vector<ArrayRanges>>> Ranges;

  Bytes Write() const;
  static TreeStepTable Read(std::span<const std::uint8_t> bytes, const MetaTable& meta,
    std::size_t numberOfChunks, const TreeTable& tree);
};
}

#endif
