// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkSetDecoder_h
#define gatunChunkSetDecoder_h

#include "gatunChunkSet.h"
#include "gatunPartDecoder.h"
#include "gatunPieceRequest.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/**
 * Decodes a set of chunks into one mesh without ghosts, with the layout of ChunkSet.
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

  /** The layout of the mesh. */
  const ChunkSet& GetSet() const { return this->Set; }

  std::uint64_t GetNumberOfPoints() const { return this->Set.GetNumberOfPoints(); }
  std::uint64_t GetNumberOfTets() const { return this->Set.GetNumberOfTets(); }

  /** Fills the target with the arrays (indices into GetArrays()) of a step. */
  void Fill(const PieceTarget& target, const std::vector<std::uint32_t>& arrays, std::size_t step,
    bool restoreOrder, const Progress& progress) const;

private:
  struct Job; // one call of Fill

  const FileReader::Internals& Content() const { return this->Parts.Content(); }

  void Plan(Job& job) const;
  void DecodeBlock(Job& job, std::size_t b) const;
  void StoreBlock(const Job& job, std::size_t b) const;
  void DecodeChunkInto(Job& job, std::size_t i) const;
  void StoreChunk(const Job& job, std::size_t i, const ChunkMesh& mesh) const;
  void StoreConnectivity(const Job& job, std::size_t i, const ChunkMesh& mesh,
    const OrderPart* points, const OrderPart* cells) const;

  PartDecoder Parts;
  ChunkSet Set;
};
}

#endif
