// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkSetDecoder_h
#define gatunChunkSetDecoder_h

#include "gatunChunkSet.h"
#include "gatunPartDecoder.h"
#include "gatunPieceRequest.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
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
    std::vector<std::uint32_t> universe, bool withUnusedPoints,
    PieceForm form = PieceForm::Tetrahedra);

  /** The layout of the mesh. */
  const ChunkSet& GetSet() const { return this->Set; }

  std::uint64_t GetNumberOfPoints() const { return this->Set.GetNumberOfPoints(); }
  std::uint64_t GetNumberOfCells() const { return this->Set.GetNumberOfCells(); }

  /** Fills the target with the arrays (indices into GetArrays()) of a step. */
  void Fill(const PieceTarget& target, const std::vector<std::uint32_t>& arrays, std::size_t step,
    bool restoreOrder, const Progress& progress) const;

private:
  struct Job;    // one call of Fill
  struct Places; // the positions of items

  const FileReader::Internals& Content() const { return this->Parts.Content(); }

  void Plan(Job& job) const;
  void DecodeBlock(Job& job, std::size_t b) const;
  void StoreBlock(const Job& job, std::size_t b) const;
  void DecodeChunkInto(Job& job, std::size_t i) const;
  void StoreChunk(Job& job, std::size_t i, const ChunkMesh& mesh) const;
  void StorePoints(const Job& job, std::size_t i, const ChunkMesh& mesh, const OrderPart* points,
    const Places& places) const;
  void StoreCellPlaces(const Job& job, std::size_t i, const ChunkMesh& mesh, const OrderPart* order,
    const Places& places, auto&& cellOf) const;
  std::vector<std::uint64_t> FindIds(
    const Job& job, std::size_t i, const ChunkMesh& mesh, const Places& points) const;
  void StoreTets(const Job& job, std::size_t i, const ChunkMesh& mesh, const auto& tets,
    const Places& points, const Places& cells) const;
  void StoreOriginal(Job& job, std::size_t i, const ChunkMesh& mesh, const Places& points,
    std::shared_ptr<const OrderPart> order) const;
  void FinishOriginal(const Job& job) const;

  PartDecoder Parts;
  ChunkSet Set;
};
}

#endif
