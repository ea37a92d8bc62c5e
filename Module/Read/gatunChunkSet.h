// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkSet_h
#define gatunChunkSet_h

#include "gatunFileReaderInternals.h"
#include "gatunPieceRequest.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * The layout of a mesh that consists of a set of chunks. The points are sorted: groups of shared
 * points that the set uses, in the order of the file, then own points chunk by chunk, then unused
 * points. Time and memory grow with the set, not with the file.
 */
class ChunkSet
{
public:
  static constexpr std::uint64_t Absent = ~std::uint64_t{ 0 };

  /** A block of shared points that the set uses, or the unused points, and their positions. */
  struct Block
  {
    std::uint32_t Index = 0;               // in the file
    std::vector<std::uint64_t> GroupStart; // the position of each group, or Absent
  };

  /** universe: see PieceRequest. It determines the points that belong to the set. */
  ChunkSet(const FileReader::Internals& content, std::vector<std::uint32_t> chunks,
    std::vector<std::uint32_t> universe, bool withUnusedPoints, PieceForm form);

  std::uint64_t GetNumberOfPoints() const { return this->Points; }

  /** The form of the cells: tetrahedra if all cells are. */
  PieceForm GetForm() const { return this->Form; }
  std::uint64_t GetNumberOfCells() const { return this->Ends.Cells; }

  /** The points of all cells, and the values of the faces of polyhedra: see PieceTarget. */
  std::uint64_t GetConnectivitySize() const { return this->Ends.Corners; }
  std::uint64_t GetFacesSize() const { return this->Ends.FaceValues; }

  /** The chunks by their numbers in the file. Other methods number them by their index here. */
  const std::vector<std::uint32_t>& GetChunks() const { return this->Chunks; }

  /** The first cell of the i-th chunk, and the number of its cells. */
  std::uint64_t GetFirstCell(std::size_t i) const { return this->Begins[i].Cells; }
  std::uint64_t GetNumberOfCells(std::size_t i) const;

  /** Where the points and the faces of the i-th chunk's cells begin. */
  std::uint64_t GetFirstCorner(std::size_t i) const { return this->Begins[i].Corners; }
  std::uint64_t GetFirstFaceValue(std::size_t i) const { return this->Begins[i].FaceValues; }

  /** The first own point of the i-th chunk. */
  std::uint64_t GetFirstOwnPoint(std::size_t i) const { return this->FirstOwn[i]; }

  std::uint64_t GetFirstUnusedPoint() const { return this->FirstUnused; }

  /** The blocks in the order of the file. */
  const std::vector<Block>& GetBlocks() const { return this->Blocks; }

  /** The index in GetBlocks() of a block of the file, which must be there. */
  std::size_t FindBlock(std::uint32_t index) const;

  /** Whether the set contains all chunks and unused points, so that an order can be restored. */
  bool IsWhole() const;

  /** Whether the points of a group belong to the set: they belong to the lowest chunk of the
   * universe that uses them. */
  bool Owns(const SharedGroup& group) const;

  /** Sets 0 for points that belong to the set and 1 for those that belong to other chunks. */
  void MarkOwners(unsigned char* ghosts) const;

  /** The positions in this set of the points of a subset of the chunks, in the order of the subset.
   */
  std::vector<std::uint64_t> Locate(const ChunkSet& part) const;

private:
  const FileReader::Internals& Content;
  std::vector<std::uint32_t> Chunks;
  std::vector<std::uint32_t> Universe;
  bool WithUnused;
  PieceForm Form;
  std::uint64_t Points = 0;

  /** Positions in the lists of cells. */
  struct Position
  {
    std::uint64_t Cells = 0;
    std::uint64_t Corners = 0;
    std::uint64_t FaceValues = 0;
  };
  Position Ends;
  std::vector<Position> Begins; // of each chunk
  std::vector<std::uint64_t> FirstOwn;
  std::uint64_t FirstUnused = 0;
  std::vector<Block> Blocks;
};
}

#endif
