// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunVolumeMapperInternals.h"

#include "gatunError.h"
#include "gatunPublishedFile.h"

#include "vtkFloatArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <span>
#include <utility>

using gatun::InputKind;

//------------------------------------------------------------------------------
bool vtkGatunVolumeMapper::vtkInternals::IsParallel(vtkGatunVolumeMapper* mapper)
{
  return mapper->Controller && mapper->Controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
gatun::MapperConnection vtkGatunVolumeMapper::vtkInternals::GetConnection(
  vtkGatunVolumeMapper* mapper)
{
  gatun::MapperConnection input{ gatun::GetProducer(mapper), { mapper->NumberOfPieces } };
  if (IsParallel(mapper))
  {
    input.Pieces.Process = mapper->Controller->GetLocalProcessId();
    input.Pieces.Processes = mapper->Controller->GetNumberOfProcesses();
  }
  return input;
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
gatun::VolumeSettings vtkGatunVolumeMapper::vtkInternals::GetSettings(
  vtkGatunVolumeMapper* mapper) const
{
  gatun::RequireNumber("ImageSampleDistance", mapper->ImageSampleDistance);
  gatun::RequireNumber("MinimumImageSampleDistance", mapper->MinimumImageSampleDistance);
  gatun::RequireNumber("MaximumImageSampleDistance", mapper->MaximumImageSampleDistance);
  gatun::RequireNumber("OpacityLimit", mapper->OpacityLimit);
  gatun::VolumeSettings settings;
  settings.Mode = *gatun::RayModeOf(mapper->BlendMode);
  settings.OpacityLimit = mapper->OpacityLimit;
  settings.Intermixes = mapper->IntermixIntersectingGeometry;
  settings.ClippingPlanes = mapper->GetClippingPlanes();
  settings.Detail = gatun::DetailSettings(this->Policy.Get());
  settings.AdjustsDistance = mapper->AutoAdjustSampleDistances;
  settings.Distance = mapper->ImageSampleDistance;
  settings.LeastDistance = mapper->MinimumImageSampleDistance;
  settings.LargestDistance = mapper->MaximumImageSampleDistance;
  return settings;
}

//------------------------------------------------------------------------------
std::size_t vtkGatunVolumeMapper::vtkInternals::GetMerges(vtkGatunVolumeMapper* mapper)
{
  const gatun::PublishedFile* const file = this->Input.FindFile(GetConnection(mapper));
  return file ? file->Merges : 0;
}

//------------------------------------------------------------------------------
bool vtkGatunVolumeMapper::vtkInternals::Simplifies(vtkGatunVolumeMapper* mapper)
{
  if (IsParallel(mapper) && !this->Input.FindFile(GetConnection(mapper)))
  {
    return false; // parts that are simplified separately do not fit together
  }
  const gatun::DetailSettings detail(this->Policy.Get());
  return detail.JustInTime || detail.Ratio > 0 || detail.PixelError > 0 ||
    this->GetMerges(mapper) > 0;
}

//------------------------------------------------------------------------------
/** Whether there is something to draw. */
bool vtkGatunVolumeMapper::vtkInternals::SetScene(
  vtkGatunVolumeMapper* mapper, const gatun::RaySource::Progress& progress)
{
  const gatun::MapperConnection input = GetConnection(mapper);
  return this->Input.GetKind(input) != InputKind::None &&
    this->Input.SetScene(
      input, GetArray(mapper), GetBudget(mapper), this->Simplifies(mapper), progress);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::ReportReason(vtkGatunVolumeMapper* mapper)
{
  const std::string reason = this->Input.TakeReason();
  if (!reason.empty())
  {
    vtkWarningWithObjectMacro(mapper, << reason);
  }
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::Draw(
  vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  const auto progress = [mapper, window](double fraction)
  {
    mapper->UpdateProgress(fraction);
    return window->CheckAbortStatus() == 0;
  };
  if (IsParallel(mapper))
  {
    this->DrawTogether(mapper, renderer, volume, progress);
  }
  else
  {
    this->DrawAlone(mapper, renderer, volume, progress);
  }
}

//------------------------------------------------------------------------------
gatun::RayStatistics vtkGatunVolumeMapper::vtkInternals::Cast(const gatun::VolumeFrame& frame,
  const gatun::FramePlan& plan, const gatun::RayGrid& grid,
  const gatun::RaySource::Progress& progress)
{
  gatun::RayScene& scene = this->Input.GetScene();
  vtkRenderer* const renderer = frame.GetRenderer();
  const gatun::RayView view = frame.MakeView(grid);
  gatun::ImageSetup setup = frame.MakeSetup(scene.GetLevels(), view, scene.GetRange());
  if (frame.GetSettings().Intermixes && renderer->GetNumberOfPropsRendered() > 0)
  {
    vtkNew<vtkFloatArray> depths;
    frame.ReadDepths(depths);
    const std::span<const float> zBuffer(
      depths->GetPointer(0), static_cast<std::size_t>(depths->GetNumberOfValues()));
    gatun::LimitByZBuffer(view, renderer->GetActiveCamera(), grid, zBuffer,
      frame.GetViewport().Width, frame.GetViewport().Height, setup.Limits);
  }
  if (plan.Detail.Source && !frame.GetSettings().Detail.JustInTime)
  {
    // The user may be looking for the best ratio.
    this->Image.DrawChanges(plan.Detail.Source, std::move(setup), grid, progress);
    return {};
  }
  return this->Image.Draw(scene, plan.Detail.Source.get(), setup, grid, progress);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::DrawAlone(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const gatun::RaySource::Progress& progress)
{
  if (gatun::Viewport(renderer).IsEmpty())
  {
    return;
  }
  const gatun::VolumeFrame frame(renderer, volume, this->GetSettings(mapper));
  if (!this->SetScene(mapper, progress))
  {
    return;
  }
  this->ReportReason(mapper);
  // From here on, as the time for the input says nothing of the next image.
  mapper->Timer->StartTimer();
  gatun::RayScene& scene = this->Input.GetScene();
  gatun::LevelOfDetailCache* const levels = scene.GetLevels();
  const gatun::FramePlan plan =
    this->Planner.Choose(frame, levels, this->GetMerges(mapper), scene.GetRange(), progress);
  const gatun::RayGrid grid = frame.MakeGrid(plan.Distance);
  const gatun::FrameNotice notice(levels);
  const double before = vtkTimerLog::GetUniversalTime();
  const gatun::RayStatistics statistics = this->Cast(frame, plan, grid, progress);
  const double cast = vtkTimerLog::GetUniversalTime() - before;
  this->Image.Show(frame, mapper->IntermixIntersectingGeometry);
  if (plan.IsInMotion)
  {
    renderer->GetRenderWindow()->WaitForCompletion(); // or the next image would pay for this one
  }
  this->Finish(mapper, plan, plan.Distance);
  const double rays = static_cast<double>(grid.Width) * grid.Height;
  this->Planner.Learn(frame, levels, plan, rays, statistics, { cast, mapper->TimeToDraw });
  mapper->UpdateProgress(1);
}

//------------------------------------------------------------------------------
/** The frame of this process, and the facts of its mesh. */
std::unique_ptr<gatun::VolumeFrame> vtkGatunVolumeMapper::vtkInternals::MakePart(
  vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
  const gatun::RaySource::Progress& progress, gatun::PartFacts& facts)
{
  auto frame = std::make_unique<gatun::VolumeFrame>(renderer, volume, this->GetSettings(mapper));
  facts.HasMesh = this->SetScene(mapper, progress);
  if (facts.HasMesh)
  {
    this->ReportReason(mapper);
    std::copy_n(mapper->GetBounds(), facts.Bounds.size(), facts.Bounds.begin());
    const gatun::Range& values = this->Input.GetScene().GetRange();
    facts.Low = values.Min;
    facts.High = values.Max;
    facts.File = this->Input.Identify(GetConnection(mapper));
  }
  return frame;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::DrawTogether(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const gatun::RaySource::Progress& progress)
{
  this->BytesSent = 0;
  gatun::ParallelFrame together(mapper->Controller);
  const bool isSeen = together.Gather([&](gatun::PartFacts& facts)
    { return this->MakePart(mapper, renderer, volume, progress, facts); });
  if (!isSeen)
  {
    return;
  }
  // From here on, as the time for the input says nothing of the next image.
  mapper->Timer->StartTimer();
  gatun::RayScene& scene = this->Input.GetScene();
  const gatun::VolumeFrame& frame = together.GetFrame();
  gatun::LevelOfDetailCache* const levels =
    together.HasOneFile() && this->Simplifies(mapper) ? scene.GetLevels() : nullptr;
  gatun::LevelOfDetailCache* const chosen = together.IsFirst() ? levels : nullptr;
  gatun::FramePlan plan;
  const gatun::ParallelPlan& agreed = together.Agree(
    [&]
    {
      plan =
        this->Planner.Choose(frame, chosen, this->GetMerges(mapper), scene.GetRange(), progress);
      return plan;
    },
    mapper->ImageProcess);
  const gatun::RayStatistics statistics = together.Draw(scene, levels, progress, this->Image);
  this->BytesSent = together.GetBytesSent();
  if (agreed.IsInMotion)
  {
    renderer->GetRenderWindow()->WaitForCompletion(); // or the next image would pay for this one
  }
  this->Finish(mapper, plan, agreed.Distance);
  const double rays = static_cast<double>(agreed.Grid.Width) * agreed.Grid.Height;
  this->Planner.Learn(
    frame, chosen, plan, rays, statistics, { together.GetCastSeconds(), mapper->TimeToDraw });
  mapper->UpdateProgress(1);
}

//------------------------------------------------------------------------------
/** The image is shown. Distance: of its rays. */
void vtkGatunVolumeMapper::vtkInternals::Finish(
  vtkGatunVolumeMapper* mapper, const gatun::FramePlan& plan, float distance)
{
  mapper->Timer->StopTimer();
  mapper->TimeToDraw = mapper->Timer->GetElapsedTime();
  mapper->ImageSampleDistance = distance;
  this->Points = plan.Detail.Points;
}
