// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWriterState_h
#define gatunWriterState_h

// The state that the sections of a file share while it is written.

#include "gatunMeshAccess.h"
#include "gatunMeshTable.h"
#include "gatunMetaTable.h"
#include "gatunOutputFile.h"
#include "gatunPartition.h"
#include "gatunSharedGroups.h"
#include "gatunStepTables.h"
#include "gatunWriterOptions.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace gatun
{
// The number of chunks that are encoded before their streams are written. It bounds the memory and
// keeps threads busy.
constexpr std::size_t ChunksPerBatch = 32;

/** Collects streams and writes them as one section. */
class StreamBatch
{
public:
  /** Appends a stream. where receives its position, which is valid after Write. */
  void Add(const Bytes& bytes, StreamRef& where)
  {
    where = { this->Payload.Data.size(), bytes.size(), Checksum(bytes) };
    this->Payload.PutBytes(bytes);
    this->Added.push_back(&where);
  }

  /** Writes the section, unless there are no streams, and clears the batch. isShared: whether
   * other meshes may have some of the streams, too. */
  void Write(
    OutputFile& file, FourCC name, std::uint16_t flags = FlagMandatory, bool isShared = true)
  {
    if (this->Added.empty())
    {
      return;
    }
    const auto offset = file.AddSection(name, this->Payload.Data, flags);
    for (auto* where : this->Added)
    {
      where->Offset += offset;
    }
    if (isShared)
    {
      const StreamRef* const* const added = this->Added.data();
      file.DivideLast({ added, this->Added.size() });
    }
    this->Added.clear();
    this->Payload.Data.clear();
  }

private:
  ByteWriter Payload;
  std::vector<StreamRef*> Added;
};

/** The points of all parts that no cell uses. They are one block, which is written last. */
struct UnusedPoints
{
  Bytes Coordinates;
  std::vector<std::uint64_t> Numbers;     // original ones
  std::vector<std::vector<Bytes>> Values; // of each step, of each point array
};

/** A file that is being written: its tables so far. */
class WriterState
{
public:
  WriterState(const std::string& path, const std::vector<ArrayDescription>& arrays,
    const WriterOptions& options);

  /** A file that begins with the sections of another one, which it replaces. */
  WriterState(const InputFile& before, const WriterOptions& options);

  /** The part of a file that one of several processes writes, in a temporary file in a folder. */
  WriterState(const std::vector<ArrayDescription>& arrays, const WriterOptions& options,
    const std::string& folder);

  /** A mesh that is embedded in another file. */
  WriterState(const WriterState& whole, const std::vector<ArrayDescription>& arrays,
    const WriterOptions& options);

  /** Adds the counts and types of a part. Throws Error(InvalidInput) if it has another type of
   * coordinates than the parts before. */
  void Describe(const MeshAccess& part);

  /** The limits of the chunks of a part. */
  ChunkLimits GetChunkLimits(const MeshAccess& part) const;

  /** Makes the blocks of shared points when the groups of all parts are known. */
  void LinkGroups();

  /** Adds the table of a time step whose values are all in the file. */
  void AddStep(const StepTable& step);

  /** Writes the tables of time steps, cells, blocks and chunks. */
  void WriteTables(OutputFile& file);

  /** Moves a file to its path when all sections have been added. Returns the statistics. */
  FileStatistics Commit(OutputFile& file);

  const WriterOptions Options;
  OutputFile File;
  MetaTable Meta;
  MeshTable Table;
  StepTables Steps;
  SharedGroups Groups;
  UnusedPoints Unused;
  CellTable Cells;
  bool HasCells = false; // whether not all cells are tetrahedra
  std::uint64_t NumberOfCells = 0;
  std::array<std::uint64_t, 256> TypeCounts{};
  ShapeTable Shapes;
  FileStatistics Statistics;

private:
  void DescribeArrays(const std::vector<ArrayDescription>& arrays);
};

/** Runs encode(chunk) for batches of chunks in parallel and finish(first, count) after each. */
void ForEachBatch(std::size_t chunks, const std::function<void(std::size_t)>& encode,
  const std::function<void(std::size_t, std::size_t)>& finish,
  const std::function<bool(double)>& progress);
}

#endif
