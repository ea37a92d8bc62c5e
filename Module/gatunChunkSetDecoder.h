// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChunkSetDecoder_h
#define gatunChunkSetDecoder_h

#include "gatunChunkCodec.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/**
 * Decodes a set of chunks into one mesh, without ghosts. Points: the groups of shared points that
 * the set touches, in the order of the file, then own points chunk by chunk, then unused ones.
 */
class ChunkSetDecoder
{
public:
  using Progress = std::function<bool(double)>;

  /** Universe as in PieceRequest: it decides which points belong to the set. */
  ChunkSetDecoder(std::shared_ptr<const FileReader> file, std::vector<std::uint32_t> chunks,
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
    bool restoreOrder, const Progress& progress);

  /** 0 for each point that belongs to the set, 1 for those of a chunk that is not in it. */
  void MarkOwners(unsigned char* ghosts) const;

  /** Place in this set of each point that a smaller set of chunks has, in that set's order. */
  std::vector<std::uint64_t> Locate(const ChunkSetDecoder& part) const;

private:
  static constexpr std::size_t NoStep = ~std::size_t{ 0 };
  static constexpr std::uint64_t Absent = ~std::uint64_t{ 0 };

  /** Keys of one array at the step last decoded, which the next step may refer to. */
  using ArrayState = std::vector<ComponentKeys>;

  struct BlockState
  {
    bool Needed = false;
    std::vector<PointKeys> Points;
    std::vector<std::uint64_t> Order; // original ids
    std::vector<ArrayState> Arrays;
  };

  struct ChunkState
  {
    std::unique_ptr<ChunkMesh> Mesh; // kept where there are other time steps to decode
    std::vector<ArrayState> Arrays;
  };

  struct Job; // one call of Fill

  const FileReader::Internals& Content() const { return this->File->GetInternals(); }
  /** A shared point belongs to the lowest chunk of the universe that uses it. */
  bool Owns(const SharedGroup& group) const;

  const BlockEntry& GetBlock(std::size_t block) const;
  std::size_t GetBlockCount() const { return this->Content().Mesh.Blocks.size() + 1; }

  /** The first step of each array that still has to be decoded to reach a step. */
  std::vector<std::size_t> FindFirstSteps(
    const std::vector<std::uint32_t>& arrays, std::size_t step) const;

  void DecodeBlock(const Job& job, std::size_t block);
  void DecodeBlockArray(const Job& job, std::size_t block, std::size_t a);
  void StoreBlock(const Job& job, std::size_t block) const;

  void DecodeChunkInto(const Job& job, std::size_t index);
  std::unique_ptr<ChunkMesh> DecodeMesh(std::size_t chunk) const;
  // Arrays are given by their place a in the job.
  void DecodeChunkArray(
    const Job& job, std::size_t chunk, ChunkMesh& mesh, std::size_t a, ArrayState& state);
  void StoreChunk(const Job& job, std::size_t index, ChunkMesh& mesh) const;
  void StoreConnectivity(const Job& job, std::size_t index, const ChunkMesh& mesh,
    const std::vector<std::uint64_t>& pointPlaces,
    const std::vector<std::uint64_t>& cellPlaces) const;
  std::vector<std::uint64_t> DecodePointOrder(ChunkMesh& mesh, std::size_t chunk) const;
  std::vector<std::uint64_t> DecodeCellOrder(const ChunkMesh& mesh, std::size_t chunk) const;
  std::vector<Key> DecodeCellIntegers(const StreamRef& where, const std::string& what,
    const ChunkMesh& mesh, ScalarType type, Key end) const;

  /** Calls use(vertex, block, place in the block) for the shared vertices of a chunk's walk. */
  template <typename Use>
  void EachShared(std::size_t chunk, const ChunkMesh& mesh, Use&& use) const;

  std::shared_ptr<const FileReader> File;
  std::vector<std::uint32_t> Chunks;
  std::vector<std::uint32_t> Universe;
  bool WithUnused;
  bool KeepsState;                      // there are several time steps
  std::vector<std::size_t> DecodedStep; // of each array, kept in the states below; or NoStep
  std::uint64_t Points = 0;
  std::uint64_t Tets = 0;
  std::vector<std::uint64_t> FirstTet;
  std::vector<std::uint64_t> FirstOwn;
  std::uint64_t FirstUnused = 0;
  std::vector<std::vector<std::uint64_t>> GroupStart; // of each block's groups; Absent: not here
  std::vector<BlockState> Blocks;                     // the last one holds the unused points
  std::vector<ChunkState> States;
};
}

#endif
