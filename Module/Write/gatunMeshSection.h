// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshSection_h
#define gatunMeshSection_h

#include "gatunArrayCodec.h"
#include "gatunCellList.h"
#include "gatunLayerPartition.h"
#include "gatunLocalIds.h"
#include "gatunPalette.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** Partitions the parts of a mesh and writes the MESH sections of a file: palettes, blocks and
 * chunks. */
class MeshSection
{
public:
  explicit MeshSection(WriterState& state)
    : State(state)
  {
  }

  /** Divides a part into chunks. */
  void MakeLayout(WriterPart& part, const std::function<bool(double)>& progress);

  /** Adds the chunks of a part to the tables, with the number of points that they share. All parts
   * have to be added, in their order, before the first one is written. */
  void AddChunks(const WriterPart& part);

  /** Adds the shared points of the chunks of a part to the groups of the file. */
  void AddGroups(const WriterPart& part);

  /** Sets the domains of the coordinates. */
  void SetDomains(const PointDomain& domains) { this->Domains = domains; }

  /** Writes a part whose shared points have been placed, and fills the entries of its chunks. The
   * last part also writes the unused points of all. encoded: called with each chunk when its state
   * is there, by several threads. */
  void Write(WriterPart& part, const std::function<bool(double)>& progress,
    const std::function<void(std::size_t)>& encoded = {});

  /** The layers that the file is organized by, if any. */
  const std::optional<LayerPartition>& GetLayers() const { return this->Layers; }

private:
  /** The points of a chunk and its cells in local numbers. Shared points come first, in the order
   * of the frame, then own ones in the order of the input. */
  struct LocalMesh
  {
    std::vector<std::uint32_t> Shared;
    std::vector<std::uint32_t> Own;
    std::vector<std::array<std::uint32_t, 4>> Tets; // if all cells are tetrahedra
    CellList Cells;                                 // otherwise
  };

  struct BlockStreams
  {
    Bytes Geometry, Order;
  };

  struct ChunkStreams
  {
    Bytes Connectivity, Geometry, PointOrder, CellOrder, Corners;
  };

  void WritePalettes(StreamBatch& batch);
  void WriteBlocks(const WriterPart& part, StreamBatch& batch);
  BlockStreams EncodeBlock(const WriterPart& part, std::span<const std::uint32_t> points) const;
  BlockStreams EncodeUnused() const;
  BlockStreams EncodeBlock(const std::vector<PointKeys>& pointKeys, ComponentKeys numbers) const;
  void AddStreams(const BlockStreams& streams, BlockEntry& block, StreamBatch& batch);
  void TakeUnused(const WriterPart& part);
  void WriteChunks(WriterPart& part, const std::function<bool(double)>& progress,
    const std::function<void(std::size_t)>& encoded);
  void FindBounds(const WriterPart& part);

  std::vector<PointKeys> GetPointKeys(
    const WriterPart& part, std::span<const std::uint32_t> points) const;
  CellSizes GetSizes(const WriterPart& part, std::size_t chunk) const;
  LocalMesh MakeLocalMesh(const WriterPart& part, std::size_t chunk);
  std::vector<std::array<std::uint32_t, 4>> MakeTets(
    const WriterPart& part, std::size_t chunk, const LocalIds& shared) const;
  template <typename NumberOf>
  CellList MakeCells(
    const WriterPart& part, std::size_t chunk, const CellSizes& sizes, NumberOf&& numberOf) const;
  ChunkFrame MakeFrame(
    const WriterPart& part, std::size_t chunk, std::span<const std::uint32_t> shared) const;
  ChunkStreams EncodeChunk(WriterPart& part, std::size_t chunk);
  void EncodeOrder(const WriterPart& part, ChunkState& chunk, ChunkStreams& streams) const;
  void AddStreams(const ChunkStreams& streams, ChunkEntry& entry, StreamBatch& batch);

  WriterState& State;
  PointDomain Domains;
  std::optional<LayerPartition> Layers;

  // The local number of each point that is an own one of a chunk, while chunks are encoded. All
  // others are NotOwn: no two chunks write or read the same number.
  std::vector<std::uint32_t> OwnNumbers;
  static constexpr std::uint32_t NotOwn = 0xffffffffu;
};
}

#endif
