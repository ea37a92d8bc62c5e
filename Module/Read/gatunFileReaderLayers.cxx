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
  this->LayersOfChunks = this->File.Guarded(LayersName, where,
    [&]
    {
      return gatun::ReadLayers(
        this->File.Read(where, LayersName), this->Meta, this->GetTables().GetChunks().size());
    });
  this->LayersAreKnown = true;
}

//------------------------------------------------------------------------------
void FileReader::Internals::CheckLayers() const
{
  if (!this->LayersAreKnown || this->GetSteps().empty())
  {
    return;
  }
  const Layers& layers = this->LayersOfChunks;
  for (std::size_t chunk = 0; chunk < layers.Chunks.size(); ++chunk)
  {
    const auto ranges = this->GetTables().GetChunkRanges(chunk, layers.Array, 0);
    if (!IsInside(layers, layers.Chunks[chunk], GetRange(ranges, layers.Component)))
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
  const auto& tables = this->Self->GetTables();
  std::uint64_t bytes = 0;
  std::set<std::uint32_t> blocks;
  for (const auto chunk : chunks)
  {
    bytes += this->GetChunkMeshBytes(chunk);
    for (const auto array : arrays)
    {
      bytes += this->GetChunkArrayBytes(chunk, array, step);
    }
    const auto entry = tables.GetChunk(chunk);
    for (const auto& part : entry->Shared)
    {
      blocks.insert(part.Block);
    }
  }
  for (const auto block : blocks)
  {
    bytes += tables.GetBlock(block)->Geometry.Length;
    for (const auto array : arrays)
    {
      const bool ofPoints = this->GetArrays().at(array).Where == Association::Point;
      bytes += ofPoints ? tables.GetBlockValues(block, array, step).Length : 0;
    }
  }
  return bytes;
}
}
