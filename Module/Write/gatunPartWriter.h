// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartWriter_h
#define gatunPartWriter_h

#include "gatunExport.h"
#include "gatunFieldData.h"
#include "gatunMeshInput.h"
#include "gatunTypes.h"
#include "gatunWriterOptions.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
class PartExchange;

/** Options of PartWriter. */
struct PartWriterOptions
{
  /** Options of the file, without a tree. Layers need the whole mesh and are refused. Base meshes
   * need weights. */
  WriterOptions File;

  /** For a hierarchy of the tetrahedra, which is found in parts: the weight of each array for
   * merges, 0 for those that do not count. Not with several processes. It takes 320 MB in each
   * thread and some 50 bytes a point, or 90 with dependencies, while Finish finds it. */
  std::optional<std::vector<double>> Weights;

  /** The most tetrahedra that a thread simplifies at once, at 160 bytes each. It determines the
   * merges. */
  std::uint64_t TetsOfGroup = 2'000'000;

  /** The number of bytes of points on the boundaries of parts that are kept in memory, and again of
   * those that are joined; further ones are in temporary files in the folder of the file. */
  std::size_t SpillMemory = std::size_t{ 32 } << 20;

  /** Whether the global ids mark the points of several parts by ids of 0 and more. These points are
   * compared wherever they are, and points with negative ids are not compared. */
  bool JoinByIdsOnly = false;
};

/** Statistics of PartWriter. */
struct PartStatistics
{
  FileStatistics File;
  std::uint64_t Points = 0; ///< of the file
  std::uint64_t Cells = 0;
  std::uint64_t JoinedPoints = 0; ///< points of parts that are the point of another part

  /** Points at the place of a point of another part that are kept apart because values or global
   * ids differ, and points with the global id of a point elsewhere. */
  std::uint64_t DifferentPoints = 0;

  /** Points that are kept apart because one part has several points at the same place. */
  std::uint64_t AmbiguousPoints = 0;

  std::uint64_t SpilledBytes = 0;
};

/**
 * Writes a mesh that comes in parts as one .gtn file, without ever having the whole mesh in memory.
 *
 * A part is any subset of the cells with their points and arrays; a cell belongs to one part. All
 * parts come twice in the same order, and have to be the same both times:
 *
 *     for each part: Survey(part), and SurveyStep(values) for each time step
 *     for each part: Write(part), and WriteStep(values) for each time step
 *     Finish()
 *
 * Points of different parts are one point if they have the same global id, or without ids the same
 * coordinates, and the same values of all point arrays at all steps. Points with different values
 * are kept apart, as are 0 and -0; coordinates that are not numbers are not compared. Points of one
 * part are never joined. Only points on the boundary of a part are compared, see
 * PartWriterOptions::JoinByIdsOnly. Cells that are in several parts are written
 * several times.
 *
 * Original numbers (WriterOptions::Keep) count through the parts. A point of several parts has the
 * number of the first one.
 *
 * Memory: the part that the caller has; up to 3 times as much beside it with several time steps,
 * and less than it with one, whose values are encoded together with the mesh; twice the
 * SpillMemory; some 3 KiB and 50 bytes for each array and time step a chunk, most of it for the
 * groups of shared points; up to
 * 512 KiB for each component and step of arrays that have few different values; and the points that
 * no cell uses, with their values. A boundary is in memory, too: some 300 bytes a face and the
 * values of a time step. With KeepPoints also 8 bytes for each point of several parts.
 *
 * Several processes can write a file together. Each one surveys and writes its own parts, or none;
 * the file has the parts of the first process, then those of the second, and so on. All give the
 * same path, arrays and options. EndSurvey and Finish are collective. The other methods, and the
 * constructor, may fail in one process, and the others must learn this: PartExchange::Together does
 * that.
 *
 *     for each part of this process: Survey(part), and SurveyStep(values) for each time step
 *     EndSurvey()
 *     for each part of this process: Write(part), and WriteStep(values) for each time step
 *     Finish()
 *
 * The bytes are those of one process. Between processes go the points on the boundaries of parts,
 * those that no cell uses with their values, and tables: some 300 bytes and 50 bytes for each array
 * and time step a chunk to the first process, and 300 bytes a chunk, the groups of shared points,
 * to each one. Each process writes into a temporary file beside the file, then copies it to its
 * place in the file, which has a temporary name until it is complete. Memory: as above, with the
 * chunks of the whole file; three times the SpillMemory; and in the first process twice the tables
 * of all.
 *
 * The file appears at its path when Finish returns. The bytes do not depend on the number of
 * threads. Every method may throw Error (InvalidInput, CannotWrite, Aborted), after which only the
 * destructor may be called: no temporary file remains. Not thread safe.
 */
class GATUN_EXPORT PartWriter
{
public:
  /** As FileWriter::Progress, for the current call. */
  using Progress = std::function<bool(double)>;

  /** exchange: with the other processes. Null: there are none. */
  PartWriter(const std::string& path, const std::vector<ArrayDescription>& arrays,
    const PartWriterOptions& options, PartExchange* exchange = nullptr);
  ~PartWriter();
  PartWriter(const PartWriter&) = delete;
  PartWriter& operator=(const PartWriter&) = delete;

  /** Looks at the next part. globalIds: one for each point, in all parts or in none. */
  void Survey(
    const MeshInput& part, const std::int64_t* globalIds = nullptr, const Progress& progress = {});

  /** Looks at the next time step of that part. values: as for FileWriter::WriteStep. */
  void SurveyStep(std::span<const void* const> values);

  /** To be called by all processes when each one has surveyed its parts. Needed only if there are
   * several. */
  void EndSurvey();

  /** Writes the next part, the first one after the last call of Survey. The part must exist until
   * its last step has been written. */
  void Write(
    const MeshInput& part, const std::int64_t* globalIds = nullptr, const Progress& progress = {});

  /** Writes the next time step of that part. The field data of the first part are stored. */
  void WriteStep(std::span<const void* const> values, const FieldData& field = {},
    bool hasTime = false, double time = 0, const Progress& progress = {});

  /** Completes the file when all parts have been written, and moves it to its path. progress: of
   * the hierarchy. */
  PartStatistics Finish(const Progress& progress = {});

  class Internals;

private:
  std::unique_ptr<Internals> Self;
};
}

#endif
