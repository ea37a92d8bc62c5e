// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileReader: layers and the sizes of parts.

#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunLayerTable.h"

#include <set>

namespace gatun
{
namespace
{
constexpr const char* LayersName = "the table of layers";
}

//------------------------------------------------------------------------------
void FileReader::Internals::ReadLayers()
{
  if (this->File.FindSections(SectionLayers).empty())
  {
    return;
  }
  const auto where = this->File.FindSection(SectionLayers, LayersName);
  this->LayersOfChunks = this->Guarded(LayersName, where,
    [&] { return gatun::ReadLayers(this->File.Read(where, LayersName), this->Meta, this->Mesh); });
  this->LayersAreKnown = true;
}

//------------------------------------------------------------------------------
void FileReader::Internals::CheckLayers() const
{
  if (!this->LayersAreKnown || this->Steps.empty())
  {
    return;
  }
  const Layers& layers = this->LayersOfChunks;
  const auto& ranges = this->Steps.front().Arrays[layers.Array].ChunkRanges;
  for (std::size_t chunk = 0; chunk < ranges.size(); ++chunk)
  {
    if (!IsInside(layers, layers.Chunks[chunk], GetRange(ranges[chunk], layers.Component)))
    {
      this->File.Fail(ErrorCode::Corrupt,
        "the values of chunk " + std::to_string(chunk) + " are not in the layers that " +
          LayersName + " tells");
    }
  }
}

//------------------------------------------------------------------------------
bool FileReader::HasLayers() const
{
  return this->Self->LayersAreKnown;
}

//------------------------------------------------------------------------------
const Layers& FileReader::GetLayers() const
{
  return this->Self->LayersOfChunks;
}

//------------------------------------------------------------------------------
std::uint64_t FileReader::GetPieceBytes(std::span<const std::uint32_t> chunks,
  std::span<const std::uint32_t> arrays, std::size_t step) const
{
  const auto& mesh = this->Self->Mesh;
  std::uint64_t bytes = 0;
  std::set<std::uint32_t> blocks;
  for (const auto chunk : chunks)
  {
    bytes += this->GetChunkMeshBytes(chunk);
    for (const auto array : arrays)
    {
      bytes += this->GetChunkArrayBytes(chunk, array, step);
    }
    for (const auto& part : mesh.Chunks[chunk].Shared)
    {
      blocks.insert(part.Block);
    }
  }
  for (const auto block : blocks)
  {
    bytes += mesh.Blocks[block].Geometry.Length;
    for (const auto array : arrays)
    {
      const auto& streams = this->Self->Steps.at(step).Arrays.at(array).Blocks;
      bytes += streams.empty() ? 0 : streams.at(block).Length; // cell arrays have no blocks
    }
  }
  return bytes;
}
}
