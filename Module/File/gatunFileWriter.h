// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileWriter_h
#define gatunFileWriter_h

#include "gatunFieldData.h"
#include "gatunLayers.h"
#include "gatunMergeTree.h"
#include "gatunMeshInput.h"
#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
struct WriterOptions
{
  std::uint8_t Keep = KeepNone; ///< which original order to keep: flags of KeepOrder

  /** Tetrahedra a chunk at most, 64 to 1048576; 0: 65536, or 262144 for over 10 million tets; with
   * layers the half. */
  std::uint32_t ChunkTets = 0;

  /** Every how many time steps one is coded without its predecessor, 1 or more. */
  std::uint32_t KeyStepInterval = 8;

  /** Whether to replace an existing file that may not be written, which otherwise is an error. */
  bool ReplaceReadOnly = false;

  /** How the mesh becomes simpler: a tree of its points, all of them, or null. It must stay where
   * it is until Finish has returned. */
  const MergeTree* Tree = nullptr;

  /** How many base meshes to store at most: with a half of the points, a quarter and so on, down to
   * some 20,000 tetrahedra. They need a tree. */
  unsigned Levels = 0;

  /** To organise the file, and its base meshes, by layers of an array's values. */
  std::optional<LayerRequest> Layers;
};

/**
 * Writes one mesh and any number of time steps of its arrays as a .gtn file.
 *
 * The file appears under its name only when Finish returns; until then, and after any failure, a
 * file that was there before is untouched. All threads of vtkSMPTools are used; the bytes do not
 * depend on their number. Peak memory is below 3 times the mesh and one step of its arrays; base
 * meshes take as much again.
 *
 * Every method may throw gatun::Error (InvalidInput, CannotWrite, Aborted), after which only the
 * destructor may be called. Not thread safe.
 */
class VTKGATUNCORE_EXPORT FileWriter
{
public:
  /** Called with the fraction done of the current call, 0 to 1; returns false to abort. Only ever
   * called from the thread that called the writer. */
  using Progress = std::function<bool(double)>;

  /** Opens a temporary file next to path and partitions the mesh. Throws when a tetrahedron names
   * a point that does not exist. Array names may repeat; their order is kept. */
  FileWriter(const std::string& path, const MeshInput& mesh,
    const std::vector<ArrayDescription>& arrays, const WriterOptions& options,
    const Progress& progress = {});
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /**
   * Adds the values of all arrays, in the order of the descriptions, at a time. Times must ascend
   * strictly. A mesh without time is written by one call with hasTime false; a file without any
   * call is valid, and has no values when it has arrays of no tuples or none.
   * Values are tuples one after the other: Points or Tets times Components values.
   */
  void WriteStep(std::span<const void* const> values, const FieldData& field = {},
    bool hasTime = false, double time = 0, const Progress& progress = {});

  /** Completes the file and gives it its name. */
  FileStatistics Finish();

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
