// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayChunks.h"

#include "gatunChunkCache.h"
#include "gatunRayDecoder.h"

namespace gatun
{
//------------------------------------------------------------------------------
RayChunks::RayChunks(std::shared_ptr<ChunkCache> parts, const RayValues& values, bool keeps)
  : Parts(std::move(parts))
  , Values(values)
{
  CheckRayValues(*this->GetFile(), values);
  if (keeps)
  {
    this->Kept = std::make_unique<RayBlockCache>(this->Parts->GetSharedBudget());
  }
}

//------------------------------------------------------------------------------
const std::shared_ptr<const FileReader>& RayChunks::GetFile() const
{
  return this->Parts->GetFile();
}

//------------------------------------------------------------------------------
std::shared_ptr<const RayBlock> RayChunks::Get(std::uint32_t chunk)
{
  auto block = this->Kept ? this->Kept->Find(chunk) : nullptr;
  if (!block)
  {
    auto decoded = DecodeRayBlock(this->Parts, this->Values, chunk);
    decoded.Parents = {}; // simplified, it has other neighbors
    block = std::make_shared<const RayBlock>(std::move(decoded));
    if (this->Kept)
    {
      this->Kept->Add(chunk, block);
    }
  }
  return block;
}
}
