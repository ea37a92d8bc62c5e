// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeSection_h
#define gatunTreeSection_h

#include "gatunArrayInput.h"
#include "gatunTreeLayout.h"
#include "gatunTreeTable.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** Writes the merge tree of a file: MERG, DEPS and TREE sections, and a TRNG section for each step.
 */
class TreeSection
{
public:
  using GetValue = TreeLayout::GetValue;

  /** When all of the mesh has been written. tree: in the numbers of the file. getCoordinates: those
   * along an axis; NaN does not count. */
  TreeSection(WriterState& state, MergeTree tree,
    const std::function<GetValue(unsigned axis)>& getCoordinates);

  /** Writes the first merges of this file's tree, or those that lead from one base mesh to the next
   * one. To be called for all of these meshes, in their order; not in a base mesh. mesh: of the
   * file or the base mesh. map: the numbers in the next one of the points that are left. */
  void AddPart(
    const TreeSection& mesh, std::size_t merges, std::span<const std::uint32_t> map = {});

  /** Writes what the merges of a part, and all later ones, depend on in this part. */
  void AddDependencies(std::size_t part, const Bytes& stream);

  /** The merges in the numbers of the file. */
  const MergeTree& GetTree() const { return this->Layout.GetTree(); }

  /** Adds the ranges of the point arrays after merges to the tables of a step. getValues: those of
   * an array that a range of ArrayRanges is for. stepsAfter: how many steps have been added since.
   */
  void AddStep(const std::function<GetValue(std::size_t array, std::size_t range)>& getValues,
    std::size_t stepsAfter = 0);

  /** Writes the TREE section. levels: the numbers of merges of the base meshes. */
  void WriteTable(std::vector<std::uint32_t> levels);

private:
  void FindBoxes(const std::function<GetValue(unsigned axis)>& getCoordinates);

  WriterState& State;
  TreeLayout Layout;
  TreeTable Tree;
};

/** The number in the file of each point of a part whose mesh has been written; None if it has none
 * yet, as points that no cell uses. firstOwn: that of the first own point of the part. */
std::vector<std::uint32_t> FindFileNumbers(
  const WriterState& state, const WriterPart& part, std::uint64_t firstOwn);
}

#endif
