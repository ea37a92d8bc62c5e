// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeParts_h
#define gatunTreeParts_h

#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"
#include "gatunTreeSection.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** A mesh of a file whose merges are to be written: the whole one or a base mesh. */
struct MeshOfTree
{
  std::uint32_t FirstMerge = 0; ///< the merges before lead to it

  /** The numbers in the tree of the mesh's points. */
  std::span<const std::uint32_t> Points;

  /** Begins the section of a tree in the numbers of the mesh. */
  std::function<TreeSection&(MergeTree)> Begin;
};

/** Writes the merges of a mesh and of its base meshes. Each merge is stored once, in the numbers of
 * the last base mesh before it, by which the merges of a round are sorted. */
class TreeParts
{
public:
  using Progress = std::function<bool(double)>;

  /** Writes the merges into the section of the first mesh, which is the whole one. */
  TreeParts(MergeTree tree, std::vector<MeshOfTree> meshes);

  /** The tree with the merges in the order of the file. */
  const MergeTree& GetTree() const { return this->Tree; }

  /** Writes the dependencies between the merges of that tree. */
  void WriteDependencies(const MergeDependencies& dependencies, const Progress& progress);

private:
  MergeTree Sort(MergeTree tree) const;
  std::uint32_t GetEnd(std::size_t mesh) const;

  std::vector<MeshOfTree> Meshes;
  MergeTree Tree;
  std::vector<TreeSection*> Sections; // of the meshes
};
}

#endif
