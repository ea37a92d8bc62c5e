// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshSection_h
#define gatunMeshSection_h

#include "gatunArrayCodec.h"
#include "gatunCellList.h"
#include "gatunLayerPartition.h"
#include "gatunLocalIds.h"
#include "gatunWriterState.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** Partitions the mesh of a file and writes its MESH sections: palettes, blocks and chunks. */
class MeshSection
{
public:
  explicit MeshSection(WriterState& state)
    : State(state)
  {
  }

  /** Fills table, bounds and chunks of the state. */
  void Write(const std::function<bool(double)>& progress);

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

  void MakePartition(const std::function<bool(double)>& progress);
  void WritePalettes(StreamBatch& batch);
  void WriteBlocks(StreamBatch& batch);
  BlockStreams EncodeBlock(std::span<const std::uint32_t> points) const;
  void WriteChunks(const std::function<bool(double)>& progress);
  void CountTypes();
  void FindShapes();
  void FindBounds();

  std::vector<PointKeys> GetPointKeys(std::span<const std::uint32_t> points) const;
  std::vector<std::uint32_t> GetSharedPoints(std::size_t chunk) const;
  std::span<const std::uint32_t> GetCells(std::size_t chunk) const;
  CellSizes GetSizes(std::size_t chunk) const;
  LocalMesh MakeLocalMesh(std::size_t chunk);
  std::vector<std::array<std::uint32_t, 4>> MakeTets(std::size_t chunk, const LocalIds& ids) const;
  template <typename NumberOf>
  CellList MakeCells(std::size_t chunk, NumberOf&& numberOf) const;
  ChunkFrame MakeFrame(std::size_t chunk, std::span<const std::uint32_t> shared) const;
  ChunkStreams EncodeChunk(std::size_t chunk);
  void EncodeOrder(ChunkState& chunk, ChunkStreams& streams) const;
  void AddStreams(const ChunkStreams& streams, ChunkEntry& entry, StreamBatch& batch);

  WriterState& State;
  PointDomain Domains;
  std::optional<LayerPartition> Layers;
};
}

#endif
