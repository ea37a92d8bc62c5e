// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTablePages_h
#define gatunTablePages_h

#include "gatunCache.h"
#include "gatunInputFile.h"
#include "gatunMeshPages.h"
#include "gatunMetaTable.h"
#include "gatunStepPages.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/**
 * The tables of chunks, blocks and time steps of an open file: sizes of all chunks, and pages with
 * the rest, which are read when they are needed. So the time and memory that a file takes to open
 * grow little with the number of its chunks.
 *
 * Thread safe, except AddStep. Safe on hostile input: throws Error.
 */
class TablePages
{
public:
  /** Reads the table and the summaries of chunks. file and meta must outlive this object. cells:
   * null if all cells are tetrahedra. */
  TablePages(const InputFile& file, const MetaTable& meta, const CellTable* cells);

  /** The step with the coordinates of a step, 0 for the coordinates of the mesh. */
  std::size_t GetPointStep(std::size_t step) const
  {
    return this->Meta.PointsMove && !this->PointSteps.empty() ? this->PointSteps.at(step).Step : 0;
  }

  /** The step from which the coordinates of a step may be predicted. */
  std::size_t GetPointReference(std::size_t step) const
  {
    return this->PointSteps.at(step).Reference;
  }

  /** Reads the table of the next time step. */
  void AddStep(const StreamRef& where, std::span<const std::uint8_t> bytes);

  const MeshIndex& GetIndex() const { return this->Index; }
  const std::vector<StepIndex>& GetSteps() const { return this->Steps; }
  const std::vector<ChunkInfo>& GetChunks() const { return this->Summaries.Infos; }

  std::uint64_t GetNumberOfCells() const;
  std::uint64_t GetSharedPoints() const { return this->Index.GetSharedPoints(); }
  std::size_t GetNumberOfBlocks() const;

  /** The sizes of the cells of a chunk. */
  CellSizes GetSizes(std::size_t chunk) const;

  /** The size in the file of the mesh of a chunk, without shared points. */
  std::uint64_t GetMeshBytes(std::size_t chunk) const;

  /** The streams of a chunk and its shared points. */
  std::shared_ptr<const ChunkEntry> GetChunk(std::size_t chunk) const;

  /** A block of shared points. The unused points are the block after the last one. */
  std::shared_ptr<const BlockEntry> GetBlock(std::size_t block) const;

  /** The other chunks that share points with a chunk, ascending. */
  std::vector<std::uint32_t> GetNeighbors(std::size_t chunk) const;

  /** See FindSharedUsers. */
  std::vector<std::uint32_t> GetSharedUsers(std::size_t chunk) const;

  /** The values of an array at a step. Throw if the stream cannot contain them. */
  // Those of the array from which the array is copied, if it is. Empty for coordinates of the mesh.
  StreamRef GetChunkValues(std::size_t chunk, std::size_t array, std::size_t step) const;
  StreamRef GetBlockValues(std::size_t block, std::size_t array, std::size_t step) const;

  ArrayRanges GetChunkRanges(std::size_t chunk, std::size_t array, std::size_t step) const;

  /** Where the pages with the details of the mesh and of all time steps are. */
  std::vector<StreamRef> ListPages() const;

  /** Adds the bytes of streams of the mesh and of its values to the statistics of the file. Reads
   * all pages. */
  void AddBytes(FileStatistics& statistics) const;

  /** Throws unless chunks and groups of shared points name each other. Reads all pages. */
  void CheckGroups() const;

private:
  struct LinkedChunk;

  void AddMeshBytes(FileStatistics& statistics) const;

  std::shared_ptr<const MeshPage> GetMeshPage(std::size_t page) const;
  std::shared_ptr<const StepPage> GetStepPage(std::size_t page, std::size_t step) const;
  /** The step whose tables have an array of a step. */
  std::size_t FindStep(std::size_t array, std::size_t step) const
  {
    return this->Meta.IsPoints(array) ? this->GetPointStep(step) : step;
  }

  std::size_t FindPage(std::size_t block) const;
  LinkedChunk LinkChunk(std::size_t chunk) const;

  const InputFile& File;
  const MetaTable& Meta;
  const CellTable* const Cells;
  MeshIndex Index;
  ChunkSummaries Summaries;
  std::vector<StepIndex> Steps;

  struct PointStep
  {
    std::size_t Step;      // which has the coordinates
    std::size_t Reference; // from which they may be predicted
  };
  std::vector<PointStep> PointSteps;                              // if the points move
  std::size_t KeyStep = 0;                                        // the last one
  mutable Cache<std::pair<std::size_t, std::size_t>, void> Pages; // by kind and number
};
}

#endif
