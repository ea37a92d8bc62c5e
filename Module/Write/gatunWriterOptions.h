// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWriterOptions_h
#define gatunWriterOptions_h

#include "gatunErrorBound.h"
#include "gatunLayers.h"
#include "gatunMergeTree.h"
#include "gatunTypes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace gatun
{
/** Options of FileWriter. */
struct WriterOptions
{
  std::uint8_t Keep = KeepNone; ///< the parts of the original order to keep, flags of KeepOrder

  /** The maximum number of cells in a chunk, 64 to 1048576; in the small profile, cells count as
   * the tetrahedra that they can be split into. 0 is 65536, or 131072 for meshes of more than one
   * million and 262144 for more than 10 million; with layers, a quarter of that. */
  std::uint32_t ChunkSize = 0;

  /** The expected number of parts of the mesh, of about the same size. Without ChunkSize, it
   * determines the size of chunks. */
  std::uint32_t Parts = 1;

  /** The interval of time steps that are coded independently of their predecessor, 1 or more. */
  std::uint32_t KeyStepInterval = 8;

  /** Whether each time step has coordinates of its own (FileWriter::WriteStep). The cells stay the
   * same. Not possible for a mesh that comes in parts. */
  bool PointsMove = false;

  /** Whether the mesh is a surface (vtkPolyData): vertices, lines, polygons and triangle strips, in
   * this order. Layers are not possible. A tree of merges is one of its triangles. */
  bool IsSurface = false;

  /** A merge tree of all points of the mesh, or null. It must exist until Finish has returned. */
  const MergeTree* Tree = nullptr;

  /** Whether to store the dependencies between merges (MergeDependencies), also for the boundary:
   * some 3 bytes a point. Otherwise readers decode the mesh, or the finest base mesh of up to 4
   * million tetrahedra. */
  bool Dependencies = false;

  /** The maximum number of base meshes to store: with an eighth of the points, or with half of
   * those of a surface, and each further one with half, down to some 20,000 tetrahedra or cells of
   * a surface. Base meshes need a tree. */
  unsigned Levels = 0;

  /** If not empty, the numbers of merges that lead to base meshes, ascending, in place of Levels.
   */
  std::vector<std::uint32_t> LevelMerges;

  /** Whether to store the boundary of the mesh as a surface: the faces that only one cell has, and
   * the cells that are surfaces, lines and vertices, with all arrays and time steps. Not possible
   * for surfaces. Nonlinear cells have the faces of the linear ones with their corners; convex
   * point sets have none. */
  bool Boundary = false;

  /** The arrays whose values may have an error, with their bounds. Others are exact, and so are
   * NaN, infinities, integers with bounds below 1, components that are constant if the bound is
   * relative, ids (global ids, pedigree ids, and all of vtkIdType) and vtkGhostType. Relative
   * bounds refer to the range of all parts at each time step. */
  std::vector<ArrayError> Errors;

  /** What the file is optimized for. */
  Profile Coding = Profile::Fast;

  /** The layers to organize the file and its base meshes by, if any. */
  std::optional<LayerRequest> Layers;
};
}

#endif
