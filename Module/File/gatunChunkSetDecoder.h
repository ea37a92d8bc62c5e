// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkSetDecoder_h
#define gatunChunkSetDecoder_h

#include "gatunFileReader.h"
#include "gatunPartDecoder.h"
#include "gatunPieceRequest.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/**
 * Decodes a set of chunks into one mesh without ghosts. The points are sorted: groups of shared
 * points that the set uses, in the order of the file, then own points chunk by chunk, then unused
 * points.
 *
 * Decoded parts are kept in the cache only. Time and memory grow with the set, not with the file.
 */
class ChunkSetDecoder
{
public:
  using Progress = std::function<bool(double)>;

  /** universe: see PieceRequest. It determines the points that belong to the set. */
  ChunkSetDecoder(const std::shared_ptr<ChunkCache>& cache, std::vector<std::uint32_t> chunks,
    std::vector<std::uint32_t> universe, bool withUnusedPoints);

  std::uint64_t GetNumberOfPoints() const { return this->Points; }
  std::uint64_t GetNumberOfTets() const { return this->Tets; }
  const std::vector<std::uint32_t>& GetChunks() const { return this->Chunks; }

  /** The first cell of the i-th chunk of the set. */
  std::uint64_t GetFirstTet(std::size_t i) const { return this->FirstTet[i]; }

  /** Whether the set contains all chunks and unused points, so that an order can be restored. */
  bool IsWhole() const;

  /** Fills the target with the arrays (indices into GetArrays()) of a step. */
  void Fill(const PieceTarget& target, const std::vector<std::uint32_t>& arrays, std::size_t step,
    bool restoreOrder, const Progress& progress) const;

  /** Sets 0 for points that belong to the set and 1 for those that belong to other chunks. */
  void MarkOwners(unsigned char* ghosts) const;

  /** The positions in this set of the points of a subset of the chunks, in the order of the subset.
   */
  std::vector<std::uint64_t> Locate(const ChunkSetDecoder& part) const;

private:
  static constexpr std::uint64_t Absent = ~std::uint64_t{ 0 };

  /** A block of shared points that the set uses, or the unused points, and their positions. */
  struct Block
  {
    std::uint32_t Index = 0;               // in the file
    std::vector<std::uint64_t> GroupStart; // the position of each group, or Absent
  };

  struct Job; // one call of Fill

  const FileReader::Internals& Content() const { return this->Parts.Content(); }
  /** A shared point belongs to the lowest chunk of the universe that uses it. */
  bool Owns(const SharedGroup& group) const;
  /** The index in Blocks of a block of the file, which must be there. */
  std::size_t FindBlock(std::uint32_t index) const;

  void Plan(Job& job) const;
  void DecodeBlock(Job& job, std::size_t b) const;
  void StoreBlock(const Job& job, std::size_t b) const;
  void DecodeChunkInto(Job& job, std::size_t i) const;
  void StoreChunk(const Job& job, std::size_t i, const ChunkMesh& mesh) const;
  void StoreConnectivity(const Job& job, std::size_t i, const ChunkMesh& mesh,
    const OrderPart* points, const OrderPart* cells) const;

  PartDecoder Parts;
  std::vector<std::uint32_t> Chunks;
  std::vector<std::uint32_t> Universe;
  bool WithUnused;
  std::uint64_t Points = 0;
  std::uint64_t Tets = 0;
  std::vector<std::uint64_t> FirstTet;
  std::vector<std::uint64_t> FirstOwn;
  std::uint64_t FirstUnused = 0;
  std::vector<Block> Blocks; // in the order of the file
};
}

#endif
