// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunContainer_h
#define gatunContainer_h

// The layout of containers: header, sections, directory and trailer. See Documentation/format.md.

#include "gatunBytes.h"
#include "gatunVersion.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace gatun
{
constexpr std::array<std::uint8_t, 8> FileMagic{ 0x89, 'G', 'T', 'N', '\r', '\n', 0x1a, '\n' };
constexpr std::array<std::uint8_t, 8> TrailerMagic{ 'G', 'T', 'N', 'E', 'N', 'D', '\r', '\n' };
constexpr std::size_t HeaderSize = 16;
constexpr std::size_t SectionHeaderSize = 24;
constexpr std::size_t TrailerSize = 32;

using FourCC = std::uint32_t;

constexpr FourCC MakeFourCC(const char (&name)[5])
{
  return static_cast<FourCC>(name[0]) | static_cast<FourCC>(name[1]) << 8 |
    static_cast<FourCC>(name[2]) << 16 | static_cast<FourCC>(name[3]) << 24;
}

constexpr FourCC SectionMeta = MakeFourCC("META");   // counts and arrays
constexpr FourCC SectionMesh = MakeFourCC("MESH");   // streams of blocks and chunks
constexpr FourCC SectionTable = MakeFourCC("TABL");  // positions of the pages of chunks
constexpr FourCC SectionPages = MakeFourCC("PAGE");  // positions of streams, for some chunks each
constexpr FourCC SectionValues = MakeFourCC("VALS"); // streams of arrays, field data
constexpr FourCC SectionStep = MakeFourCC("STEP");   // positions of the pages of one time step
constexpr FourCC SectionTree = MakeFourCC("TREE");   // description of the merge tree
constexpr FourCC SectionMerges = MakeFourCC("MERG"); // stream of the merges
constexpr FourCC SectionDependencies = MakeFourCC("DEPS"); // stream of the merges' dependencies
constexpr FourCC SectionTreeStep = MakeFourCC("TRNG");     // ranges after merges, of one time step
constexpr FourCC SectionLevel = MakeFourCC("LEVL");  // a base mesh: a file embedded in the file
constexpr FourCC SectionLayers = MakeFourCC("LAYR"); // the layers of values that define chunks
constexpr FourCC SectionCells =
  MakeFourCC("CELL"); // types and sizes of other cells than tetrahedra
constexpr FourCC SectionSurface = MakeFourCC("SURF");   // the mesh is a surface
constexpr FourCC SectionBoundary = MakeFourCC("BNDY");  // the boundary: a file of a surface
constexpr FourCC SectionGrid = MakeFourCC("GRID");      // another mesh of the series: a file
constexpr FourCC SectionTime = MakeFourCC("TIME");      // the mesh of each time step
constexpr FourCC SectionLive = MakeFourCC("LIVE");      // the cells that some time steps have
constexpr FourCC SectionFree = MakeFourCC("FREE");      // bytes that mean nothing any more
constexpr FourCC SectionDirectory = MakeFourCC("DIRY"); // positions of the sections

constexpr FourCC SectionBlocks = MakeFourCC("BLKS"); // streams of blocks of a volume

/** A file format: its signatures, its version and the sections that it may have. */
struct ContainerKind
{
  const char* Suffix;
  std::array<std::uint8_t, 8> FileMagic;
  std::array<std::uint8_t, 8> TrailerMagic;
  std::uint32_t Version;
  std::span<const FourCC> Sections;
};

inline constexpr std::array MeshSections{ SectionMeta, SectionMesh, SectionTable, SectionPages,
  SectionValues, SectionStep, SectionTree, SectionMerges, SectionTreeStep, SectionLevel,
  SectionDependencies, SectionLayers, SectionCells, SectionSurface, SectionBoundary, SectionGrid,
  SectionTime, SectionLive, SectionFree, SectionDirectory };
inline constexpr ContainerKind MeshContainer{ ".gtn", FileMagic, TrailerMagic, GATUN_FORMAT_VERSION,
  MeshSections };

inline constexpr std::array VolumeSections{ SectionMeta, SectionBlocks, SectionTable,
  SectionDirectory };
inline constexpr ContainerKind VolumeContainer{ ".ghv",
  { 0x89, 'G', 'H', 'V', '\r', '\n', 0x1a, '\n' }, { 'G', 'H', 'V', 'E', 'N', 'D', '\r', '\n' },
  GATUN_VOLUME_FORMAT_VERSION, VolumeSections };

constexpr std::uint16_t SectionVersion = 1; // of every section
constexpr std::uint16_t FlagMandatory = 1;  // readers that do not know the section must stop

/** Whether a path names a regular file with the signature of a format. */
bool BeginsAs(const std::string& path, const ContainerKind& kind) noexcept;

/** Position and checksum of a stream, the unit that is read and checked. */
struct StreamRef
{
  std::uint64_t Offset = 0;
  std::uint64_t Length = 0;
  std::uint64_t Sum = 0;
};

struct SectionRef
{
  FourCC Name = 0;
  std::uint16_t Version = SectionVersion;
  std::uint16_t Flags = 0;
  StreamRef Payload; // its offset is behind the section's header
};

void PutSectionHeader(ByteWriter& out, const SectionRef& section);
SectionRef GetSectionHeader(ByteReader& in);

/** The first HeaderSize bytes of a file. */
Bytes MakeHeader(const ContainerKind& kind);

std::uint64_t Checksum(std::span<const std::uint8_t> bytes);

/** The checksum in the trailer, which covers the file's header and its directory. */
std::uint64_t GetFrameChecksum(std::span<const std::uint8_t> header, const Bytes& directory);

/** The size of the buffer for sections of any length. */
constexpr std::uint64_t CopyBytes = 4u << 20;

/** Computes the checksum of data that arrive in parts. */
class RunningChecksum
{
public:
  RunningChecksum();
  ~RunningChecksum();
  RunningChecksum(const RunningChecksum&) = delete;
  RunningChecksum& operator=(const RunningChecksum&) = delete;

  void Add(std::span<const std::uint8_t> bytes);
  std::uint64_t Get() const;

private:
  class State;
  std::unique_ptr<State> Self;
};
}

#endif
