// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSurfaceMapperInternals.h"

#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunParallel.h"
#include "gatunSurfaceGrid.h"

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
#include <map>

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
  const gatun::PublishedFile& file, double* bounds)
{
  const gatun::Bounds& box = file.File->GetFile()->GetBounds();
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
vtkGatunSurfaceMapper::vtkInternals::Contents vtkGatunSurfaceMapper::vtkInternals::FindContents(
  const gatun::PublishedFile& file, vtkGatunSurfaceMapper* mapper, vtkActor* actor)
{
  const gatun::FileReader& reader = *file.File->GetFile();
  Contents what;
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
    this->Source = {};
    return false;
  }
  Contents what = FindContents(*file, mapper, actor);
  if (file->File != this->Source.File || file->RestoreOrder != this->Source.RestoreOrder ||
    file->Merges != this->Source.Merges || what != this->What)
  {
    this->Forget();
    this->Chunks.clear();
    this->Chunks.resize(file->File->GetFile()->GetChunks().size());
  }
  this->Source = *file;
  this->What = std::move(what);
  return true;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Forget()
{
  for (Chunk& chunk : this->Chunks)
  {
    this->Drop(chunk);
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Drop(Chunk& chunk)
{
  chunk.Mapper = nullptr; // frees its buffers
  this->Bytes -= chunk.Bytes;
  chunk.Bytes = 0;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Release(vtkWindow* window)
{
  for (Chunk& chunk : this->Chunks)
  {
    if (chunk.Mapper)
    {
      chunk.Mapper->ReleaseGraphicsResources(window);
    }
  }
  this->Forget();
}

//------------------------------------------------------------------------------
/** The chunks of the piece that can be seen, in the order in which they are drawn. */
std::vector<std::uint32_t> vtkGatunSurfaceMapper::vtkInternals::FindVisible(
  vtkGatunSurfaceMapper* mapper, const gatun::SurfaceView& view, bool isOpaque)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = mapper->GetInputInformation();
  const auto pieces =
    static_cast<std::size_t>(std::max(1, Pipeline::GetUpdateNumberOfPieces(info)));
  const auto piece = static_cast<std::size_t>(std::max(0, Pipeline::GetUpdatePiece(info)));
  const auto& chunks = this->Source.File->GetFile()->GetChunks();
  std::vector<std::pair<double, std::uint32_t>> places;
  const std::size_t end = std::min(chunks.size(), chunks.size() * (piece + 1) / pieces);
  for (std::size_t i = chunks.size() * piece / pieces; i < end; ++i)
  {
    const gatun::Bounds& box = chunks[i].Box;
    if (!view.Reaches(box))
    {
      continue;
    }
    if (view.Culls(box, this->Chunks[i].Cone))
    {
      ++this->Culled;
      continue;
    }
    this->Chunks[i].Frame = this->Frame;
    places.emplace_back(
      isOpaque ? view.GetDepth(box) : -view.GetDepth(box), static_cast<std::uint32_t>(i));
  }
  std::sort(places.begin(), places.end());
  std::vector<std::uint32_t> visible(places.size());
  std::transform(
    places.begin(), places.end(), visible.begin(), [](auto& one) { return one.second; });
  return visible;
}

//------------------------------------------------------------------------------
/** The first ones that have to be decoded, as many as threads. */
std::vector<std::uint32_t> vtkGatunSurfaceMapper::vtkInternals::FindMissing(
  std::span<const std::uint32_t> chunks, vtkRenderer* renderer, vtkActor* actor) const
{
  const auto most = static_cast<std::size_t>(gatun::GetNumberOfThreads());
  std::vector<std::uint32_t> missing;
  for (const std::uint32_t chunk : chunks)
  {
    const auto& mapper = this->Chunks[chunk].Mapper;
    if (!mapper || mapper->NeedsMesh(renderer, actor))
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
vtkGatunSurfaceMapper::vtkInternals::Part vtkGatunSurfaceMapper::vtkInternals::Decode(
  std::uint32_t chunk, bool withIds) const
{
  const auto progress = [](double) { return true; };
  gatun::PieceReader reader;
  // The buffers take the place of decoded chunks.
  reader.Choose(this->Source, this->Source.Merges, false);
  gatun::PieceRequest request;
  request.Chunks = { chunk };
  request.Arrays = this->What.Arrays;
  request.Step = this->What.Step;
  request.Form = gatun::PieceForm::Original;
  request.RestoreOrder = this->Source.RestoreOrder;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  reader.Read(this->Source, request, false, grid, progress);
  if (withIds)
  {
    // Apart from the arrays, as one of them may be global ids that the user made.
    request.Arrays.clear();
    vtkNew<vtkUnstructuredGrid> ids;
    reader.Read(this->Source, request, true, ids, progress);
    grid->GetPointData()->AddArray(ids->GetPointData()->GetGlobalIds());
    grid->GetCellData()->AddArray(ids->GetCellData()->GetGlobalIds());
  }
  Part part;
  part.Mesh = vtkSmartPointer<vtkPolyData>::New();
  gatun::MakeSurface(grid, gatun::FindSurfaceCells(grid), part.Mesh);
  part.Cone = gatun::FindNormalCone(part.Mesh);
  return part;
}

//------------------------------------------------------------------------------
std::vector<vtkGatunSurfaceMapper::vtkInternals::Part>
vtkGatunSurfaceMapper::vtkInternals::DecodeAll(std::span<const std::uint32_t> chunks, bool withIds)
{
  std::vector<Part> parts(chunks.size());
  gatun::ParallelFor(chunks.size(),
    [&](std::size_t i)
    {
      try
      {
        parts[i] = this->Decode(chunks[i], withIds);
      }
      catch (...)
      {
        parts[i].Failure = std::current_exception();
      }
    });
  this->Decoded += static_cast<vtkIdType>(chunks.size());
  return parts;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Count(Chunk& chunk)
{
  this->Bytes -= chunk.Bytes;
  chunk.Bytes = chunk.Mapper->GetBytes();
  this->Bytes += chunk.Bytes;
}

//------------------------------------------------------------------------------
/** Frees chunks that are not in this image, those not seen for the longest time first, and then the
 * last one that was drawn. */
void vtkGatunSurfaceMapper::vtkInternals::MakeRoom(std::uint64_t budget, Chunk* last)
{
  while (this->Bytes > budget)
  {
    Chunk* oldest = last;
    for (Chunk& chunk : this->Chunks)
    {
      if (chunk.Mapper && chunk.Frame < (oldest ? oldest->Frame : this->Frame + 1))
      {
        oldest = &chunk;
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
void vtkGatunSurfaceMapper::vtkInternals::DrawChunk(vtkGatunSurfaceMapper* mapper,
  vtkRenderer* renderer, vtkActor* actor, std::uint32_t chunk, const Part* part)
{
  Chunk& self = this->Chunks[chunk];
  if (part)
  {
    this->Drop(self);
    self.Mapper = vtkSmartPointer<vtkGatunChunkMapper>::New();
    self.Mapper->SetWholeBounds(this->Source.File->GetFile()->GetBounds());
    self.Mapper->SetInputData(part->Mesh);
    self.Mapper->SetHasIds(this->IsSelecting);
    self.Mapper->SetNumber(chunk + 1);
    self.Cone = part->Cone;
  }
  self.Mapper->CopySettings(mapper);
  self.Mapper->SelectScalars(this->What.Scalars.c_str());
  self.Mapper->SetStatic(1);
  self.Mapper->RenderPiece(renderer, actor);
  ++this->Drawn;
  if (!part || this->IsSelecting)
  {
    return;
  }
  const std::uint64_t budget = MiB * static_cast<std::uint64_t>(mapper->MemoryBudget);
  this->Count(self);
  if (this->Bytes > budget / 4)
  {
    self.Mapper->FreeMesh();
    this->Count(self);
  }
  this->MakeRoom(budget, &self);
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
  const std::uint64_t budget = MiB * static_cast<std::uint64_t>(mapper->MemoryBudget);
  if (!this->IsSelecting)
  {
    this->MakeRoom(budget, nullptr);
  }
  const bool isOpaque = !actor->IsRenderingTranslucentPolygonalGeometry();
  const gatun::SurfaceView view(renderer, actor);
  const std::vector<std::uint32_t> visible = this->FindVisible(mapper, view, isOpaque);
  const vtkIdType decodedBefore = this->Decoded;
  std::map<std::uint32_t, Part> parts; // decoded and not yet drawn
  for (std::size_t i = 0; i < visible.size(); ++i)
  {
    const std::uint32_t chunk = visible[i];
    const auto& kept = this->Chunks[chunk].Mapper;
    if (!parts.contains(chunk) && (!kept || kept->NeedsMesh(renderer, actor)))
    {
      mapper->UpdateProgress(static_cast<double>(i) / static_cast<double>(visible.size()));
      if (window->CheckAbortStatus())
      {
        return;
      }
      const auto missing = this->FindMissing(std::span(visible).subspan(i), renderer, actor);
      auto made = this->DecodeAll(missing, this->IsSelecting);
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
      this->DrawChunk(mapper, renderer, actor, chunk, part);
    }
    if (part)
    {
      parts.erase(found);
    }
  }
  if (this->Decoded > decodedBefore)
  {
    mapper->UpdateProgress(1);
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
    if (number > 0 && number <= this->Chunks.size() && this->Chunks[number - 1].Mapper)
    {
      this->Chunks[number - 1].Mapper->ProcessSelectorPixelBuffers(selector, list, prop);
    }
  }
}
