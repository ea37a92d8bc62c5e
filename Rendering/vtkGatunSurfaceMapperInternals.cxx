// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSurfaceMapperInternals.h"

#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunParallel.h"
#include "gatunSimplifyTarget.h"

#include "vtkAbstractArray.h"
#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>

namespace
{
constexpr std::uint64_t MiB = std::uint64_t{ 1 } << 20;

//------------------------------------------------------------------------------
bool HasRole(const gatun::ArrayDescription& array, int attribute)
{
  return (array.AttributeRoles >> attribute & 1u) != 0;
}
}

//------------------------------------------------------------------------------
vtkGatunSurfaceMapper::vtkInternals::~vtkInternals()
{
  this->Forget();
}

//------------------------------------------------------------------------------
const gatun::PublishedFile* vtkGatunSurfaceMapper::vtkInternals::FindFile(
  vtkGatunSurfaceMapper* mapper)
{
  if (mapper->GetNumberOfInputConnections(0) < 1)
  {
    return nullptr;
  }
  const gatun::PublishedFile* const file = gatun::GetUsableFile(mapper->GetInputInformation());
  return file && file->OnDemand && file->File->GetFile()->IsSurface() ? file : nullptr;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::GetBounds(
  const gatun::PublishedFile& file, vtkInformation* info, double* bounds)
{
  const gatun::FileReader& reader = *file.File->GetFile();
  const gatun::Bounds box = reader.GetBounds(gatun::GetRequestedStep(reader, info));
  if (!box.IsEmpty())
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = box[axis].Min;
      bounds[2 * axis + 1] = box[axis].Max;
    }
  }
}

//------------------------------------------------------------------------------
gatun::SurfaceContents vtkGatunSurfaceMapper::vtkInternals::FindContents(
  const gatun::PublishedFile& file, vtkGatunSurfaceMapper* mapper, vtkActor* actor)
{
  const gatun::FileReader& reader = *file.File->GetFile();
  gatun::SurfaceContents what;
  what.Step = gatun::GetRequestedStep(reader, mapper->GetInputInformation());
  int where = 0;
  vtkAbstractArray* const scalars = mapper->ScalarVisibility && mapper->GetInput()
    ? vtkAbstractMapper::GetAbstractScalars(mapper->GetInput(), mapper->ScalarMode,
        mapper->ArrayAccessMode, mapper->ArrayId, mapper->ArrayName, where)
    : nullptr;
  if (scalars && scalars->GetName())
  {
    what.Scalars = scalars->GetName();
  }
  const bool hasTextures = mapper->HaveTextures(actor);
  const auto association = where == 0 ? gatun::Association::Point : gatun::Association::Cell;
  for (std::uint32_t i = 0; i < reader.GetArrays().size() && reader.GetNumberOfSteps() > 0; ++i)
  {
    const gatun::ArrayDescription& array = reader.GetArrays()[i];
    const bool gives =
      scalars && where < 2 && array.Where == association && array.Name == what.Scalars;
    if (file.Selected[i] &&
      (gives || HasRole(array, vtkDataSetAttributes::NORMALS) ||
        (hasTextures && HasRole(array, vtkDataSetAttributes::TCOORDS))))
    {
      what.Arrays.push_back(i);
    }
  }
  return what;
}

//------------------------------------------------------------------------------
bool vtkGatunSurfaceMapper::vtkInternals::Open(vtkGatunSurfaceMapper* mapper, vtkActor* actor)
{
  this->Failure = nullptr;
  this->Drawn = 0;
  this->Culled = 0;
  if (mapper->GetNumberOfInputConnections(0) > 0 && !mapper->GetStatic())
  {
    mapper->GetInputAlgorithm()->Update();
  }
  const gatun::PublishedFile* const file = FindFile(mapper);
  if (!file)
  {
    this->Forget();
    this->ForgetCuts();
    this->Source = {};
    return false;
  }
  gatun::SurfaceContents what = FindContents(*file, mapper, actor);
  const std::size_t merges = CountMerges(*file, mapper);
  const bool isSame = !this->Levels.empty() && file->File == this->Source.File &&
    file->RestoreOrder == this->Source.RestoreOrder && what == this->What;
  if (!isSame)
  {
    this->Forget();
    this->Levels.clear();
    this->HasLevels = false;
    this->Whole = nullptr;
    this->Preparer.Clear();
    this->ForgetCuts();
  }
  this->Source = *file;
  this->What = std::move(what);
  if (!isSame || merges != this->Levels.front().Mesh->GetMerges())
  {
    this->ChangeMerges(*file, merges);
  }
  return true;
}

//------------------------------------------------------------------------------
std::size_t vtkGatunSurfaceMapper::vtkInternals::CountMerges(
  const gatun::PublishedFile& file, vtkGatunSurfaceMapper* mapper)
{
  if (!(mapper->SimplificationRatio > 0))
  {
    return file.Merges;
  }
  file.File->RequireHierarchy();
  const gatun::FileReader& reader = *file.File->GetFile();
  const std::size_t merges =
    gatun::CountMerges({ gatun::SimplifyTarget::Ratio, mapper->SimplificationRatio },
      reader.GetNumberOfPoints(), reader.GetNumberOfMerges(), {});
  return std::max(merges, file.Merges);
}

//------------------------------------------------------------------------------
/** Draws the surface after another number of merges. Chunks that do not change stay. */
void vtkGatunSurfaceMapper::vtkInternals::ChangeMerges(
  const gatun::PublishedFile& file, std::size_t merges)
{
  auto mesh = std::make_shared<const gatun::SurfaceLevel>(file, merges, this->What);
  if (this->Levels.empty())
  {
    this->Levels.emplace_back();
  }
  Level& whole = this->Levels.front();
  const auto changes = this->Whole ? mesh->FindChanges(*this->Whole) : std::nullopt;
  if (changes)
  {
    for (const std::uint32_t chunk : *changes)
    {
      this->Drop(whole.Chunks[chunk]);
      whole.Chunks[chunk].Cone = {};
    }
  }
  else
  {
    std::for_each(
      whole.Chunks.begin(), whole.Chunks.end(), [this](Chunk& chunk) { this->Drop(chunk); });
    whole.Chunks.clear();
    whole.Chunks.resize(mesh->GetNumberOfChunks());
  }
  this->Whole = std::move(mesh);
  this->Ordered.reset();
  whole.Mesh = this->Whole;
  this->HasLevels = false;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSurfaceMapper::vtkInternals::GetDrawnPoints() const
{
  if (!this->Source.File || this->Levels.empty())
  {
    return 0;
  }
  const std::uint64_t points = this->Source.File->GetFile()->GetNumberOfPoints();
  return this->Merges > 0 ? static_cast<vtkIdType>(points - this->Merges) : 0;
}

//------------------------------------------------------------------------------
template <typename Use>
void vtkGatunSurfaceMapper::vtkInternals::EachChunk(const Use& use)
{
  for (Level& level : this->Levels)
  {
    std::for_each(level.Chunks.begin(), level.Chunks.end(), use);
  }
  for (CutLevel* const cut : { &this->Cut, &this->Next })
  {
    std::for_each(cut->Chunks.Chunks.begin(), cut->Chunks.Chunks.end(), use);
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Forget()
{
  this->EachChunk([this](Chunk& chunk) { this->Drop(chunk); });
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Drop(Chunk& chunk)
{
  chunk.Mapper = nullptr; // frees its buffers
  chunk.IsTransferred = false;
  this->Bytes -= chunk.Bytes;
  chunk.Bytes = 0;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Release(vtkWindow* window)
{
  this->EachChunk(
    [window](Chunk& chunk)
    {
      if (chunk.Mapper)
      {
        chunk.Mapper->ReleaseGraphicsResources(window);
      }
    });
  this->Forget();
}

//------------------------------------------------------------------------------
vtkGatunSurfaceMapper::vtkInternals::View vtkGatunSurfaceMapper::vtkInternals::FindVisible(
  const Image& image, Level& level) const
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = image.Mapper->GetInputInformation();
  const auto pieces =
    static_cast<std::size_t>(std::max(1, Pipeline::GetUpdateNumberOfPieces(info)));
  const auto piece = static_cast<std::size_t>(std::max(0, Pipeline::GetUpdatePiece(info)));
  const std::size_t count = level.Chunks.size();
  std::vector<std::pair<double, std::uint32_t>> places;
  View view;
  const std::size_t end = std::min(count, count * (piece + 1) / pieces);
  for (std::size_t i = count * piece / pieces; i < end; ++i)
  {
    const gatun::Bounds& box = level.Mesh->GetBox(i);
    if (!image.Camera.Reaches(box))
    {
      continue;
    }
    if (image.Camera.Culls(box, level.Chunks[i].Cone))
    {
      ++view.Culled;
      continue;
    }
    const double depth = image.Camera.GetDepth(box);
    places.emplace_back(image.IsOpaque ? depth : -depth, static_cast<std::uint32_t>(i));
    view.Cells += level.Mesh->GetNumberOfCells(i);
  }
  std::sort(places.begin(), places.end());
  view.Chunks.resize(places.size());
  std::transform(
    places.begin(), places.end(), view.Chunks.begin(), [](auto& one) { return one.second; });
  return view;
}

//------------------------------------------------------------------------------
/** The first ones that have to be decoded, as many as threads. */
std::vector<std::uint32_t> vtkGatunSurfaceMapper::vtkInternals::FindMissing(
  const Image& image, const Level& level, std::span<const std::uint32_t> chunks) const
{
  const auto most = static_cast<std::size_t>(gatun::GetNumberOfThreads());
  std::vector<std::uint32_t> missing;
  for (const std::uint32_t chunk : chunks)
  {
    const auto& mapper = level.Chunks[chunk].Mapper;
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
std::vector<gatun::SurfacePart> vtkGatunSurfaceMapper::vtkInternals::DecodeAll(
  const Level& level, std::span<const std::uint32_t> chunks, bool withIds)
{
  std::vector<Part> parts(chunks.size());
  gatun::ParallelFor(chunks.size(),
    [&](std::size_t i)
    { parts[i] = level.Mesh->Decode(chunks[i], withIds, [](double) { return true; }); });
  this->Decoded += static_cast<vtkIdType>(chunks.size());
  return parts;
}

//------------------------------------------------------------------------------
/** Frees chunks that are not in this image, those not seen for the longest time first, and then the
 * last one that was drawn. */
void vtkGatunSurfaceMapper::vtkInternals::MakeRoom(std::uint64_t budget, Chunk* last)
{
  while (this->Bytes > budget)
  {
    Chunk* oldest = last;
    this->EachChunk(
      [&](Chunk& chunk)
      {
        if (chunk.Mapper && chunk.Frame < (oldest ? oldest->Frame : this->Frame + 1))
        {
          oldest = &chunk;
        }
      });
    if (!oldest || !oldest->Mapper)
    {
      return;
    }
    this->Drop(*oldest);
  }
}

//------------------------------------------------------------------------------
/** Counts the memory of a chunk that was made for this image, and frees what is too much. */
void vtkGatunSurfaceMapper::vtkInternals::Keep(const Image& image, Chunk& chunk)
{
  const auto count = [&]
  {
    this->Bytes -= chunk.Bytes;
    chunk.Bytes = chunk.Mapper->GetBytes();
    this->Bytes += chunk.Bytes;
  };
  count();
  if (this->Bytes > image.MemoryLimit / 4 && chunk.IsTransferred)
  {
    chunk.Mapper->FreeMesh();
    count();
  }
  this->MakeRoom(image.MemoryLimit, &chunk);
}

//------------------------------------------------------------------------------
/** Takes a chunk that was decoded. */
void vtkGatunSurfaceMapper::vtkInternals::Adopt(
  const Image& image, Level& level, std::uint32_t chunk, const Part& part)
{
  Chunk& self = level.Chunks[chunk];
  this->Drop(self);
  self.Mapper = vtkSmartPointer<vtkGatunChunkMapper>::New();
  self.Mapper->SetWholeBounds(this->Source.File->GetFile()->GetBounds(this->What.Step));
  self.Mapper->SetInputData(part.Mesh);
  self.Mapper->SetHasIds(this->IsSelecting);
  self.Mapper->SetNumber(chunk + 1);
  self.Mapper->CopySettings(image.Mapper);
  self.Mapper->SelectScalars(this->What.Scalars.c_str());
  self.Mapper->SetStatic(1);
  self.Cone = part.Cone;
  self.Frame = this->Frame;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::DrawChunk(
  const Image& image, Level& level, std::uint32_t chunk, const Part* part)
{
  Chunk& self = level.Chunks[chunk];
  if (part)
  {
    this->Adopt(image, level, chunk, *part);
  }
  self.Mapper->CopySettings(image.Mapper);
  self.Mapper->SelectScalars(this->What.Scalars.c_str());
  self.Mapper->RenderPiece(image.Renderer, image.Actor);
  self.IsTransferred = true;
  ++this->Drawn;
  if (part && !this->IsSelecting)
  {
    this->Keep(image, self);
  }
}

//------------------------------------------------------------------------------
vtkGatunSurfaceMapper::vtkInternals::Image vtkGatunSurfaceMapper::vtkInternals::MakeImage(
  vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor)
{
  return { mapper, renderer, actor, gatun::SurfaceView(renderer, actor),
    !actor->IsRenderingTranslucentPolygonalGeometry(),
    MiB * static_cast<std::uint64_t>(mapper->MemoryBudget) };
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Draw(
  vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor)
{
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  if (window != this->Window)
  {
    // Buffers belong to a window.
    this->Forget();
    this->Window = window;
  }
  ++this->Frame;
  this->IsSelecting = renderer->GetSelector() != nullptr;
  const Image image = MakeImage(mapper, renderer, actor);
  if (!this->IsSelecting)
  {
    this->MakeRoom(image.MemoryLimit, nullptr);
  }
  if (this->Shared && this->Shared->Shown >= 0 && !this->IsSelecting)
  {
    this->DrawShared(image);
    return;
  }
  const double budget = this->Shared ? 0 : GetBudget(image);
  if (budget > 0 && !this->IsSelecting)
  {
    this->DrawInMotion(image, budget);
    return;
  }
  if (mapper->PixelError > 0 && !this->IsSelecting && this->DrawPreciseCut(image))
  {
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  const vtkIdType decodedBefore = this->Decoded;
  const View view = this->FindVisible(image, this->Levels.front());
  this->Present = 0;
  this->DrawLevel(image, this->Levels.front(), view);
  if (mapper->JustInTime && !this->IsSelecting && !window->GetAbortRender())
  {
    window->WaitForCompletion();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    this->PrepareMotion(image, view, this->Decoded == decodedBefore ? seconds.count() : 0);
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::DrawLevel(
  const Image& image, Level& level, const View& view)
{
  const std::vector<std::uint32_t>& visible = view.Chunks;
  this->Culled = view.Culled;
  this->Merges = level.Mesh->GetMerges();
  for (const std::uint32_t chunk : visible)
  {
    level.Chunks[chunk].Frame = this->Frame;
  }
  const vtkIdType decodedBefore = this->Decoded;
  std::map<std::uint32_t, Part> parts; // decoded and not yet drawn
  for (std::size_t i = 0; i < visible.size(); ++i)
  {
    const std::uint32_t chunk = visible[i];
    const auto& kept = level.Chunks[chunk].Mapper;
    if (!parts.contains(chunk) && (!kept || kept->NeedsMesh(image.Renderer, image.Actor)))
    {
      image.Mapper->UpdateProgress(static_cast<double>(i) / static_cast<double>(visible.size()));
      if (image.Renderer->GetRenderWindow()->CheckAbortStatus())
      {
        return;
      }
      const auto missing = this->FindMissing(image, level, std::span(visible).subspan(i));
      auto made = this->DecodeAll(level, missing, this->IsSelecting);
      for (std::size_t j = 0; j < missing.size(); ++j)
      {
        parts[missing[j]] = std::move(made[j]);
      }
    }
    const auto found = parts.find(chunk);
    const Part* const part = found != parts.end() ? &found->second : nullptr;
    if (part && part->Failure)
    {
      this->Failure = this->Failure ? this->Failure : part->Failure;
    }
    else
    {
      this->DrawChunk(image, level, chunk, part);
    }
    if (part)
    {
      parts.erase(found);
    }
  }
  if (this->Decoded > decodedBefore)
  {
    image.Mapper->UpdateProgress(1);
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::ProcessSelection(
  vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop)
{
  const int pass = vtkHardwareSelector::COMPOSITE_INDEX_PASS;
  const unsigned char* const drawn = selector->GetRawPixelBuffer(pass);
  unsigned char* const told = selector->GetPixelBuffer(pass);
  if (!drawn)
  {
    return;
  }
  std::map<std::uint32_t, std::vector<unsigned int>> pixelsOf;
  for (const unsigned int pixel : pixels)
  {
    const std::uint32_t number = drawn[pixel] + 256u * drawn[pixel + 1] + 65536u * drawn[pixel + 2];
    pixelsOf[number].push_back(pixel);
    if (told)
    {
      // The number of a chunk is nothing that concerns the user.
      std::fill_n(told + pixel, 3, static_cast<unsigned char>(0));
    }
  }
  for (auto& [number, list] : pixelsOf)
  {
    auto& chunks = this->Levels.front().Chunks;
    if (number > 0 && number <= chunks.size() && chunks[number - 1].Mapper)
    {
      chunks[number - 1].Mapper->ProcessSelectorPixelBuffers(selector, list, prop);
    }
  }
}
