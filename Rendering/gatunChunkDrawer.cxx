// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkDrawer.h"

#include "gatunFrameClock.h"
#include "gatunParallel.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace gatun
{
namespace
{
// Images after which a chunk is transferred even if it takes too long.
constexpr int MostWaiting = 10;
}

//------------------------------------------------------------------------------
SurfaceImage::SurfaceImage(vtkOpenGLPolyDataMapper* whole, vtkRenderer* renderer, vtkActor* actor,
  const DetailSettings& detail, std::uint64_t memoryLimit)
  : Whole(whole)
  , Renderer(renderer)
  , Actor(actor)
  , Detail(detail)
  , Camera(renderer, actor)
  , IsOpaque(!actor->IsRenderingTranslucentPolygonalGeometry())
  , IsSelection(renderer->GetSelector() != nullptr)
  , MemoryLimit(memoryLimit)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = whole->GetInputInformation();
  this->Piece = static_cast<std::size_t>(std::max(0, Pipeline::GetUpdatePiece(info)));
  this->Pieces = static_cast<std::size_t>(std::max(1, Pipeline::GetUpdateNumberOfPieces(info)));
}

//------------------------------------------------------------------------------
void ChunkDrawer::SetContents(const Bounds& box, const std::string& scalars)
{
  this->Box = box;
  this->Scalars = scalars;
}

//------------------------------------------------------------------------------
void ChunkDrawer::Reset()
{
  this->Failure = nullptr;
  this->Numbers.Drawn = 0;
  this->Numbers.Culled = 0;
}

//------------------------------------------------------------------------------
void ChunkDrawer::BeginFrame(const SurfaceImage& image)
{
  this->Buffers.BeginFrame(image.Renderer->GetRenderWindow(), image.MemoryLimit);
  if (!image.IsSelection)
  {
    this->Buffers.MakeRoom(nullptr);
  }
}

//------------------------------------------------------------------------------
void ChunkDrawer::NoteFailure(const std::exception_ptr& failure)
{
  this->Failure = this->Failure ? this->Failure : failure;
}

//------------------------------------------------------------------------------
VisibleChunks ChunkDrawer::FindVisible(
  const SurfaceImage& image, const ChunkedSurface& surface) const
{
  const std::size_t count = surface.Chunks.size();
  std::vector<std::pair<double, std::uint32_t>> places;
  VisibleChunks view;
  const std::size_t end = std::min(count, count * (image.Piece + 1) / image.Pieces);
  for (std::size_t i = count * image.Piece / image.Pieces; i < end; ++i)
  {
    const Bounds& box = surface.Mesh->GetBox(i);
    if (!image.Camera.Reaches(box))
    {
      continue;
    }
    if (image.Camera.Culls(box, surface.Chunks[i].Cone))
    {
      ++view.Culled;
      continue;
    }
    const double depth = image.Camera.GetDepth(box);
    places.emplace_back(image.IsOpaque ? depth : -depth, static_cast<std::uint32_t>(i));
    view.Cells += surface.Mesh->GetNumberOfCells(i);
  }
  std::sort(places.begin(), places.end());
  view.Chunks.resize(places.size());
  std::transform(
    places.begin(), places.end(), view.Chunks.begin(), [](auto& one) { return one.second; });
  return view;
}

//------------------------------------------------------------------------------
/** The first ones that have to be decoded, as many as threads. */
std::vector<std::uint32_t> ChunkDrawer::FindMissing(const SurfaceImage& image,
  const ChunkedSurface& surface, std::span<const std::uint32_t> chunks) const
{
  const auto most = static_cast<std::size_t>(GetNumberOfThreads());
  std::vector<std::uint32_t> missing;
  for (const std::uint32_t chunk : chunks)
  {
    const auto& mapper = surface.Chunks[chunk].Mapper;
    if (!mapper || mapper->NeedsMesh(image.Renderer, image.Actor))
    {
      missing.push_back(chunk);
      if (missing.size() == most)
      {
        break;
      }
    }
  }
  return missing;
}

//------------------------------------------------------------------------------
std::vector<SurfacePart> ChunkDrawer::DecodeAll(
  const ChunkedSurface& surface, std::span<const std::uint32_t> chunks, bool withIds)
{
  std::vector<SurfacePart> parts(chunks.size());
  ParallelFor(chunks.size(),
    [&](std::size_t i)
    { parts[i] = surface.Mesh->Decode(chunks[i], withIds, [](double) { return true; }); });
  this->Numbers.Decoded += chunks.size();
  return parts;
}

//------------------------------------------------------------------------------
/** Takes a chunk that was decoded. */
void ChunkDrawer::Adopt(
  const SurfaceImage& image, ChunkedSurface& surface, std::uint32_t chunk, const SurfacePart& part)
{
  SurfaceChunk& self = surface.Chunks[chunk];
  auto mapper = vtkSmartPointer<vtkGatunChunkMapper>::New();
  mapper->SetWholeBounds(this->Box);
  mapper->SetInputData(part.Mesh);
  mapper->SetHasIds(image.IsSelection);
  mapper->SetNumber(chunk + 1);
  mapper->CopySettings(image.Whole);
  mapper->SelectScalars(this->Scalars.c_str());
  mapper->SetStatic(1);
  this->Buffers.Adopt(self, mapper);
  self.Cone = part.Cone;
}

//------------------------------------------------------------------------------
void ChunkDrawer::DrawChunk(
  const SurfaceImage& image, ChunkedSurface& surface, std::uint32_t chunk, const SurfacePart* part)
{
  SurfaceChunk& self = surface.Chunks[chunk];
  if (part)
  {
    this->Adopt(image, surface, chunk, *part);
  }
  self.Mapper->CopySettings(image.Whole);
  self.Mapper->SelectScalars(this->Scalars.c_str());
  self.Mapper->RenderPiece(image.Renderer, image.Actor);
  self.IsTransferred = true;
  ++this->Numbers.Drawn;
  if (part && !image.IsSelection)
  {
    this->Buffers.Keep(self);
  }
}

//------------------------------------------------------------------------------
void ChunkDrawer::Draw(
  const SurfaceImage& image, ChunkedSurface& surface, const VisibleChunks& view)
{
  const std::vector<std::uint32_t>& visible = view.Chunks;
  this->Numbers.Culled = view.Culled;
  this->Numbers.Merges = surface.Mesh->GetMerges();
  for (const std::uint32_t chunk : visible)
  {
    surface.Chunks[chunk].Frame = this->Buffers.GetFrame();
  }
  const std::uint64_t decodedBefore = this->Numbers.Decoded;
  std::map<std::uint32_t, SurfacePart> parts; // decoded and not yet drawn
  for (std::size_t i = 0; i < visible.size(); ++i)
  {
    const std::uint32_t chunk = visible[i];
    const auto& kept = surface.Chunks[chunk].Mapper;
    if (!parts.contains(chunk) && (!kept || kept->NeedsMesh(image.Renderer, image.Actor)))
    {
      image.Whole->UpdateProgress(static_cast<double>(i) / static_cast<double>(visible.size()));
      if (image.Renderer->GetRenderWindow()->CheckAbortStatus())
      {
        return;
      }
      const auto missing = this->FindMissing(image, surface, std::span(visible).subspan(i));
      auto made = this->DecodeAll(surface, missing, image.IsSelection);
      for (std::size_t j = 0; j < missing.size(); ++j)
      {
        parts[missing[j]] = std::move(made[j]);
      }
    }
    const auto found = parts.find(chunk);
    const SurfacePart* const part = found != parts.end() ? &found->second : nullptr;
    if (part && part->Failure)
    {
      this->NoteFailure(part->Failure);
    }
    else
    {
      this->DrawChunk(image, surface, chunk, part);
    }
    if (part)
    {
      parts.erase(found);
    }
  }
  if (this->Numbers.Decoded > decodedBefore)
  {
    image.Whole->UpdateProgress(1);
  }
}

//------------------------------------------------------------------------------
void ChunkDrawer::DrawTimed(
  const SurfaceImage& image, ChunkedSurface& surface, const VisibleChunks& view, std::size_t level)
{
  const auto begin = FrameClock::now();
  const std::uint64_t decodedBefore = this->Numbers.Decoded;
  this->Draw(image, surface, view);
  image.Renderer->GetRenderWindow()->WaitForCompletion();
  if (this->Numbers.Decoded == decodedBefore)
  {
    this->Times.Learn(level, view.Cells, SecondsSince(begin));
  }
}

//------------------------------------------------------------------------------
bool ChunkDrawer::IsReady(
  const SurfaceImage& image, const ChunkedSurface& surface, const VisibleChunks& view) const
{
  return std::all_of(view.Chunks.begin(), view.Chunks.end(),
    [&](std::uint32_t chunk)
    {
      const SurfaceChunk& self = surface.Chunks[chunk];
      return self.Mapper && self.IsTransferred &&
        !self.Mapper->NeedsMesh(image.Renderer, image.Actor);
    });
}

//------------------------------------------------------------------------------
void ChunkDrawer::Prepare(
  const SurfaceImage& image, ChunkedSurface& surface, const std::vector<std::uint32_t>& chunks)
{
  std::vector<std::uint32_t> missing;
  for (const std::uint32_t chunk : chunks)
  {
    const auto& mapper = surface.Chunks[chunk].Mapper;
    if (mapper && !mapper->NeedsMesh(image.Renderer, image.Actor))
    {
      continue;
    }
    const auto part = this->Preparer.Take(surface.Mesh.get(), chunk);
    if (!part)
    {
      missing.push_back(chunk);
    }
    else if (part->Failure)
    {
      this->NoteFailure(part->Failure);
    }
    else
    {
      ++this->Numbers.Decoded;
      this->Adopt(image, surface, chunk, *part);
      this->Buffers.Keep(surface.Chunks[chunk]);
    }
  }
  this->Preparer.Prepare(surface.Mesh, std::move(missing));
}

//------------------------------------------------------------------------------
void ChunkDrawer::Complete(
  const SurfaceImage& image, ChunkedSurface& surface, const VisibleChunks& view)
{
  bool isComplete = false;
  while (!isComplete)
  {
    const auto missing = this->FindMissing(image, surface, view.Chunks);
    const auto parts = this->DecodeAll(surface, missing, false);
    isComplete = missing.empty();
    for (std::size_t i = 0; i < missing.size() && !isComplete; ++i)
    {
      isComplete = parts[i].Failure != nullptr;
      if (!isComplete)
      {
        SurfaceChunk& self = surface.Chunks[missing[i]];
        this->Adopt(image, surface, missing[i], parts[i]);
        this->Buffers.Keep(self);
        // Where there is no room at all.
        isComplete = !self.Mapper;
      }
    }
  }
}

//------------------------------------------------------------------------------
void ChunkDrawer::Transfer(
  const SurfaceImage& image, ChunkedSurface& surface, const VisibleChunks& view, double seconds)
{
  const auto begin = FrameClock::now();
  ++this->Waiting;
  for (const std::uint32_t chunk : view.Chunks)
  {
    SurfaceChunk& self = surface.Chunks[chunk];
    if (!self.Mapper || self.IsTransferred || self.Mapper->NeedsMesh(image.Renderer, image.Actor))
    {
      continue;
    }
    const std::uint64_t cells = surface.Mesh->GetNumberOfCells(chunk);
    const double left = seconds - SecondsSince(begin);
    if (this->Times.PredictTransfer(cells) > left && this->Waiting <= MostWaiting)
    {
      break;
    }
    const auto start = FrameClock::now();
    self.Mapper->Transfer(image.Renderer, image.Actor);
    self.IsTransferred = true;
    self.Frame = this->Buffers.GetFrame();
    this->Buffers.Keep(self);
    this->Times.LearnTransfer(cells, SecondsSince(start));
    this->Waiting = 0;
  }
}
}
