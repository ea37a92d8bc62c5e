// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkBuffers.h"

#include <algorithm>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
ChunkedSurface* ChunkBuffers::Add(std::shared_ptr<const SurfaceLevel> mesh)
{
  const std::size_t chunks = mesh->GetNumberOfChunks();
  return &this->Surfaces.emplace_back(
    ChunkedSurface{ std::move(mesh), std::vector<SurfaceChunk>(chunks) });
}

//------------------------------------------------------------------------------
void ChunkBuffers::Remove(ChunkedSurface* surface)
{
  if (surface)
  {
    for (SurfaceChunk& chunk : surface->Chunks)
    {
      this->Drop(chunk);
    }
    this->Surfaces.remove_if([=](const ChunkedSurface& one) { return &one == surface; });
  }
}

//------------------------------------------------------------------------------
void ChunkBuffers::Replace(ChunkedSurface* before, ChunkedSurface& after,
  const std::optional<std::vector<std::uint32_t>>& changes)
{
  for (std::uint32_t i = 0; before && changes && i < after.Chunks.size(); ++i)
  {
    if (!std::binary_search(changes->begin(), changes->end(), i))
    {
      this->Drop(after.Chunks[i]);
      std::swap(after.Chunks[i], before->Chunks[i]);
    }
  }
  this->Remove(before);
}

//------------------------------------------------------------------------------
void ChunkBuffers::BeginFrame(vtkWindow* window, std::uint64_t limit)
{
  if (window != this->Window)
  {
    this->DropAll();
    this->Window = window;
  }
  this->Limit = limit;
  ++this->Frame;
}

//------------------------------------------------------------------------------
void ChunkBuffers::Adopt(SurfaceChunk& chunk, vtkGatunChunkMapper* mapper)
{
  this->Drop(chunk);
  chunk.Mapper = mapper;
  chunk.Frame = this->Frame;
}

//------------------------------------------------------------------------------
void ChunkBuffers::Keep(SurfaceChunk& chunk)
{
  const auto count = [&]
  {
    this->Bytes -= chunk.Bytes;
    chunk.Bytes = chunk.Mapper->GetBytes();
    this->Bytes += chunk.Bytes;
  };
  count();
  if (this->Bytes > this->Limit / 4 && chunk.IsTransferred)
  {
    chunk.Mapper->FreeMesh();
    count();
  }
  this->MakeRoom(&chunk);
}

//------------------------------------------------------------------------------
void ChunkBuffers::MakeRoom(SurfaceChunk* last)
{
  while (this->Bytes > this->Limit)
  {
    SurfaceChunk* oldest = last;
    for (ChunkedSurface& surface : this->Surfaces)
    {
      for (SurfaceChunk& chunk : surface.Chunks)
      {
        if (chunk.Mapper && chunk.Frame < (oldest ? oldest->Frame : this->Frame + 1))
        {
          oldest = &chunk;
        }
      }
    }
    if (!oldest || !oldest->Mapper)
    {
      return;
    }
    this->Drop(*oldest);
  }
}

//------------------------------------------------------------------------------
void ChunkBuffers::Drop(SurfaceChunk& chunk)
{
  chunk.Mapper = nullptr; // frees its buffers
  chunk.IsTransferred = false;
  this->Bytes -= chunk.Bytes;
  chunk.Bytes = 0;
}

//------------------------------------------------------------------------------
void ChunkBuffers::DropAll()
{
  for (ChunkedSurface& surface : this->Surfaces)
  {
    for (SurfaceChunk& chunk : surface.Chunks)
    {
      this->Drop(chunk);
    }
  }
}

//------------------------------------------------------------------------------
void ChunkBuffers::Release(vtkWindow* window)
{
  for (ChunkedSurface& surface : this->Surfaces)
  {
    for (SurfaceChunk& chunk : surface.Chunks)
    {
      if (chunk.Mapper)
      {
        chunk.Mapper->ReleaseGraphicsResources(window);
      }
    }
  }
  this->DropAll();
}
}
