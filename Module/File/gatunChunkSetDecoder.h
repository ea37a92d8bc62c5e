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
 * Decodes a set of chunks into one mesh, without ghosts. Points: the groups of shared points that
 * the set touches, in the order of the file, then own points chunk by chunk, then unused ones.
 *
 * Keeps nothing but where things go; what it decodes is in the cache. Time and memory of all it
 * does grow with the set, not with the file.
 */
class ChunkSetDecoder
{
public:
  using Progress = std::function<bool(double)>;

  /** Universe as in PieceRequest: it decides which points belong to the set. */
  ChunkSetDecoder(const std::shared_ptr<ChunkCache>& cache, std::vector<std::uint32_t> chunks,
    std::vector<std::uint32_t> universe, bool withUnusedPoints);

  std::uint64_t GetNumberOfPoints() const { return this->Points; }
  std::uint64_t GetNumberOfTets() const { return this->Tets; }
  const std::vector<std::uint32_t>& GetChunks() const { return this->Chunks; }

  /** First cell of the i-th chunk of the set. */
  std::uint64_t GetFirstTet(std::size_t i) const { return this->FirstTet[i]; }

  /** Whether all chunks and unused points are in the set, so that an order can be restored. */
  bool IsWhole() const;

  /** Fills the target with the arrays (indices into GetArrays()) of a step. */
  void Fill(const PieceTarget& target, const std::vector<std::uint32_t>& arrays, std::size_t step,
    bool restoreOrder, const Progress& progress) const;

  /** 0 for each point that belongs to the set, 1 for those of a chunk that is not in it. */
  void MarkOwners(unsigned char* ghosts) const;

  /** Place in this set of each point that a smaller set of chunks has, in that set's order. */
  std::vector<std::uint64_t> Locate(const ChunkSetDecoder& part) const;

private:
  static constexpr std::uint64_t Absent = ~std::uint64_t{ 0 };

  /** Shared points of which the set uses some, or the unused points; where they go. */
  struct Block
  {
    std::uint32_t Index = 0;               // in the file
    std::vector<std::uint64_t> GroupStart; // of each group; Absent: not here
  };

  struct Job; // one call of Fill

  const FileReader::Internals& Content() const { return this->Parts.Content(); }
  /** A shared point belongs to the lowest chunk of the universe that uses it. */
  bool Owns(const SharedGroup& group) const;
  /** Place of a block of the file in Blocks; it must be there. */
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
  std::vector<Block> Blocks; // those needed, in the order of the file
};
}

#endif
