// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCoarseLayout_h
#define gatunCoarseLayout_h

#include "gatunExport.h"
#include "gatunFileReader.h"
#include "gatunMergeCut.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
struct BlockEntry;
struct SharedGroup;

/**
 * The dependencies between the chunks of a file after the merges of a cut. The corners of a chunk's
 * tetrahedra become the ancestors of its points, which may belong to other chunks.
 *
 * Immutable and thread safe. Memory: four bytes for each point of the file, and some more for each
 * point that a chunk takes from another one.
 */
class GATUN_EXPORT CoarseLayout
{
public:
  /** Throws InvalidInput if the cut is not one of the tree, or a point without a cell is merged. */
  CoarseLayout(std::shared_ptr<const FileReader> file, const MergeTree& tree, MergeCut cut);

  /** The dependencies of some chunks only; others have no sources. */
  CoarseLayout(std::shared_ptr<const FileReader> file, const MergeTree& tree, MergeCut cut,
    std::span<const std::uint32_t> chunks);

  const std::shared_ptr<const FileReader>& GetFile() const { return this->File; }
  const MergeCut& GetCut() const { return this->Cut; }

  /** A box around a chunk after the merges. */
  Bounds GetBounds(std::uint32_t chunk, std::size_t step) const;

  /** The part of a chunk's points that are not merged into others. */
  double GetShareLeft(std::uint32_t chunk) const;

  /** The chunks that differ from those after the merges of another cut of the same file, ascending:
   * those with a point whose ancestor is another one. */
  std::vector<std::uint32_t> FindChanges(const CoarseLayout& other) const;

  /** The ancestor of each point of the file. */
  const std::vector<std::uint32_t>& GetAncestors() const { return this->Cut.GetAncestors(); }

  /** The points of a chunk by their numbers in the file, in the order of ChunkSetDecoder. */
  std::vector<std::uint32_t> GetPoints(std::uint32_t chunk) const;

  /** Calls use(first, last) for ascending runs of the points of a chunk. */
  void EachRun(std::uint32_t chunk,
    const std::function<void(std::uint32_t first, std::uint32_t last)>& use) const
  {
    EachRun(*this->File, chunk, use);
  }
  static void EachRun(const FileReader& file, std::uint32_t chunk,
    const std::function<void(std::uint32_t first, std::uint32_t last)>& use);

  /** Whether a chunk uses a point. */
  bool Has(std::uint32_t chunk, std::uint32_t point) const;

  /** The other chunks whose points are ancestors of points of this chunk, ascending. */
  std::span<const std::uint32_t> GetSources(std::uint32_t chunk) const
  {
    return this->Sources[chunk];
  }

  /** The points of a chunk that are ancestors of points of other chunks, ascending. A shared point
   * is provided by the first of its chunks. */
  std::span<const std::uint32_t> GetGiven(std::uint32_t chunk) const { return this->Given[chunk]; }

  /** The chunk that provides a used point. */
  std::uint32_t GetGiver(std::uint32_t point) const;

  /** The group of a shared point, null for other points. */
  const SharedGroup* FindGroup(std::uint32_t point) const;

private:
  void Check(const MergeTree& tree) const;
  void FindSources(std::uint32_t chunk);

  std::shared_ptr<const FileReader> File;
  MergeCut Cut;
  std::vector<std::vector<std::uint32_t>> Sources;
  std::vector<std::vector<std::uint32_t>> Given;
  std::vector<std::shared_ptr<const BlockEntry>> Blocks;            // all of the file
  std::vector<std::pair<std::uint32_t, const SharedGroup*>> Groups; // theirs, by their first points
};
}

#endif
