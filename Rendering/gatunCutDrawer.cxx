// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCutDrawer.h"

#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunRayRendering.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gatun
{
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
void CutDrawer::Drop(Cut& cut)
{
  this->Chunks.Buffers.Remove(cut.Chunks);
  cut = {};
}

//------------------------------------------------------------------------------
void CutDrawer::Clear()
{
  this->Drop(this->Present);
  this->Drop(this->Next);
  this->Cutter.Clear();
  this->Ordered.reset();
  this->HasFailed = false;
  this->Points = 0;
  this->Surface = {};
}

//------------------------------------------------------------------------------
void CutDrawer::SetSurface(const DrawnSurface& surface)
{
  this->Surface = surface;
  this->Ordered.reset();
}

//------------------------------------------------------------------------------
bool CutDrawer::CanCut(const SurfaceImage& image) const
{
  return image.Detail.ViewDependent && !this->HasFailed &&
    this->Surface.Source.File->GetFile()->HasMergeTree();
}

//------------------------------------------------------------------------------
/** What an image needs, without a limit of points. Nothing for a view that shows nothing, such as
 * that of an actor without extent. */
std::optional<SurfaceCutOrder> CutDrawer::MakeOrder(const SurfaceImage& image) const
{
  vtkNew<vtkMatrix4x4> toWorld;
  image.Actor->GetMatrix(toWorld);
  RayGrid grid;
  const int* const size = image.Renderer->GetSize();
  grid.Width = std::max(1, size[0]);
  grid.Height = std::max(1, size[1]);
  grid.Aspect = image.Renderer->GetTiledAspectRatio();
  std::optional<RayView> rays;
  try
  {
    rays = MakeRayView(image.Renderer->GetActiveCamera(), grid, toWorld, true);
  }
  catch (const Error&)
  {
    return std::nullopt;
  }
  SurfaceCutOrder order{ this->Surface.Source, this->Surface.What, this->Surface.Mesh->GetMerges(),
    image.MemoryLimit / 2, { *rays } };
  SurfaceDetailView& view = order.View;
  // A matrix that changes shapes has no one scale.
  view.Scale = std::cbrt(std::abs(toWorld->Determinant()));
  const int side = image.Camera.GetCulledSide();
  view.CullsBackFaces = side > 0;
  view.CullsFrontFaces = side < 0;
  vtkProperty* const property = image.Actor->GetProperty();
  view.IsOpaque = image.IsOpaque && property->GetOpacity() >= 1 &&
    property->GetRepresentation() == VTK_SURFACE && side >= 0 &&
    image.Whole->GetNumberOfClippingPlanes() == 0;
  view.PixelError = image.Detail.PixelError;
  return order;
}

//------------------------------------------------------------------------------
/** The number of points for a time. */
std::uint64_t CutDrawer::CountPoints(double budget)
{
  const SurfaceTimes& times = this->Chunks.Times;
  const std::uint64_t all = this->Surface.Source.File->GetFile()->GetNumberOfPoints();
  const std::uint64_t cells = times.CountCells(SurfaceTimes::Cut, (1 - TransferShare) * budget);
  const std::uint64_t fits = std::min(all, std::max(FewestCutPoints, cells / 2));
  const double step =
    std::floor(StepsOfPoints * std::log2(static_cast<double>(fits))) / StepsOfPoints;
  const auto points = static_cast<std::uint64_t>(std::exp2(step));
  const bool isGood = this->Points > 0 && 4 * points < 5 * this->Points &&
    times.Predict(SurfaceTimes::Cut, 2 * this->Points) <= budget;
  this->Points = isGood ? this->Points : points;
  return this->Points;
}

//------------------------------------------------------------------------------
void CutDrawer::Request(const SurfaceImage& image, double budget)
{
  if (!this->CanCut(image) || this->IsAdvancing() || this->Cutter.IsBusy())
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
void CutDrawer::SetNext(std::shared_ptr<const SurfaceLevel> mesh)
{
  this->Drop(this->Next);
  this->Next.Changes = this->Present.Mesh ? mesh->FindChanges(*this->Present.Mesh) : std::nullopt;
  this->Next.Chunks = this->Chunks.Buffers.Add(mesh);
  this->Next.Mesh = std::move(mesh);
}

//------------------------------------------------------------------------------
/** Takes the surface that was made last, as the next one. */
void CutDrawer::Take()
{
  const auto result = this->Cutter.Take();
  if (!result)
  {
    return;
  }
  if (result->Failure)
  {
    this->HasFailed = true;
    this->Chunks.NoteFailure(result->Failure);
  }
  if (result->Cut)
  {
    this->SetNext(result->Cut);
  }
}

//------------------------------------------------------------------------------
/** The chunks that the next surface has and the present one does not; or all of the present one,
 * some of which may have been out of the view when it was adopted. */
std::vector<std::uint32_t> CutDrawer::ListNeeded() const
{
  const Cut& cut = this->IsAdvancing() ? this->Next : this->Present;
  std::vector<std::uint32_t> chunks(cut.Chunks->Chunks.size());
  std::iota(chunks.begin(), chunks.end(), 0u);
  if (this->IsAdvancing() && cut.Changes)
  {
    chunks = *cut.Changes;
  }
  std::erase_if(
    chunks, [&](std::uint32_t chunk) { return cut.Mesh->GetNumberOfCells(chunk) == 0; });
  return chunks;
}

//------------------------------------------------------------------------------
/** The next surface becomes the present one. Chunks that do not change stay. */
void CutDrawer::Adopt()
{
  this->Chunks.Buffers.Replace(this->Present.Chunks, *this->Next.Chunks, this->Next.Changes);
  this->Present = std::exchange(this->Next, {});
}

//------------------------------------------------------------------------------
/** Makes the chunks of the next surface ready, as far as there is time, and lets it take the place
 * of the present one once those are there that can be seen: all at once, as otherwise there would
 * be cracks. */
void CutDrawer::Advance(const SurfaceImage& image, double seconds)
{
  this->Take();
  const Cut next = this->IsAdvancing() ? this->Next : this->Present;
  if (!next.Mesh)
  {
    return;
  }
  const VisibleChunks view = this->Chunks.FindVisible(image, *next.Chunks);
  std::vector<bool> isVisible(next.Chunks->Chunks.size());
  for (const std::uint32_t chunk : view.Chunks)
  {
    isVisible[chunk] = true;
  }
  std::vector<std::uint32_t> chunks = this->ListNeeded();
  std::stable_partition(
    chunks.begin(), chunks.end(), [&](std::uint32_t chunk) { return isVisible[chunk]; });
  this->Chunks.Prepare(image, *next.Chunks, chunks);
  this->Chunks.Transfer(image, *next.Chunks, view, seconds);
  const bool isReady = std::all_of(chunks.begin(), chunks.end(),
    [&](std::uint32_t chunk)
    { return !isVisible[chunk] || next.Chunks->Chunks[chunk].IsTransferred; });
  if (this->IsAdvancing() && isReady)
  {
    this->Adopt();
  }
}

//------------------------------------------------------------------------------
bool CutDrawer::DrawInMotion(
  const SurfaceImage& image, double budget, double otherwise, bool isReady)
{
  constexpr double tooLong = 1.25;
  if (!this->CanCut(image))
  {
    return false;
  }
  const auto predict = [&]
  {
    const std::uint64_t cells =
      this->Present.Mesh ? this->Chunks.FindVisible(image, *this->Present.Chunks).Cells : 0;
    return this->Chunks.Times.Predict(SurfaceTimes::Cut, cells);
  };
  this->Advance(
    image, std::max(TransferShare * std::max(budget, otherwise), 0.9 * budget - predict()));
  if (this->Present.Mesh || isReady)
  {
    this->Request(image, budget);
  }
  if (!this->Present.Mesh || predict() > tooLong * std::max(budget, otherwise))
  {
    return false;
  }
  this->Chunks.DrawTimed(image, *this->Present.Chunks,
    this->Chunks.FindVisible(image, *this->Present.Chunks), SurfaceTimes::Cut);
  return true;
}

//------------------------------------------------------------------------------
bool CutDrawer::DrawPrecise(const SurfaceImage& image)
{
  this->Surface.Source.File->RequireHierarchy();
  const auto order = this->MakeOrder(image);
  if (!order)
  {
    return false;
  }
  if (!this->Present.Mesh || this->Ordered != order->View)
  {
    const auto progress = [&](double done)
    {
      image.Whole->UpdateProgress(done);
      return image.Renderer->GetRenderWindow()->CheckAbortStatus() == 0;
    };
    const SurfaceCutResult result = this->Cutter.Make(*order, progress);
    this->Ordered.reset();
    if (result.Failure)
    {
      std::rethrow_exception(result.Failure);
    }
    if (!result.Cut)
    {
      return false;
    }
    this->SetNext(result.Cut);
    this->Adopt();
    this->Ordered = order->View;
  }
  this->Chunks.Draw(
    image, *this->Present.Chunks, this->Chunks.FindVisible(image, *this->Present.Chunks));
  return true;
}
}
