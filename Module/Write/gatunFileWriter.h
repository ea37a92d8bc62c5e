// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileWriter_h
#define gatunFileWriter_h

#include "gatunExport.h"
#include "gatunFieldData.h"
#include "gatunMeshInput.h"
#include "gatunTypes.h"
#include "gatunWriterOptions.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/**
 * Writes one mesh and any number of time steps of its arrays as a .gtn file. If the mesh changes
 * over time, other meshes can be added.
 *
 * The file appears at its path when Finish returns. Until then, and after any failure, an existing
 * file is untouched. The writer uses all threads; the bytes do not depend on their
 * number. Peak memory is below 3 times the size of the mesh and one step of its arrays, or below 2
 * times without time steps and hierarchy; base meshes take as much again, and dependencies 140
 * bytes a tetrahedron.
 *
 * Every method may throw Error (InvalidInput, CannotWrite, Aborted), after which only the
 * destructor may be called. Not thread safe.
 */
class GATUN_EXPORT FileWriter
{
public:
  /** Receives the completed fraction of the current call, 0 to 1, and returns false to abort.
   * Called only from the thread that called the writer. */
  using Progress = std::function<bool(double)>;

  /** Partitions the mesh and makes a temporary file in the folder of path. Throws if a tetrahedron
   * refers to a point that does not exist. Array names may repeat; their order is kept. The mesh is
   * encoded with the first step, or by Finish if there is none. */
  FileWriter(const std::string& path, const MeshInput& mesh,
    const std::vector<ArrayDescription>& arrays, const WriterOptions& options,
    const Progress& progress = {});

  /** Tells a constructor that time steps are added to a file. */
  struct Append
  {
  };

  /**
   * Adds time steps to a file that has time: first AddMesh, then the steps of this mesh, and so on.
   * Times come after those of the file. Meshes have the arrays, kept order, chunk size and key
   * steps of the file, whatever the options say, and are surfaces if its first mesh is one.
   * Sections that are in the file already are stored once.
   *
   * The bytes of the file are copied and checked; it is replaced by Finish, unless another program
   * has changed it by then. Throws Error of any kind if it cannot be read.
   */
  FileWriter(Append, const std::string& path);

  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /**
   * Adds a time step with the values of all arrays, in the order of the descriptions. Times must
   * ascend strictly. A mesh without time needs one call with hasTime false. A file without any step
   * is valid and has no values. The values of an array are consecutive tuples: Points or Tets times
   * Components values. coordinates: of the points at this step if they move
   * (WriterOptions::PointsMove), as MeshInput::Coordinates; null for those of the mesh, as at the
   * first step. remaining: the remaining cells, if some of the mesh are deleted; values and
   * coordinates are for these cells and their points only. It needs time, an earlier step with all
   * cells of the mesh, and no hierarchy and no boundary.
   */
  void WriteStep(std::span<const void* const> values, const FieldData& field = {},
    bool hasTime = false, double time = 0, const Progress& progress = {},
    const void* coordinates = nullptr, const RemainingCells* remaining = nullptr);

  /** The arrays of all meshes. */
  const std::vector<ArrayDescription>& GetArrays() const { return this->Arrays; }

  /** Adds a mesh for the next steps. It has the same arrays. The options are those of the first
   * mesh, except Tree and the values of Layers. Ends the steps of the previous mesh. Returns the
   * number of the mesh; the first mesh of a file has 0. Needs time. */
  std::uint32_t AddMesh(
    const MeshInput& mesh, const WriterOptions& options, const Progress& progress = {});

  /** Selects the mesh of the next steps: the last one, or the first one if this writer made it. */
  void UseMesh(std::uint32_t mesh);

  /** Completes the file and moves it to its path. */
  FileStatistics Finish();

  class Internals;

private:
  std::unique_ptr<Internals> Self;
  std::vector<ArrayDescription> Arrays; // without coordinates
};
}

#endif
