// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunCoarseLayout_h
#define gatunCoarseLayout_h

#include "gatunFileReader.h"
#include "gatunMergeTree.h"
#include "gatunTables.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/**
 * Which chunks of a file get points from which others after so many merges: a chunk's tetrahedra
 * have the ancestors of its points as corners, wherever those are.
 *
 * Immutable and thread safe once made. Memory: four bytes a point of the file, and some for each
 * point that a chunk gets from another one.
 */
class CoarseLayout
{
public:
  CoarseLayout(std::shared_ptr<const FileReader> file, const MergeTree& tree, std::size_t merges);

  std::size_t GetMerges() const { return this->Merges; }

  /** Of each point of the file. */
  const std::vector<std::uint32_t>& GetAncestors() const { return this->Ancestors; }

  /** Points of a chunk by the file's numbers, in the order in which ChunkSetDecoder gives them. */
  std::vector<std::uint32_t> GetPoints(std::uint32_t chunk) const;

  /** Calls use(first, last) for runs of the points of a chunk, ascending. */
  void EachRun(std::uint32_t chunk,
    const std::function<void(std::uint32_t first, std::uint32_t last)>& use) const;

  /** Whether a point is an own or a shared one of a chunk. */
  bool Has(std::uint32_t chunk, std::uint32_t point) const;

  /** Other chunks that have points which points of this one are merged into; ascending. */
  std::span<const std::uint32_t> GetSources(std::uint32_t chunk) const
  {
    return this->Sources[chunk];
  }

  /** Points of a chunk that points of others are merged into; ascending. Of the chunks that share a
   * point, the first gives it. */
  std::span<const std::uint32_t> GetGiven(std::uint32_t chunk) const { return this->Given[chunk]; }

  /** The chunk that gives a point which is used. */
  std::uint32_t GetGiver(std::uint32_t point) const;

  /** The group of a shared point; null for others. */
  const SharedGroup* FindGroup(std::uint32_t point) const;

private:
  std::shared_ptr<const FileReader> File;
  std::size_t Merges;
  std::vector<std::uint32_t> Ancestors;
  std::vector<std::vector<std::uint32_t>> Sources;
  std::vector<std::vector<std::uint32_t>> Given;
  std::vector<std::pair<std::uint32_t, const SharedGroup*>> Groups; // with their first points
};
}

#endif
