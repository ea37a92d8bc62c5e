// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWriterPart_h
#define gatunWriterPart_h

#include "gatunChunkCodec.h"
#include "gatunMeshAccess.h"
#include "gatunMeshInput.h"
#include "gatunMeshTable.h"
#include "gatunPartition.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/** The data of a chunk from which the values of its arrays are predicted. */
struct ChunkState
{
  ChunkMesh Mesh;                     // without its cells if there are no cell arrays
  std::vector<std::uint32_t> PointOf; // the input's point of each vertex of the walk
  std::vector<std::uint32_t> CellOf;  // the input's cell of each one of the walk
};

/** The position of a part in a file. */
struct PartPlace
{
  std::size_t FirstChunk = 0;
  std::size_t FirstBlock = 0; // of the shared points that this part writes
  std::size_t Blocks = 0;
  std::uint64_t FirstPoint = 0; // original numbers
  std::uint64_t FirstCell = 0;
  bool IsFirst = true; // of the file
  bool IsLast = true;
  bool IsFirstHere = true; // of those that this process writes
};

/** A part of the mesh of a file: its input, its chunks and their shared points. */
class WriterPart
{
public:
  explicit WriterPart(const MeshInput& mesh)
    : Mesh(mesh)
  {
  }

  /** Makes the list of shared points once the blocks of the file are known. groups: the points of
   * each set of chunks of the file, of which at least one is a chunk of this part. */
  void PlaceShared(
    const MeshTable& table, const std::map<ChunkGroup, std::vector<std::uint32_t>>& groups);

  /** The points of a block that this part writes. block: 0 is the first one of this part. */
  std::span<const std::uint32_t> GetBlockPoints(const MeshTable& table, std::size_t block) const;

  /** All shared points of a chunk of this part, in the order of the file. */
  std::vector<std::uint32_t> GetSharedPoints(const MeshTable& table, std::size_t chunk) const;

  /** The cells of a chunk. */
  std::span<const std::uint32_t> GetCells(std::size_t chunk) const
  {
    return this->Layout.GetCells(chunk);
  }

  /** The number of points or cells, whichever the array belongs to. */
  std::size_t GetTupleCount(const ArrayDescription& array) const
  {
    const auto& mesh = this->Mesh.GetMesh();
    return static_cast<std::size_t>(array.Where == Association::Point ? mesh.Points : mesh.Cells);
  }

  /** The original number of a point in the file. */
  std::uint64_t GetPointNumber(std::uint32_t point) const
  {
    return this->PointNumbers.empty() ? this->Place.FirstPoint + point : this->PointNumbers[point];
  }

  const MeshAccess Mesh;
  PartPlace Place;
  Partition Layout;                        // without shared points once they are placed
  std::vector<std::uint32_t> SharedPoints; // of the blocks of this part, then those of others
  std::vector<std::uint64_t> PointNumbers; // empty: consecutive
  std::vector<ChunkState> Chunks;

private:
  /** The positions in SharedPoints of the groups that other parts write, by block and group. */
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> OtherGroups;
};
}

#endif
