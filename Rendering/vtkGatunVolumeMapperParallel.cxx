// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The images of several processes.

#include "vtkGatunVolumeMapperInternals.h"

#include "gatunError.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunParallelImage.h"
#include "gatunProcessExchange.h"
#include "gatunRayShare.h"

#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

using gatun::Frame;
using gatun::ImageSetup;
using gatun::ParallelPlan;
using gatun::PartFacts;
using gatun::Viewport;

namespace
{

//------------------------------------------------------------------------------
/** A number for a file, one of its arrays and a step: different ones have different numbers. */
std::uint64_t Identify(const gatun::FileReader& file, const gatun::Range& values, std::size_t step)
{
  std::uint64_t number = 0xcbf29ce484222325;
  const auto add = [&](std::uint64_t value)
  { number = (number ^ value) * 0x9e3779b97f4a7c15 ^ number >> 29; };
  add(file.GetNumberOfPoints());
  add(file.GetNumberOfTets());
  add(file.GetChunks().size());
  add(step);
  add(std::bit_cast<std::uint64_t>(values.Min));
  add(std::bit_cast<std::uint64_t>(values.Max));
  constexpr std::size_t enough = 1000;
  for (std::size_t chunk = 0; chunk < std::min(enough, file.GetChunks().size()); ++chunk)
  {
    for (const gatun::Range& side : file.GetChunkBounds(chunk, 0, step))
    {
      add(std::bit_cast<std::uint64_t>(side.Min));
      add(std::bit_cast<std::uint64_t>(side.Max));
    }
  }
  return std::max<std::uint64_t>(number, 1);
}

//------------------------------------------------------------------------------
/** The range of the values of all processes. */
gatun::Range JoinRanges(const std::vector<PartFacts>& facts)
{
  gatun::Range values;
  for (const PartFacts& part : facts)
  {
    values.Min = part.HasMesh ? std::min(values.Min, part.Low) : values.Min;
    values.Max = part.HasMesh ? std::max(values.Max, part.High) : values.Max;
  }
  return values;
}

//------------------------------------------------------------------------------
/** The share of a process in a mesh that it may have in common with others. */
std::shared_ptr<gatun::RaySource> Share(
  std::shared_ptr<gatun::RaySource> all, const std::vector<PartFacts>& facts, int process)
{
  const auto self = facts.begin() + process;
  if (!all || self->File == 0)
  {
    return all;
  }
  const auto isSame = [&](const PartFacts& other) { return other.File == self->File; };
  return std::make_shared<gatun::RayShare>(std::move(all),
    static_cast<std::size_t>(std::count_if(facts.begin(), self, isSame)),
    static_cast<std::size_t>(std::count_if(facts.begin(), facts.end(), isSame)));
}

//------------------------------------------------------------------------------
/** The depths in a part of a window. */
void ReadDepths(vtkRenderer* renderer, const Viewport& viewport, vtkFloatArray* depths)
{
  renderer->GetRenderWindow()->GetZbufferData(viewport.X, viewport.Y,
    viewport.X + viewport.Width - 1, viewport.Y + viewport.Height - 1, depths);
}

//------------------------------------------------------------------------------
std::span<float> AsSpan(vtkFloatArray* values)
{
  return { values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues()) };
}

//------------------------------------------------------------------------------
/** The bounds of all parts that have any. */
std::array<double, 6> JoinBounds(const std::vector<std::array<double, 6>>& all)
{
  std::array<double, 6> whole{ 1, -1, 1, -1, 1, -1 };
  for (const auto& bounds : all)
  {
    if (!(bounds[0] <= bounds[1]))
    {
      continue;
    }
    const bool isFirst = !(whole[0] <= whole[1]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      double& low = whole[2 * axis];
      double& high = whole[2 * axis + 1];
      low = isFirst ? bounds[2 * axis] : std::min(low, bounds[2 * axis]);
      high = isFirst ? bounds[2 * axis + 1] : std::max(high, bounds[2 * axis + 1]);
    }
  }
  return whole;
}

//------------------------------------------------------------------------------
/** The depth of the middle of a volume. */
float FindCenterDepth(vtkRenderer* renderer, vtkVolume* volume, const std::vector<PartFacts>& facts)
{
  std::vector<std::array<double, 6>> all;
  for (const PartFacts& part : facts)
  {
    if (part.HasMesh)
    {
      all.push_back(part.Bounds);
    }
  }
  const auto bounds = JoinBounds(all);
  std::array<double, 4> center{ (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
    (bounds[4] + bounds[5]) / 2, 1 };
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  matrix->MultiplyPoint(center.data(), center.data());
  return gatun::GetDepth(renderer, center.data());
}

} // anonymous namespace

//------------------------------------------------------------------------------
bool vtkGatunVolumeMapper::vtkInternals::IsParallel(vtkGatunVolumeMapper* mapper)
{
  return mapper->Controller && mapper->Controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
gatun::PieceShare vtkGatunVolumeMapper::vtkInternals::GetPieces(vtkGatunVolumeMapper* mapper)
{
  return IsParallel(mapper) ? gatun::PieceShare{ mapper->NumberOfPieces,
    mapper->Controller->GetLocalProcessId(), mapper->Controller->GetNumberOfProcesses() }
                            : gatun::PieceShare{ mapper->NumberOfPieces };
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::ReduceBounds(
  vtkGatunVolumeMapper* mapper, const std::array<double, 6>& own)
{
  gatun::ProcessExchange exchange(mapper->Controller);
  this->WholeBounds = JoinBounds(exchange.Gather(own));
}

//------------------------------------------------------------------------------
PartFacts vtkGatunVolumeMapper::vtkInternals::GetFacts(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkFloatArray* depths, const gatun::RaySource::Progress& progress)
{
  RequireNumbers(mapper);
  const Viewport viewport(renderer);
  PartFacts facts;
  facts.Width = viewport.Width;
  facts.Height = viewport.Height;
  if (viewport.Width > 0 && viewport.Height > 0)
  {
    // A renderer with passes does not know yet what they have drawn.
    ReadDepths(renderer, viewport, depths);
    const auto all = AsSpan(depths);
    facts.HasGeometry = std::any_of(all.begin(), all.end(), [](float depth) { return depth < 1; });
  }
  facts.HasMesh = this->SetScene(mapper, progress);
  if (facts.HasMesh)
  {
    this->ReportReason(mapper);
    std::copy_n(mapper->GetBounds(), facts.Bounds.size(), facts.Bounds.begin());
    const gatun::Range values = this->Scene.GetRange();
    facts.Low = values.Min;
    facts.High = values.Max;
    if (const gatun::PublishedFile* const handle = this->FindFile(mapper))
    {
      const gatun::FileReader& file = *handle->File->GetFile();
      const gatun::RayProducer producer = gatun::GetProducer(mapper);
      facts.File = Identify(file, values,
        gatun::GetRequestedStep(file, producer.Algorithm->GetOutputInformation(producer.Port)));
    }
  }
  return facts;
}

//------------------------------------------------------------------------------
/** The facts of all processes. Depths: get those of what this one has drawn before. */
std::vector<PartFacts> vtkGatunVolumeMapper::vtkInternals::GatherFacts(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkFloatArray* depths, gatun::ProcessExchange& exchange,
  const gatun::RaySource::Progress& progress)
{
  PartFacts own;
  exchange.Together([&] { own = this->GetFacts(mapper, renderer, depths, progress); });
  auto facts = exchange.Gather(own);
  if (std::any_of(facts.begin(), facts.end(),
        [&](const PartFacts& other)
        { return other.Width != own.Width || other.Height != own.Height; }))
  {
    throw gatun::Error(
      gatun::ErrorCode::InvalidInput, "the processes draw images of different sizes");
  }
  return facts;
}

//------------------------------------------------------------------------------
/** Chooses the rays and, if all processes can simplify the mesh, its points. */
ParallelPlan vtkGatunVolumeMapper::vtkInternals::MakePlan(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, bool simplifies, Frame& frame,
  const gatun::RaySource::Progress& progress)
{
  const Viewport viewport(renderer);
  gatun::LevelOfDetailCache* const levels = simplifies ? this->Scene.GetLevels() : nullptr;
  const gatun::FrameRequest request = this->GetRequest(mapper, renderer, volume);
  float distance = 0;
  std::optional<gatun::RayView> detail;
  if (levels)
  {
    frame = this->Frames[{ renderer, volume }].Begin(*levels, request, progress);
    if (frame.Level.View)
    {
      detail = frame.Level.View->View;
    }
  }
  const bool isInMotion = levels && request.Budget > 0;
  distance = isInMotion ? static_cast<float>(frame.Distance)
                        : this->ChooseDistance(mapper, renderer, volume, viewport);
  const gatun::RayGrid grid = gatun::MakeGrid(renderer, viewport, distance);
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  return { grid, gatun::MakeRayView(renderer->GetActiveCamera(), grid, matrix, true), distance,
    frame.Level.Points, detail, frame.NextPoints, isInMotion,
    std::min(mapper->ImageProcess, mapper->Controller->GetNumberOfProcesses() - 1) };
}

//------------------------------------------------------------------------------
/** Takes the level that the first process has chosen, and prepares the next one as it does. */
std::shared_ptr<gatun::RaySource> vtkGatunVolumeMapper::vtkInternals::FollowPlan(
  vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, const ParallelPlan& plan)
{
  gatun::LevelOfDetailCache& levels = *this->Scene.GetLevels();
  gatun::DetailRequest level{ plan.Points, nullptr };
  if (plan.Detail || plan.NextPoints > 0)
  {
    const auto present = this->MakeDetailView(mapper, renderer, volume);
    if (plan.NextPoints > 0)
    {
      levels.Prepare({ { plan.NextPoints, present } });
    }
    if (plan.Detail)
    {
      gatun::DetailView chosen = *present;
      chosen.View = *plan.Detail;
      level.View = std::make_shared<const gatun::DetailView>(std::move(chosen));
    }
  }
  return levels.Get(level).Source;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::DrawParallel(
  vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  gatun::ProcessExchange exchange(mapper->Controller);
  const bool isFirst = exchange.GetProcess() == 0;
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  const auto progress = [mapper, window](double fraction)
  {
    mapper->UpdateProgress(fraction);
    return window->CheckAbortStatus() == 0;
  };
  this->BytesSent = 0;
  this->Refresh.reset();
  this->PartDrawn = 1;
  vtkNew<vtkFloatArray> depths; // of what was drawn before
  const auto facts = this->GatherFacts(mapper, renderer, depths, exchange, progress);
  const PartFacts& own = facts[static_cast<std::size_t>(exchange.GetProcess())];
  const auto any = [&](auto&& holds) { return std::any_of(facts.begin(), facts.end(), holds); };
  if (own.Width <= 0 || own.Height <= 0 ||
    !any([](const PartFacts& other) { return other.HasMesh; }))
  {
    return;
  }

  // From here on, as the time for the input says nothing of the next image.
  mapper->Timer->StartTimer();
  const bool simplifies = own.File != 0 && this->Simplifies(mapper) &&
    !any([&](const PartFacts& other) { return other.File != own.File; });
  gatun::LevelOfDetailCache* const levels = simplifies ? this->Scene.GetLevels() : nullptr;
  Frame frame;
  std::optional<ParallelPlan> made; // of all processes, as a plan to be overwritten
  exchange.Together(
    [&] { made = this->MakePlan(mapper, renderer, volume, levels && isFirst, frame, progress); });
  const ParallelPlan plan = exchange.TakeFirst(*made);
  gatun::ParallelImage image(exchange, own.Width, own.Height, plan.ImageProcess);
  if (any([](const PartFacts& other) { return other.HasGeometry; }))
  {
    image.ShareDepths(own.HasGeometry ? AsSpan(depths) : std::span<float>());
  }

  std::optional<ImageSetup> setup;
  std::unique_ptr<gatun::RayCaster> caster;
  const double before = vtkTimerLog::GetUniversalTime();
  const gatun::FrameNotice notice(levels);
  exchange.Together(
    [&]
    {
      setup.emplace(this->MakeSetup(mapper, renderer, volume, plan.View, JoinRanges(facts)));
      if (mapper->IntermixIntersectingGeometry && !image.GetDepths().empty())
      {
        gatun::LimitByZBuffer(plan.View, renderer->GetActiveCamera(), plan.Grid, image.GetDepths(),
          own.Width, own.Height, setup->Limits);
      }
      if (own.HasMesh)
      {
        if (levels && !isFirst && plan.Points > 0)
        {
          levels->WaitForLevels(progress);
          frame.Source = this->FollowPlan(mapper, renderer, volume, plan);
        }
        caster = std::make_unique<gatun::RayCaster>(
          setup->View, setup->Table, setup->Limits, setup->Settings);
        const auto all = frame.Source ? frame.Source : this->Scene.GetSource();
        const auto source = Share(all, facts, exchange.GetProcess());
        this->Scene.Draw(*caster, plan.View, progress, source.get());
      }
    });
  const double cast = vtkTimerLog::GetUniversalTime() - before;
  image.Merge(caster.get(), setup->View, setup->Table, plan.Grid);
  for (const std::uint64_t bytes : exchange.Gather(exchange.GetBytesSent()))
  {
    this->BytesSent += bytes;
  }
  if (!mapper->IntermixIntersectingGeometry)
  {
    image.HideBehindGeometry(FindCenterDepth(renderer, volume, facts));
  }
  this->ShowParallel(renderer, volume, image, depths);
  if (plan.IsInMotion)
  {
    window->WaitForCompletion(); // or the next image would pay for this one
  }
  mapper->Timer->StopTimer();
  mapper->TimeToDraw = mapper->Timer->GetElapsedTime();
  const double rays = static_cast<double>(plan.Grid.Width) * plan.Grid.Height;
  if (levels && isFirst && this->Policy.Get()->GetJustInTime())
  {
    auto statistics = caster->GetStatistics();
    statistics.Tets *= facts.size(); // about those of all
    this->Frames[{ renderer, volume }].End(
      *levels, frame, rays, statistics, { cast, mapper->TimeToDraw });
  }
  this->TimeOfRays[{ renderer, volume }] = mapper->TimeToDraw / rays;
  mapper->ImageSampleDistance = plan.Distance;
  this->Points = frame.Points;
  mapper->UpdateProgress(1);
}

//------------------------------------------------------------------------------
/** Shows what this process has to show. Depths: of what was drawn before; get changed. */
void vtkGatunVolumeMapper::vtkInternals::ShowParallel(vtkRenderer* renderer, vtkVolume* volume,
  const gatun::ParallelImage& image, vtkFloatArray* depths)
{
  const Viewport viewport(renderer);
  if (image.GetImageProcess() < 0)
  {
    // Before the image, as VTK shows images without writing depths, and leaves it like that. So the
    // first volume of a frame does it for all, also where it shows nothing.
    image.BringForward(AsSpan(depths));
    renderer->GetRenderWindow()->SetZbufferData(viewport.X, viewport.Y,
      viewport.X + viewport.Width - 1, viewport.Y + viewport.Height - 1, depths);
  }
  this->Image.Take(image.GetColors(), viewport.Width, viewport.Height);
  this->Image.Show(renderer, volume, true);
}
