// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshDependencies_h
#define gatunMeshDependencies_h

#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"
#include "gatunMeshAccess.h"

#include <functional>
#include <memory>
#include <optional>

namespace gatun
{
class FileReader;

/** Finds the dependencies between the merges of a mesh's tetrahedra, or of a surface's triangles.
 * None if that might take more than time in proportion to the cells, as the merges gather too many
 * of them around one point; BuildMergeTree makes no such trees. About 140 bytes a tetrahedron while
 * it runs. Progress: see MergeDependencies. */
std::optional<MergeDependencies> FindDependencies(const MeshAccess& mesh, const MergeTree& tree,
  bool isSurface, const std::function<bool(double)>& progress = {});

/** The same for the mesh of a file, which is decoded as a whole. tree: the file's. */
std::optional<MergeDependencies> FindDependencies(const std::shared_ptr<const FileReader>& file,
  const MergeTree& tree, const std::function<bool(double)>& progress = {});
}

#endif
