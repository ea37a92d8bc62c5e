// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartDecoder_h
#define gatunPartDecoder_h

#include "gatunArrayCodec.h"
#include "gatunCacheParts.h"
#include "gatunChunkCacheInternals.h"
#include "gatunChunkCodec.h"
#include "gatunChunkTets.h"
#include "gatunFileReaderInternals.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** An array of a block or chunk and its time step. Values is null if there is none. */
struct ArrayAtStep
{
  std::shared_ptr<const ArrayPart> Values;
  std::size_t Step = 0;
};

/** The weights by which the values of a chunk or block are predicted, as far as they are needed. */
struct PartFits
{
  std::shared_ptr<const NeighborFit> Linear;  // of points of a chunk
  std::shared_ptr<const QuadraticFit> Points; // of a chunk or block
  std::shared_ptr<const QuadraticFit> Cells;
};

/**
 * Provides the parts of a file from a cache, or decodes them and keeps them there. Blocks of shared
 * points are numbered as in the file. The unused points are the block after the last one.
 *
 * Thread safe. Safe on hostile input: throws Error.
 */
class PartDecoder
{
public:
  /** Provides the parts of the blocks that a chunk needs. */
  template <typename Part>
  using OfBlock = std::function<std::shared_ptr<const Part>(std::uint32_t block)>;

  explicit PartDecoder(std::shared_ptr<ChunkCache> cache)
    : Cache(std::move(cache))
    , File(Cache->GetFile())
  {
  }

  const std::shared_ptr<const FileReader>& GetFile() const { return this->File; }
  const FileReader::Internals& Content() const { return InternalsOf(*this->File); }

  /** The domains of the components of an array at a step. */
  std::shared_ptr<const DomainsPart> GetDomains(std::uint32_t array, std::size_t step) const;

  std::shared_ptr<const PointsPart> GetBlockPoints(std::uint32_t block) const;
  std::shared_ptr<const OrderPart> GetBlockOrder(std::uint32_t block) const;

  /** The mesh of a chunk with its context except the fit. Null if it is not in the cache. */
  std::shared_ptr<const ChunkMesh> FindMesh(std::uint32_t chunk) const;
  std::shared_ptr<const ChunkMesh> DecodeMesh(
    std::uint32_t chunk, const OfBlock<PointsPart>& pointsOf) const;

  /** The original ids of a chunk's own points and of its cells. */
  std::shared_ptr<const OrderPart> GetPointOrder(
    std::uint32_t chunk, const ChunkMesh& mesh, const OfBlock<OrderPart>& orderOf) const;
  std::shared_ptr<const OrderPart> GetCellOrder(std::uint32_t chunk, const ChunkMesh& mesh) const;

  /** The rotations of the cells of a chunk of tetrahedra. Not kept, because only the connectivity
   * needs them. */
  std::vector<Key> DecodeCorners(std::uint32_t chunk, const ChunkMesh& mesh) const;

  /** The original cells of a chunk, with the original order of corners if the file keeps it. */
  CellList GetCells(std::uint32_t chunk, const ChunkMesh& mesh, bool restoreCorners) const;

  /** The tetrahedra of a chunk of other cells. Not kept, because they need more memory than cells.
   */
  ChunkSize SplitCells(std::uint32_t chunk, const ChunkMesh& mesh) const;

  /** The array at the latest step in the cache from first to step. */
  ArrayAtStep FindBlockArray(
    std::uint32_t block, std::uint32_t array, std::size_t first, std::size_t step) const;
  ArrayAtStep FindChunkArray(
    std::uint32_t chunk, std::uint32_t array, std::size_t first, std::size_t step) const;

  /** Decodes an array at a step. before: the array at the previous step, may be null at key steps
   * (FileReader::Internals::FindKeyStep). Coordinates that do not change are those of the previous
   * step. Without keys if the array is copied from another one. fits: those of the chunk or block
   * so far, so that several arrays share them. */
  std::shared_ptr<const ArrayPart> DecodeBlockArray(std::uint32_t block, std::uint32_t array,
    std::size_t step, const DomainsPart& domains, const std::shared_ptr<const ArrayPart>& before,
    PartFits& fits) const;
  std::shared_ptr<const ArrayPart> DecodeChunkArray(std::uint32_t chunk, const ChunkMesh& mesh,
    std::uint32_t array, std::size_t step, const DomainsPart& domains,
    const std::shared_ptr<const ArrayPart>& before, const OfBlock<ArrayPart>& valuesOf,
    PartFits& fits) const;

  /** Keeps arrays in the cache. Arrays of intermediate steps need not be kept. */
  void KeepBlockArray(std::uint32_t block, std::uint32_t array, const ArrayAtStep& values) const;
  void KeepChunkArray(std::uint32_t chunk, std::uint32_t array, const ArrayAtStep& values) const;

private:
  ChunkCache::Internals& Kept() const { return InternalsOf(*this->Cache); }

  void CheckPolyhedra(std::uint32_t chunk, const ChunkMesh& mesh) const;

  /** Sets the weights of a chunk or block to the kept ones, or else to the result of make(). */
  template <typename AnyFit, typename Make>
  void FindFit(
    std::shared_ptr<const AnyFit>& fit, PartKind kind, std::uint32_t number, Make&& make) const;
  std::vector<Key> DecodeCellIntegers(const StreamRef& where, const std::string& what,
    const ChunkMesh& mesh, ScalarType type, Key end) const;
  void DecodePoints(std::uint32_t chunk, const ChunkMesh& mesh,
    std::span<const std::uint8_t> stream, std::span<const Domain> domains,
    std::span<ComponentKeys> keys, PartFits& fits) const;
  std::vector<ComponentKeys> MakeKeys(
    std::uint32_t array, std::size_t step, std::size_t count, const ArrayPart* before) const;

  /** The same for coordinates, with those of another step converted. mesh(i): the keys of a point
   * in the mesh. */
  template <typename MeshKeys>
  std::vector<ComponentKeys> MakePointKeys(std::size_t step, std::size_t count,
    const DomainsPart& domains, const ArrayPart* before, MeshKeys&& mesh) const;

  /** Whether an array has its streams at an earlier step. */
  bool StandsStill(std::uint32_t array, std::size_t step) const
  {
    return this->Content().Meta.IsPoints(array) && !this->Content().GetSteps()[step].PointsMove;
  }

  /** Calls use(vertex, part, position in its block) for the shared vertices of a chunk's walk. */
  template <typename Part, typename Use>
  void EachShared(
    std::uint32_t chunk, const ChunkMesh& mesh, const OfBlock<Part>& partOf, Use&& use) const;

  std::shared_ptr<ChunkCache> Cache;
  std::shared_ptr<const FileReader> File;
};
}

#endif
