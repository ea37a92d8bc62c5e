// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeSection_h
#define gatunTreeSection_h

#include "gatunArrayInput.h"
#include "gatunTreeLayout.h"
#include "gatunTreeTable.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstdint>
#include <vector>

namespace gatun
{
/** Writes the merge tree of a file: MERG and TREE sections, and a TRNG section for each step. */
class TreeSection
{
public:
  /** Writes the merges. The mesh, which is one part, must have been written. */
  TreeSection(WriterState& state, const WriterPart& part);

  /** The merges in the numbers of the file. */
  const MergeTree& GetTree() const { return this->Layout.GetTree(); }

  /** Adds the ranges of the point arrays after merges to the tables of the last step. */
  void AddStep(const std::vector<ArrayInput>& inputs);

  /** Writes the TREE section. levels: the numbers of merges of the base meshes. */
  void WriteTable(std::vector<std::uint32_t> levels);

private:
  std::vector<std::uint32_t> GetPointOrder() const;
  void FindBoxes();
  void WriteMerges();

  WriterState& State;
  const WriterPart& Part;
  TreeLayout Layout;
  TreeTable Tree;
};
}

#endif
