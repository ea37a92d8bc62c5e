// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTreeTable_h
#define gatunTreeTable_h

// What TREE and TRNG sections say: how the mesh of a file becomes simpler. See
// Documentation/format.md, 13.

#include "gatunContainer.h"
#include "gatunTables.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The tree of merges, and where chunks can get to by it. */
struct TreeTable
{
  static constexpr std::size_t MaxRungs = 64;

  std::uint32_t Merges = 0;
  StreamRef Stream;

  /** Numbers of merges, ascending; the last is all of them. */
  std::vector<std::uint32_t> Rungs;

  /** Of each chunk, for each rung: where its points are after any number of merges up to there. */
  std::vector<std::vector<Bounds>> Boxes;

  /** Of each base mesh, how many merges it has behind it; ascending. */
  std::vector<std::uint32_t> Levels;

  Bytes Write() const;
  static TreeTable Read(
    std::span<const std::uint8_t> bytes, const MetaTable& meta, const MeshTable& mesh);

  /** The first rung that so many merges do not reach beyond. */
  std::size_t FindRung(std::size_t merges) const;
};

/** The values that a chunk's points can get by merges, at one time step. */
struct TreeStepTable
{
  /** Of each point array (those of cells have none), of each chunk, for each rung. */
  std::vector<std::vector<std::vector<ArrayRanges>>> Ranges;

  Bytes Write() const;
  static TreeStepTable Read(std::span<const std::uint8_t> bytes, const MetaTable& meta,
    const MeshTable& mesh, const TreeTable& tree);
};
}

#endif
