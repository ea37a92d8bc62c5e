// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWriterState_h
#define gatunWriterState_h

// The state that the sections of a file share while it is written.

#include "gatunChunkCodec.h"
#include "gatunMeshAccess.h"
#include "gatunMeshInput.h"
#include "gatunOutputFile.h"
#include "gatunPartition.h"
#include "gatunTables.h"
#include "gatunWriterOptions.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
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

  /** Writes the section, unless there are no streams, and clears the batch. */
  void Write(OutputFile& file, FourCC name, std::uint16_t flags = FlagMandatory)
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
    this->Added.clear();
    this->Payload.Data.clear();
  }

private:
  ByteWriter Payload;
  std::vector<StreamRef*> Added;
};

/** The data of a chunk from which the values of its arrays are predicted. */
struct ChunkState
{
  ChunkMesh Mesh;                     // without its cells
  std::vector<std::uint32_t> PointOf; // the input's point of each vertex of the walk
  std::vector<std::uint32_t> CellOf;  // the input's cell of each one of the walk
};

/** A file that is being written: its input, its tables so far, and the state of its chunks. */
class WriterState
{
public:
  WriterState(const std::string& path, const MeshInput& mesh,
    const std::vector<ArrayDescription>& arrays, const WriterOptions& options);

  /** A base mesh of another file. */
  WriterState(const WriterState& whole, const MeshInput& mesh, const WriterOptions& options);

  /** The input's points of a block of shared points. */
  std::span<const std::uint32_t> GetBlockPoints(std::size_t block) const;

  /** The number of points or cells, whichever the array belongs to. */
  std::size_t GetTupleCount(const ArrayDescription& array) const;

  const MeshAccess Mesh;
  const WriterOptions Options;
  OutputFile File;
  MetaTable Meta;
  MeshTable Table;
  CellTable Cells; // if not all cells are tetrahedra
  Partition Parts;
  std::vector<ChunkState> Chunks;
  FileStatistics Statistics;

private:
  void Describe(const std::vector<ArrayDescription>& arrays);
};

/** Runs encode(chunk) for batches of chunks in parallel and finish(first, count) after each. */
void ForEachBatch(std::size_t chunks, const std::function<void(std::size_t)>& encode,
  const std::function<void(std::size_t, std::size_t)>& finish,
  const std::function<bool(double)>& progress);
}

#endif
