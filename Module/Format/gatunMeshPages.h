// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshPages_h
#define gatunMeshPages_h

// The TABL section and the pages that it names. See Documentation/format.md, 3.3.

#include "gatunBytes.h"
#include "gatunMeshTable.h"
#include "gatunMetaTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** The chunks whose tables are in one page. The last page may have fewer. */
constexpr std::size_t ChunksPerPage = 256;

constexpr std::size_t GetPageCount(std::size_t chunks)
{
  return (chunks + ChunksPerPage - 1) / ChunksPerPage;
}

/** Writes a page and returns where it is. */
using PutPage = std::function<StreamRef(const Bytes& page)>;

/** A page: consecutive chunks, and the blocks whose first chunk is one of them. */
struct MeshPageRef
{
  StreamRef Summary; // sizes of the chunks, which are read when a file is opened
  StreamRef Details; // where their streams are, and the blocks

  // Of all blocks of the page.
  std::uint64_t Blocks = 0;
  std::uint64_t Points = 0;
  std::uint64_t GeometryBytes = 0;

  // Not stored: the first block, and the number of its first point in the file.
  std::uint64_t FirstBlock = 0;
  std::uint64_t FirstPoint = 0;
};

/** The TABL section. */
struct MeshIndex
{
  std::array<PaletteRef, 3> Palettes;
  BlockEntry Unused;
  std::size_t Chunks = 0;
  std::vector<MeshPageRef> Pages;

  std::size_t GetChunksOfPage(std::size_t page) const;
  std::uint64_t GetNumberOfBlocks() const;
  std::uint64_t GetSharedPoints() const;

  Bytes Write(std::uint8_t keep) const;
  static MeshIndex Read(std::span<const std::uint8_t> bytes, const MetaTable& meta);
};

/** The pages that a table will have. */
MeshIndex MakeMeshIndex(const MeshTable& table);

/** Writes these pages, and sets where they are. */
void WriteMeshPages(
  MeshIndex& index, const MeshTable& table, std::uint8_t keep, const PutPage& put);

/** The lengths of the streams that justify the sizes of a chunk. */
struct ChunkLengths
{
  std::uint32_t Connectivity = 0;
  std::uint32_t Geometry = 0;
};

/** What is known of all chunks of an open file. */
struct ChunkSummaries
{
  std::vector<ChunkInfo> Infos;
  std::vector<ChunkLengths> Lengths;

  /** Adds the chunks of the next page. index: the whole table. cells: null if all cells are
   * tetrahedra. */
  void Add(std::span<const std::uint8_t> summary, const MeshIndex& index, const CellTable* cells);

  /** Numbers cells and points, and checks that they add up to those of the mesh and that a file of
   * the given size can contain the streams that justify them. */
  void Finish(MeshIndex& index, const MetaTable& meta, std::uint64_t fileSize);
};

/** The details of the chunks and blocks of a page. */
struct MeshPage
{
  struct Chunk
  {
    ChunkEntry Entry;                  // its streams
    std::vector<std::uint32_t> Blocks; // that have points of the chunk, ascending
  };
  std::vector<Chunk> Chunks;
  std::vector<BlockEntry> Blocks;

  std::uint64_t GetBytes() const;

  static MeshPage Read(std::span<const std::uint8_t> details, std::size_t page,
    const MeshIndex& index, std::span<const ChunkLengths> lengths, std::uint8_t keep);
};

/** The parts of the shared points of a chunk that are in a block. Throws if there are none. */
void AddParts(const BlockEntry& block, std::uint32_t number, std::uint32_t chunk,
  std::vector<ChunkEntry::Part>& parts);
}

#endif
