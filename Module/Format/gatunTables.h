// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTables_h
#define gatunTables_h

// What META, TABL and STEP sections say: the parts of a file and where they are.

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

/** Points used by one and the same set of chunks. */
struct SharedGroup
{
  std::vector<std::uint32_t> Chunks; // two or more, ascending
  std::uint32_t Points = 0;
};

/** Shared points that are decoded together; or the unused points, without groups. */
struct BlockEntry
{
  std::vector<SharedGroup> Groups;
  std::uint64_t Points = 0;
  StreamRef Geometry;
  StreamRef Order; // original ids, if KeepPoints

  std::uint64_t FirstPoint = 0; // not stored: the blocks' points follow each other
};

struct ChunkEntry
{
  ChunkInfo Info;
  StreamRef Connectivity;
  StreamRef Geometry;
  StreamRef PointOrder; // original ids, if KeepPoints
  StreamRef CellOrder;  // original ids, if KeepCells
  StreamRef Corners;    // rotations, if KeepCorners

  // Not stored: groups of blocks with this chunk's shared points, in the order of the file.
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
  std::uint64_t Count = 0; // 0: no palette
  StreamRef Stream;
};

struct MeshTable
{
  std::array<PaletteRef, 3> Palettes;
  std::vector<BlockEntry> Blocks;
  BlockEntry Unused;
  std::vector<ChunkEntry> Chunks;

  Bytes Write(std::uint8_t keep) const;

  /** Reads the table and fills what is not stored; checks it against the counts of meta. */
  static MeshTable Read(std::span<const std::uint8_t> bytes, const MetaTable& meta);

  /** Fills what is not stored from the groups of the blocks: places, parts, neighbours. */
  void LinkGroups();

  /** Of each shared point of a chunk, in its order, the neighbours that use it too: bit i for the
   * i-th neighbour, bit 31 for the 32nd and all behind it. */
  std::vector<std::uint32_t> GetSharedUsers(std::size_t chunk) const;

  std::uint64_t GetSharedPoints() const;

  /** Throws unless the streams that justify the counts fit a file of so many bytes together. */
  void CheckLengths(std::uint64_t fileSize) const;

private:
  void FindNeighbours();
  void NumberAll(const MetaTable& meta);
};

/** One array at one time step. */
struct ArrayStep
{
  std::vector<PaletteRef> Palettes; // one a component
  ArrayRanges Ranges;
  std::vector<ArrayRanges> ChunkRanges;
  std::vector<StreamRef> Chunks; // one a chunk
  std::vector<StreamRef> Blocks; // one a block and one for the unused points; point arrays only

  bool HasPalette() const;
};

struct StepTable
{
  double Time = 0;
  bool Key = true; // decodes without the step before it
  StreamRef Field; // length 0: no field data
  std::vector<ArrayStep> Arrays;

  Bytes Write() const;
  static StepTable Read(
    std::span<const std::uint8_t> bytes, const MetaTable& meta, const MeshTable& mesh);
};

Bytes WriteFieldData(const FieldData& field);
FieldData ReadFieldData(std::span<const std::uint8_t> bytes);
}

#endif
