// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces of vtkGatunSurfaceMapper that are finer where the view needs it.

#include "vtkGatunSurfaceMapperInternals.h"

#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFrameClock.h"
#include "gatunRayRendering.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace
{
// Part of the budget for the transfer of chunks that change, as most visible ones do when the
// camera moves.
constexpr double TransferShare = 0.25;

// Fewer would hardly be faster.
constexpr std::uint64_t FewestCutPoints = 1000;

// Numbers of points are powers of the fourth root of 2, so that about the same time gives the same
// surface.
constexpr double StepsOfPoints = 4;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Wait()
{
  this->Cutter.Wait();
  this->Preparer.Wait();
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::ForgetCuts()
{
  for (CutLevel* const cut : { &this->Cut, &this->Next })
  {
    for (Chunk& chunk : cut->Chunks.Chunks)
    {
      this->Drop(chunk);
    }
    *cut = {};
  }
  this->Cutter.Clear();
  this->Ordered.reset();
  this->HasCutFailed = false;
  this->CutPoints = 0;
}

//------------------------------------------------------------------------------
bool vtkGatunSurfaceMapper::vtkInternals::HasCuts(const Image& image) const
{
  return image.Mapper->ViewDependent && !this->HasCutFailed &&
    this->Source.File->GetFile()->HasMergeTree();
}

//------------------------------------------------------------------------------
/** What an image needs, without a limit of points. Nothing for a view that shows nothing, such as
 * that of an actor without extent. */
std::optional<gatun::SurfaceCutOrder> vtkGatunSurfaceMapper::vtkInternals::MakeOrder(
  const Image& image) const
{
  vtkNew<vtkMatrix4x4> toWorld;
  image.Actor->GetMatrix(toWorld);
  gatun::RayGrid grid;
  const int* const size = image.Renderer->GetSize();
  grid.Width = std::max(1, size[0]);
  grid.Height = std::max(1, size[1]);
  grid.Aspect = image.Renderer->GetTiledAspectRatio();
  std::optional<gatun::RayView> rays;
  try
  {
    rays = gatun::MakeRayView(image.Renderer->GetActiveCamera(), grid, toWorld, true);
  }
  catch (const gatun::Error&)
  {
    return std::nullopt;
  }
  gatun::SurfaceCutOrder order{ this->Source, this->What, this->Whole->GetMerges(),
    image.MemoryLimit / 2, { *rays } };
  gatun::SurfaceDetailView& view = order.View;
  // A matrix that changes shapes has no one scale.
  view.Scale = std::cbrt(std::abs(toWorld->Determinant()));
  const int side = image.Camera.GetCulledSide();
  view.CullsBackFaces = side > 0;
  view.CullsFrontFaces = side < 0;
  vtkProperty* const property = image.Actor->GetProperty();
  view.IsOpaque = image.IsOpaque && property->GetOpacity() >= 1 &&
    property->GetRepresentation() == VTK_SURFACE && side >= 0 &&
    image.Mapper->GetNumberOfClippingPlanes() == 0;
  view.PixelError = image.Mapper->PixelError;
  return order;
}

//------------------------------------------------------------------------------
/** The number of points for a time. */
std::uint64_t vtkGatunSurfaceMapper::vtkInternals::CountPoints(double budget)
{
  const std::uint64_t all = this->Source.File->GetFile()->GetNumberOfPoints();
  const std::uint64_t cells =
    this->Times.CountCells(gatun::SurfaceTimes::Cut, (1 - TransferShare) * budget);
  const std::uint64_t fits = std::min(all, std::max(FewestCutPoints, cells / 2));
  const double step =
    std::floor(StepsOfPoints * std::log2(static_cast<double>(fits))) / StepsOfPoints;
  const auto points = static_cast<std::uint64_t>(std::exp2(step));
  const bool isGood = this->CutPoints > 0 && 4 * points < 5 * this->CutPoints &&
    this->Times.Predict(gatun::SurfaceTimes::Cut, 2 * this->CutPoints) <= budget;
  this->CutPoints = isGood ? this->CutPoints : points;
  return this->CutPoints;
}

//------------------------------------------------------------------------------
/** Has a surface made for the view, unless it is the last one. */
void vtkGatunSurfaceMapper::vtkInternals::OrderCut(const Image& image, double budget)
{
  if (!this->HasCuts(image) || this->Next.Cut || this->Cutter.IsBusy())
  {
    return;
  }
  auto order = this->MakeOrder(image);
  if (!order)
  {
    return;
  }
  order->View.Points = this->CountPoints(budget);
  if (this->Ordered != order->View)
  {
    this->Ordered = order->View;
    this->Cutter.Request(std::move(*order));
  }
}

//------------------------------------------------------------------------------
/** Takes the surface that was made last, as the next one. */
void vtkGatunSurfaceMapper::vtkInternals::TakeCut()
{
  const auto result = this->Cutter.Take();
  if (!result)
  {
    return;
  }
  if (result->Failure)
  {
    this->HasCutFailed = true;
    this->Failure = this->Failure ? this->Failure : result->Failure;
  }
  if (!result->Cut)
  {
    return;
  }
  this->Next.Cut = result->Cut;
  this->Next.Chunks.Mesh = result->Cut;
  this->Next.Chunks.Chunks.resize(result->Cut->GetNumberOfChunks());
}

//------------------------------------------------------------------------------
/** The chunks of the next surface that the present one does not have. */
std::vector<std::uint32_t> vtkGatunSurfaceMapper::vtkInternals::ListNew() const
{
  std::vector<std::uint32_t> chunks;
  for (std::uint32_t i = 0; i < this->Next.Chunks.Chunks.size(); ++i)
  {
    const bool isEmpty = this->Next.Cut->GetNumberOfCells(i) == 0;
    if (!isEmpty && (!this->Cut.Cut || this->Next.Cut->Differs(i, *this->Cut.Cut)))
    {
      chunks.push_back(i);
    }
  }
  return chunks;
}

//------------------------------------------------------------------------------
/** The next surface becomes the present one. Chunks that do not change stay. */
void vtkGatunSurfaceMapper::vtkInternals::AdoptCut()
{
  std::vector<Chunk>& before = this->Cut.Chunks.Chunks;
  std::vector<Chunk>& after = this->Next.Chunks.Chunks;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    if (i < after.size() && !this->Next.Cut->Differs(i, *this->Cut.Cut))
    {
      this->Drop(after[i]);
      after[i] = std::move(before[i]);
    }
    else
    {
      this->Drop(before[i]);
    }
  }
  this->Cut = std::move(this->Next);
  this->Next = {};
}

//------------------------------------------------------------------------------
/** Makes the chunks of the next surface ready, as far as there is time, and lets it take the place
 * of the present one once those are there that can be seen: all at once, as otherwise there would
 * be cracks. */
void vtkGatunSurfaceMapper::vtkInternals::AdvanceCut(const Image& image, double seconds)
{
  this->TakeCut();
  CutLevel& next = this->Next.Cut ? this->Next : this->Cut;
  if (!next.Cut)
  {
    return;
  }
  const View view = this->FindVisible(image, next.Chunks);
  std::vector<bool> isVisible(next.Chunks.Chunks.size());
  for (const std::uint32_t chunk : view.Chunks)
  {
    isVisible[chunk] = true;
  }
  std::vector<std::uint32_t> chunks;
  if (this->Next.Cut)
  {
    chunks = this->ListNew();
  }
  else
  {
    // Those that were out of the view when the surface was adopted.
    for (std::uint32_t i = 0; i < next.Chunks.Chunks.size(); ++i)
    {
      if (next.Cut->GetNumberOfCells(i) > 0)
      {
        chunks.push_back(i);
      }
    }
  }
  std::stable_partition(
    chunks.begin(), chunks.end(), [&](std::uint32_t chunk) { return isVisible[chunk]; });
  this->Prepare(image, next.Chunks, chunks);
  this->Transfer(image, next.Chunks, view, seconds);
  const bool isReady = std::all_of(chunks.begin(), chunks.end(),
    [&](std::uint32_t chunk)
    { return !isVisible[chunk] || next.Chunks.Chunks[chunk].IsTransferred; });
  if (this->Next.Cut && isReady)
  {
    this->AdoptCut();
  }
}

//------------------------------------------------------------------------------
/** Draws the surface for a view that is there. Returns false if there is none, or it takes too long
 * and longer than what is drawn otherwise. isLevelReady: whether that is as good as it can be. */
bool vtkGatunSurfaceMapper::vtkInternals::DrawCut(
  const Image& image, double budget, double otherwise, bool isLevelReady)
{
  constexpr double tooLong = 1.25;
  const auto predict = [&]
  {
    const std::uint64_t cells =
      this->Cut.Cut ? this->FindVisible(image, this->Cut.Chunks).Cells : 0;
    return this->Times.Predict(gatun::SurfaceTimes::Cut, cells);
  };
  this->AdvanceCut(
    image, std::max(TransferShare * std::max(budget, otherwise), 0.9 * budget - predict()));
  if (this->Cut.Cut || isLevelReady)
  {
    this->OrderCut(image, budget);
  }
  if (!this->Cut.Cut || predict() > tooLong * std::max(budget, otherwise))
  {
    return false;
  }
  const auto begin = gatun::FrameClock::now();
  const vtkIdType decodedBefore = this->Decoded;
  const View view = this->FindVisible(image, this->Cut.Chunks);
  this->Present = this->Levels.size();
  this->DrawLevel(image, this->Cut.Chunks, view);
  image.Renderer->GetRenderWindow()->WaitForCompletion();
  if (this->Decoded == decodedBefore)
  {
    this->Times.Learn(gatun::SurfaceTimes::Cut, view.Cells, gatun::SecondsSince(begin));
  }
  return true;
}

//------------------------------------------------------------------------------
/** Draws the surface with the error in pixels that is allowed. Returns false if all of it has to be
 * drawn, as there is no room for what it would be made of. */
bool vtkGatunSurfaceMapper::vtkInternals::DrawPreciseCut(const Image& image)
{
  this->Source.File->RequireHierarchy();
  const auto order = this->MakeOrder(image);
  if (!order)
  {
    return false;
  }
  if (!this->Cut.Cut || this->Ordered != order->View)
  {
    const auto progress = [&](double done)
    {
      image.Mapper->UpdateProgress(done);
      return image.Renderer->GetRenderWindow()->CheckAbortStatus() == 0;
    };
    gatun::SurfaceCutResult result = this->Cutter.Make(*order, progress);
    this->Ordered.reset();
    if (result.Failure)
    {
      std::rethrow_exception(result.Failure);
    }
    if (!result.Cut)
    {
      return false;
    }
    for (Chunk& chunk : this->Next.Chunks.Chunks)
    {
      this->Drop(chunk);
    }
    this->Next = { { result.Cut, std::vector<Chunk>(result.Cut->GetNumberOfChunks()) },
      result.Cut };
    this->AdoptCut();
    this->Ordered = order->View;
  }
  this->Present = this->Levels.size();
  this->DrawLevel(image, this->Cut.Chunks, this->FindVisible(image, this->Cut.Chunks));
  return true;
}
