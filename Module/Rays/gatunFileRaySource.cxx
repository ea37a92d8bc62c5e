// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileRaySource.h"

#include "gatunBytePlan.h"
#include "gatunChunkCache.h"
#include "gatunFileReader.h"
#include "gatunRayBlockCache.h"
#include "gatunRayBlockMaker.h"
#include "gatunRayDecoder.h"

namespace gatun
{
//------------------------------------------------------------------------------
class FileRaySource::Internals
{
public:
  Internals(
    std::shared_ptr<ChunkCache> parts, const RayValues& values, std::shared_ptr<CacheBudget> budget)
    : File(parts->GetFile())
    , Values(values)
    , Cache(std::move(budget))
    , Parts(std::move(parts))
  {
    CheckRayValues(*this->File, values);
    PieceRequest all;
    for (std::size_t chunk = 0; chunk < this->File->GetChunks().size(); ++chunk)
    {
      this->Boxes.push_back(this->File->GetChunkBounds(chunk, 0, values.Step));
      all.Chunks.push_back(static_cast<std::uint32_t>(chunk));
    }
    all.Arrays = { values.Array };
    all.Step = values.Step;
    FetchPiece(*this->File, all);
  }

  std::shared_ptr<const FileReader> File;
  RayValues Values;
  std::vector<Bounds> Boxes; // of the chunks
  RayBlockCache Cache;
  std::shared_ptr<ChunkCache> Parts; // for shared points
};

//------------------------------------------------------------------------------
FileRaySource::FileRaySource(
  std::shared_ptr<const FileReader> file, const RayValues& values, std::uint64_t budget)
{
  const auto forParts = GetBudgetForParts(budget);
  this->Self = std::make_unique<Internals>(std::make_shared<ChunkCache>(std::move(file), forParts),
    values, std::make_shared<CacheBudget>(budget - forParts));
}

FileRaySource::FileRaySource(std::shared_ptr<ChunkCache> parts, const RayValues& values)
{
  auto budget = parts->GetSharedBudget();
  this->Self = std::make_unique<Internals>(std::move(parts), values, std::move(budget));
}

FileRaySource::~FileRaySource() = default;

//------------------------------------------------------------------------------
std::size_t FileRaySource::GetNumberOfBlocks() const
{
  return this->Self->File->GetChunks().size();
}

//------------------------------------------------------------------------------
const Bounds& FileRaySource::GetBounds(std::size_t block) const
{
  return this->Self->Boxes[block];
}

//------------------------------------------------------------------------------
Range FileRaySource::GetRange(std::size_t block) const
{
  const auto& values = this->Self->Values;
  return GetDrawnRange(
    this->Self->File->GetChunkRanges(values.Array, values.Step, block), values.Component);
}

//------------------------------------------------------------------------------
RaySource::Blocks FileRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  return FindOrMake(this->Self->Cache, blocks, progress,
    [&](std::size_t chunk, RayBlock& block)
    { block = DecodeRayBlock(this->Self->Parts, this->Self->Values, chunk); });
}
}
