// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunVolumeMapperInternals.h"

#include "gatunError.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunFrameClock.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <span>

using gatun::ImageSetup;
using gatun::InputKind;
using gatun::Viewport;

//------------------------------------------------------------------------------
gatun::Viewport::Viewport(vtkRenderer* renderer)
{
  renderer->GetTiledSizeAndOrigin(&this->Width, &this->Height, &this->X, &this->Y);
}

//------------------------------------------------------------------------------
gatun::RayGrid gatun::MakeGrid(vtkRenderer* renderer, const Viewport& viewport, float distance)
{
  const bool toBorders =
    distance > 1 || std::max(viewport.Width, viewport.Height) > gatun::RayImage::MostPixels;
  const auto count = [&](int pixels)
  { return toBorders ? std::max(2, static_cast<int>(std::ceil(pixels / distance))) : pixels; };
  return { count(viewport.Width), count(viewport.Height), renderer->GetTiledAspectRatio(),
    toBorders };
}

//------------------------------------------------------------------------------
/** Brings the information of the input up to date, in which a reader publishes its file. */
void vtkGatunVolumeMapper::vtkInternals::UpdateInformation(const gatun::RayProducer& producer)
{
  auto* const pipeline = vtkDemandDrivenPipeline::SafeDownCast(producer.Algorithm->GetExecutive());
  if (!pipeline)
  {
    return;
  }
  pipeline->UpdatePipelineMTime();
  const vtkMTimeType time = pipeline->GetPipelineMTime();
  if (producer.Algorithm == this->FailedInput && time == this->FailedTime)
  {
    return;
  }
  const bool isKnown = pipeline->UpdateInformation() != 0;
  this->FailedInput = isKnown ? nullptr : producer.Algorithm;
  this->FailedTime = time;
}

//------------------------------------------------------------------------------
/** The file to be drawn in place of the input, if there is one; it may have failed to open. */
const gatun::PublishedFile* vtkGatunVolumeMapper::vtkInternals::FindFile(
  vtkGatunVolumeMapper* mapper)
{
  const gatun::RayProducer producer = gatun::GetProducer(mapper);
  if (!producer.Algorithm)
  {
    return nullptr;
  }
  this->UpdateInformation(producer);
  const gatun::PublishedFile* const handle =
    gatun::GetPublishedFile(producer.Algorithm->GetOutputInformation(producer.Port));
  return handle && (!handle->File || handle->CanReplaceOutput()) ? handle : nullptr;
}

//------------------------------------------------------------------------------
/** The same, but throws if it failed to open. */
const gatun::PublishedFile& vtkGatunVolumeMapper::vtkInternals::GetFile(
  vtkGatunVolumeMapper* mapper)
{
  const gatun::PublishedFile* const handle = this->FindFile(mapper);
  if (!handle->File)
  {
    std::rethrow_exception(handle->Failure);
  }
  return *handle;
}

//------------------------------------------------------------------------------
InputKind vtkGatunVolumeMapper::vtkInternals::GetKind(vtkGatunVolumeMapper* mapper)
{
  vtkAlgorithm* const input = gatun::GetProducer(mapper).Algorithm;
  if (!input)
  {
    return InputKind::None;
  }
  if (this->FindFile(mapper))
  {
    return InputKind::File;
  }
  // A grid that was given as such is there as a whole, whatever piece is asked for.
  return mapper->NumberOfPieces > 1 && !vtkTrivialProducer::SafeDownCast(input) ? InputKind::Pieces
                                                                                : InputKind::Grid;
}

//------------------------------------------------------------------------------
gatun::RayArray vtkGatunVolumeMapper::vtkInternals::GetArray(vtkGatunVolumeMapper* mapper)
{
  gatun::RayArray array;
  array.Component = mapper->ArrayComponent;
  const int mode = mapper->ScalarMode;
  if (mode == VTK_SCALAR_MODE_DEFAULT)
  {
    return array;
  }
  const bool ofPoints =
    mode == VTK_SCALAR_MODE_USE_POINT_DATA || mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  const bool ofCells =
    mode == VTK_SCALAR_MODE_USE_CELL_DATA || mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  if (!ofPoints && !ofCells)
  {
    throw gatun::Error(
      gatun::ErrorCode::InvalidInput, "only arrays of points and of cells can be drawn");
  }
  array.Association = ofPoints ? 0 : 1;
  if (mode == VTK_SCALAR_MODE_USE_POINT_DATA || mode == VTK_SCALAR_MODE_USE_CELL_DATA)
  {
    return array;
  }
  if (mapper->ArrayAccessMode == VTK_GET_ARRAY_BY_ID)
  {
    array.Index = mapper->ArrayId;
    return array;
  }
  array.Name = mapper->ArrayName;
  if (array.Name.empty())
  {
    throw gatun::Error(gatun::ErrorCode::InvalidInput, "no array to draw is selected");
  }
  return array;
}

//------------------------------------------------------------------------------
std::uint64_t vtkGatunVolumeMapper::vtkInternals::GetBudget(vtkGatunVolumeMapper* mapper)
{
  return static_cast<std::uint64_t>(mapper->MemoryBudget) << 20;
}

//------------------------------------------------------------------------------
bool vtkGatunVolumeMapper::vtkInternals::Simplifies(vtkGatunVolumeMapper* mapper)
{
  const gatun::PublishedFile* const file = this->FindFile(mapper);
  if (!file && IsParallel(mapper))
  {
    return false; // parts that are simplified separately do not fit together
  }
  const gatun::DetailSettings detail(this->Policy.Get());
  return detail.JustInTime || detail.Ratio > 0 || detail.PixelError > 0 ||
    (file && file->Merges > 0);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::Pull(vtkGatunVolumeMapper* mapper)
{
  const gatun::RayProducer producer = gatun::GetProducer(mapper);
  switch (GetKind(mapper))
  {
    case InputKind::None:
      break;
    case InputKind::Grid:
    {
      // A grid that was given as such is the part of this process.
      const bool isGiven = vtkTrivialProducer::SafeDownCast(producer.Algorithm) != nullptr;
      const auto share = isGiven ? gatun::PieceShare{} : GetPieces(mapper);
      gatun::PullPiece(producer, share.Process, share.Processes);
      break;
    }
    case InputKind::File:
    case InputKind::Pieces:
      // vtkVolume draws nothing where there is no object, even if it is empty.
      producer.Algorithm->UpdateDataObject();
      break;
  }
}

//------------------------------------------------------------------------------
/** Whether there is something to draw. */
bool vtkGatunVolumeMapper::vtkInternals::SetScene(
  vtkGatunVolumeMapper* mapper, const gatun::RaySource::Progress& progress)
{
  const gatun::RayProducer producer = gatun::GetProducer(mapper);
  const auto budget = GetBudget(mapper);
  switch (GetKind(mapper))
  {
    case InputKind::None:
      return false;
    case InputKind::File:
    {
      const gatun::PublishedFile& file = this->GetFile(mapper);
      const auto step = gatun::GetRequestedStep(
        *file.File->GetFile(), producer.Algorithm->GetOutputInformation(producer.Port));
      this->Scene.SetFile(file, step, GetArray(mapper), this->Simplifies(mapper));
      return true;
    }
    case InputKind::Pieces:
      this->Scene.SetPieces(producer, GetPieces(mapper), GetArray(mapper), budget, progress);
      return true;
    case InputKind::Grid:
      break;
  }
  Pull(mapper);
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(mapper->GetDataObjectInput());
  if (!grid)
  {
    throw gatun::Error(gatun::ErrorCode::InvalidInput, "the input is not a vtkUnstructuredGrid");
  }
  if (grid->GetNumberOfCells() == 0)
  {
    return false;
  }
  this->Scene.SetGrid(grid, GetArray(mapper), budget, this->Simplifies(mapper));
  return true;
}

//------------------------------------------------------------------------------
float vtkGatunVolumeMapper::vtkInternals::ChooseDistance(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const Viewport& viewport) const
{
  if (!mapper->AutoAdjustSampleDistances)
  {
    return mapper->ImageSampleDistance;
  }
  const float least = mapper->MinimumImageSampleDistance;
  const auto known = this->TimeOfRays.find({ renderer, volume });
  const double allocated = volume->GetAllocatedRenderTime();
  if (known == this->TimeOfRays.end() || !(allocated > 0))
  {
    return least;
  }
  const double all = known->second * viewport.Width * viewport.Height;
  const auto wanted = static_cast<float>(std::sqrt(all / allocated));
  return std::max(least, std::min(wanted, mapper->MaximumImageSampleDistance));
}

//------------------------------------------------------------------------------
/** What the present image needs. */
std::shared_ptr<const gatun::DetailView> vtkGatunVolumeMapper::vtkInternals::MakeDetailView(
  vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  const gatun::RayMode mode = *gatun::RayModeOf(mapper->BlendMode);
  const auto view = gatun::MakeRayView(
    renderer->GetActiveCamera(), gatun::MakeGrid(renderer, Viewport(renderer), 1), matrix, true);
  return gatun::MakeDetailView(this->Policy.Get()->GetPixelError(), view,
    gatun::MakeRayTable(volume->GetProperty(), mode, this->Scene.GetRange(), view.SampleDistance));
}

//------------------------------------------------------------------------------
gatun::FrameRequest vtkGatunVolumeMapper::vtkInternals::GetRequest(
  vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  const Viewport viewport(renderer);
  const gatun::DetailSettings detail(this->Policy.Get());
  gatun::FrameRequest request;
  const double allocated = volume->GetAllocatedRenderTime();
  if (detail.JustInTime && allocated > 0 && allocated < gatun::LeastTimeAtRest)
  {
    request.Budget = detail.TimeBudget > 0 ? detail.TimeBudget : allocated;
  }
  const gatun::PublishedFile* const file = this->FindFile(mapper);
  request.Ratio = detail.Ratio;
  request.Merges = file ? file->Merges : 0;
  if ((request.Budget > 0 && detail.ViewDependent) || detail.PixelError > 0)
  {
    request.View = this->MakeDetailView(mapper, renderer, volume);
  }
  request.Pixels = static_cast<double>(viewport.Width) * viewport.Height;
  const bool adjusts = mapper->AutoAdjustSampleDistances;
  request.LeastDistance =
    adjusts ? mapper->MinimumImageSampleDistance : mapper->ImageSampleDistance;
  request.LargestDistance = adjusts
    ? std::max(mapper->MinimumImageSampleDistance, mapper->MaximumImageSampleDistance)
    : mapper->ImageSampleDistance;
  return request;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::ReportReason(vtkGatunVolumeMapper* mapper)
{
  const std::string& reason = this->Scene.GetReason();
  if (reason != this->Reason)
  {
    this->Reason = reason;
    if (!reason.empty())
    {
      vtkWarningWithObjectMacro(mapper, << reason);
    }
  }
}

//------------------------------------------------------------------------------
/** All but the limits that geometry sets. */
ImageSetup vtkGatunVolumeMapper::vtkInternals::MakeSetup(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const gatun::RayView& view, const gatun::Range& values)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  gatun::RaySettings settings;
  settings.Opaque = static_cast<float>(mapper->OpacityLimit);
  settings.Shading =
    gatun::MakeRayShading(volume->GetProperty(), camera, renderer->GetLights(), matrix);
  return { this->Scene.GetLevels(), renderer, volume, view,
    gatun::MakeRayTable(
      volume->GetProperty(), *gatun::RayModeOf(mapper->BlendMode), values, view.SampleDistance),
    gatun::MakeRayLimits(view, mapper->GetClippingPlanes(), matrix), settings };
}

//------------------------------------------------------------------------------
gatun::RayStatistics vtkGatunVolumeMapper::vtkInternals::Draw(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const Viewport& viewport, const gatun::RayGrid& grid,
  const gatun::RaySource::Progress& progress, const gatun::Frame& frame)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  const auto view = gatun::MakeRayView(camera, grid, matrix, true);
  ImageSetup setup = this->MakeSetup(mapper, renderer, volume, view, this->Scene.GetRange());
  if (mapper->IntermixIntersectingGeometry && renderer->GetNumberOfPropsRendered() > 0)
  {
    vtkNew<vtkFloatArray> depths;
    renderer->GetRenderWindow()->GetZbufferData(viewport.X, viewport.Y,
      viewport.X + viewport.Width - 1, viewport.Y + viewport.Height - 1, depths);
    const std::span<const float> zBuffer(
      depths->GetPointer(0), static_cast<std::size_t>(depths->GetNumberOfValues()));
    gatun::LimitByZBuffer(
      view, camera, grid, zBuffer, viewport.Width, viewport.Height, setup.Limits);
  }
  if (frame.Source && !this->Policy.Get()->GetJustInTime())
  {
    // The user may be looking for the best ratio.
    setup.Settings.Repeatable = true;
    this->DrawAnew(setup, frame.Source, grid, progress);
    return {};
  }
  this->Refresh.reset();
  gatun::RayCaster caster(view, std::move(setup.Table), setup.Limits, setup.Settings);
  this->Scene.Draw(caster, view, progress, frame.Source.get());
  this->Image.Take(caster, grid);
  this->PartDrawn = 1;
  return caster.GetStatistics();
}

//------------------------------------------------------------------------------
/** Draws the tiles that another number of points changes. */
void vtkGatunVolumeMapper::vtkInternals::DrawAnew(const ImageSetup& setup,
  std::shared_ptr<gatun::RaySource> source, const gatun::RayGrid& grid,
  const gatun::RaySource::Progress& progress)
{
  if (!this->Refresh || *this->Setup != setup)
  {
    this->Setup = std::make_shared<const ImageSetup>(setup);
    this->Refresh = std::make_unique<gatun::RayRefresh>(
      [kept = this->Setup]
      {
        return std::make_unique<gatun::RayCaster>(
          kept->View, kept->Table, kept->Limits, kept->Settings);
      });
  }
  this->PartDrawn = this->Image.Take(*this->Refresh, std::move(source), grid, progress);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::RequireNumbers(vtkGatunVolumeMapper* mapper)
{
  gatun::RequireNumber("ImageSampleDistance", mapper->ImageSampleDistance);
  gatun::RequireNumber("MinimumImageSampleDistance", mapper->MinimumImageSampleDistance);
  gatun::RequireNumber("MaximumImageSampleDistance", mapper->MaximumImageSampleDistance);
  gatun::RequireNumber("OpacityLimit", mapper->OpacityLimit);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::DrawFrame(
  vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  if (IsParallel(mapper))
  {
    this->DrawParallel(mapper, renderer, volume);
    return;
  }
  const Viewport viewport(renderer);
  if (viewport.Width <= 0 || viewport.Height <= 0)
  {
    return;
  }
  RequireNumbers(mapper);
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  const auto progress = [mapper, window](double fraction)
  {
    mapper->UpdateProgress(fraction);
    return window->CheckAbortStatus() == 0;
  };
  if (!this->SetScene(mapper, progress))
  {
    return;
  }
  this->ReportReason(mapper);
  // From here on, as the time for the input says nothing of the next image.
  mapper->Timer->StartTimer();
  const auto key = std::make_pair(renderer, volume);
  gatun::LevelOfDetailCache* const levels = this->Scene.GetLevels();
  gatun::JustInTime* const frames = levels ? &this->Frames[key] : nullptr;
  const gatun::FrameRequest request = this->GetRequest(mapper, renderer, volume);
  const gatun::Frame frame = frames ? frames->Begin(*levels, request, progress) : gatun::Frame{};
  const bool inMotion = frames && request.Budget > 0;
  const float distance = inMotion ? static_cast<float>(frame.Distance)
                                  : this->ChooseDistance(mapper, renderer, volume, viewport);
  const gatun::RayGrid grid = gatun::MakeGrid(renderer, viewport, distance);
  const gatun::FrameNotice notice(levels);
  const double before = vtkTimerLog::GetUniversalTime();
  const auto statistics = this->Draw(mapper, renderer, volume, viewport, grid, progress, frame);
  const double cast = vtkTimerLog::GetUniversalTime() - before;
  this->Image.Show(renderer, volume, mapper->IntermixIntersectingGeometry);
  if (inMotion)
  {
    window->WaitForCompletion(); // or the next image would pay for this one
  }
  mapper->Timer->StopTimer();
  const double rays = static_cast<double>(grid.Width) * grid.Height;
  mapper->ImageSampleDistance = distance;
  mapper->TimeToDraw = mapper->Timer->GetElapsedTime();
  this->TimeOfRays[key] = mapper->TimeToDraw / rays;
  this->Points = frame.Points;
  if (frames && this->Policy.Get()->GetJustInTime())
  {
    frames->End(*levels, frame, rays, statistics, { cast, mapper->TimeToDraw });
  }
  mapper->UpdateProgress(1);
}

//------------------------------------------------------------------------------
/** The same for all the damage in a file, as threads meet damaged blocks in any order. */
std::string vtkGatunVolumeMapper::vtkInternals::GetCause(
  vtkGatunVolumeMapper* mapper, const gatun::VTKFailure& failure)
{
  return failure.Code == vtkErrorCode::FileFormatError && GetKind(mapper) == InputKind::File
    ? this->FindFile(mapper)->Path
    : failure.Message;
}
