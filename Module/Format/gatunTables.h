// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTables_h
#define gatunTables_h

// The META, TABL and STEP sections, which describe and locate the parts of a file.

#include "gatunCellTable.h"
#include "gatunContainer.h"
#include "gatunFieldData.h"
#include "gatunTypes.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gatun
{
struct MetaTable
{
  std::string WriterVersion;
  std::uint64_t Points = 0;
  std::uint64_t Tets = 0;
  std::uint64_t UnusedPoints = 0;
  ScalarType CoordinateType = ScalarType::Float32;
  bool WideIds = true;
  bool HasTime = false;
  std::uint8_t Keep = KeepNone;
  std::uint32_t ChunkTets = 0;
  std::uint32_t KeyStepInterval = 1;
  Bounds Box;
  std::vector<ArrayDescription> Arrays;

  Bytes Write() const;
  static MetaTable Read(std::span<const std::uint8_t> bytes);
};

/** Points that are shared by the same set of chunks. */
struct SharedGroup
{
  std::vector<std::uint32_t> Chunks; // two or more, ascending
  std::uint32_t Points = 0;
};

/** Shared points that are decoded together, or the unused points, which have no groups. */
struct BlockEntry
{
  std::vector<SharedGroup> Groups;
  std::uint64_t Points = 0;
  StreamRef Geometry;
  StreamRef Order; // original ids, if KeepPoints

  std::uint64_t FirstPoint = 0; // not stored: blocks are consecutive
};

struct ChunkEntry
{
  ChunkInfo Info;
  StreamRef Connectivity;
  StreamRef Geometry;
  StreamRef PointOrder; // original ids, if KeepPoints
  StreamRef CellOrder;  // original ids, if KeepCells
  StreamRef Corners;    // if KeepCorners: rotations; for other cells than tetrahedra, maybe nothing
  CellSizes Sizes;      // not stored here, but in the table of cells

  // Not stored: the groups that contain this chunk's shared points, in the order of the file.
  struct Part
  {
    std::uint32_t Block = 0;
    std::uint32_t Group = 0;
    std::uint64_t FirstInBlock = 0;
  };
  std::vector<Part> Shared;
};

struct PaletteRef
{
  std::uint64_t Count = 0; // 0 if there is no palette
  StreamRef Stream;
};

struct MeshTable
{
  std::array<PaletteRef, 3> Palettes;
  std::vector<BlockEntry> Blocks;
  BlockEntry Unused;
  std::vector<ChunkEntry> Chunks;

  Bytes Write(std::uint8_t keep) const;

  /** Reads the table, checks it against the counts of meta, and computes the fields that are not
   * stored. cells: null if all cells are tetrahedra. */
  static MeshTable Read(
    std::span<const std::uint8_t> bytes, const MetaTable& meta, const CellTable* cells = nullptr);

  /** Computes the fields that are not stored from the groups: positions, parts, neighbors. */
  void LinkGroups();

  /** The neighbors that use each shared point of a chunk: bit i for the i-th neighbor, bit 31 for
   * the 32nd and all further ones. */
  std::vector<std::uint32_t> GetSharedUsers(std::size_t chunk) const;

  std::uint64_t GetSharedPoints() const;
  std::uint64_t GetNumberOfCells() const;

  /** Throws unless a file of the given size can contain the streams that the counts need. */
  void CheckLengths(std::uint64_t fileSize) const;

private:
  void FindNeighbors();
  void NumberAll(const MetaTable& meta);
};

/** One array at one time step. */
struct ArrayStep
{
  std::vector<PaletteRef> Palettes; // one for each component
  ArrayRanges Ranges;
  std::vector<ArrayRanges> ChunkRanges;
  std::vector<StreamRef> Chunks; // one for each chunk
  std::vector<StreamRef>
    Blocks; // one for each block, and one for the unused points; point arrays only

  bool HasPalette() const;
};

struct StepTable
{
  double Time = 0;
  bool Key = true; // whether it decodes without the previous step
  StreamRef Field; // length 0 if there are no field data
  std::vector<ArrayStep> Arrays;

  Bytes Write() const;
  static StepTable Read(
    std::span<const std::uint8_t> bytes, const MetaTable& meta, const MeshTable& mesh);
};

/** The type of the original numbers of so many points or cells. */
constexpr ScalarType GetNumberType(std::uint64_t count)
{
  return count < std::uint64_t{ 1 } << 32 ? ScalarType::UInt32 : ScalarType::UInt64;
}

Bytes WriteFieldData(const FieldData& field);
FieldData ReadFieldData(std::span<const std::uint8_t> bytes);
}

#endif
