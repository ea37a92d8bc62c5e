// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunParallelFrame.h"

#include "gatunError.h"
#include "gatunFrameClock.h"
#include "gatunParallelImage.h"
#include "gatunRayScene.h"
#include "gatunRayShare.h"
#include "gatunVolumeImage.h"

#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <span>
#include <utility>

namespace gatun
{
namespace
{
//------------------------------------------------------------------------------
std::span<float> AsSpan(vtkFloatArray* values)
{
  return { values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues()) };
}
}

//------------------------------------------------------------------------------
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
ParallelFrame::ParallelFrame(vtkMultiProcessController* controller)
  : Exchange(controller)
  , Process(this->Exchange.GetProcess())
{
}

ParallelFrame::~ParallelFrame() = default;

//------------------------------------------------------------------------------
bool ParallelFrame::Gather(const MakeFrame& make)
{
  PartFacts own;
  this->Exchange.Together(
    [&]
    {
      this->Frame = make(own);
      const Viewport& viewport = this->Frame->GetViewport();
      own.Width = viewport.Width;
      own.Height = viewport.Height;
      if (!viewport.IsEmpty())
      {
        // A renderer with passes does not know yet what they have drawn.
        this->Frame->ReadDepths(this->Depths);
        const auto all = AsSpan(this->Depths);
        own.HasGeometry =
          std::any_of(all.begin(), all.end(), [](float depth) { return depth < 1; });
      }
    });
  this->Facts = this->Exchange.Gather(own);
  const auto any = [&](auto&& holds)
  { return std::any_of(this->Facts.begin(), this->Facts.end(), holds); };
  if (any([&](const PartFacts& other)
        { return other.Width != own.Width || other.Height != own.Height; }))
  {
    ThrowInvalid("the processes draw images of different sizes");
  }
  return !this->Frame->GetViewport().IsEmpty() &&
    any([](const PartFacts& other) { return other.HasMesh; });
}

//------------------------------------------------------------------------------
bool ParallelFrame::HasOneFile() const
{
  const std::uint64_t first = this->Facts.front().File;
  return first != 0 &&
    std::all_of(this->Facts.begin(), this->Facts.end(),
      [&](const PartFacts& part) { return part.File == first; });
}

//------------------------------------------------------------------------------
const ParallelPlan& ParallelFrame::Agree(const std::function<FramePlan()>& choose, int imageProcess)
{
  this->Exchange.Together(
    [&]
    {
      // In all processes, as a plan to be overwritten.
      const FramePlan plan = choose();
      const DetailRequest& level = plan.Detail.Level;
      const RayGrid grid = this->Frame->MakeGrid(plan.Distance);
      this->Plan = { grid, this->Frame->MakeView(grid), plan.Distance, level.Points,
        level.View ? std::optional(level.View->View) : std::nullopt, plan.Detail.NextPoints,
        plan.IsInMotion, std::min(imageProcess, this->Exchange.GetProcesses() - 1) };
      this->Level = plan.Detail.Source;
    });
  this->Plan = this->Exchange.TakeFirst(*this->Plan);
  return *this->Plan;
}

//------------------------------------------------------------------------------
/** The range of the values of all processes. */
Range ParallelFrame::GetValues() const
{
  Range values;
  for (const PartFacts& part : this->Facts)
  {
    values.Min = part.HasMesh ? std::min(values.Min, part.Low) : values.Min;
    values.Max = part.HasMesh ? std::max(values.Max, part.High) : values.Max;
  }
  return values;
}

//------------------------------------------------------------------------------
/** Takes the level that the first process has chosen, and prepares the next one as it does. */
std::shared_ptr<RaySource> ParallelFrame::FollowPlan(
  LevelOfDetailCache& levels, const Range& values) const
{
  DetailRequest level{ this->Plan->Points, nullptr };
  if (this->Plan->Detail || this->Plan->NextPoints > 0)
  {
    const auto present = this->Frame->MakeDetailView(values);
    if (this->Plan->NextPoints > 0)
    {
      levels.Prepare({ { this->Plan->NextPoints, present } });
    }
    if (this->Plan->Detail)
    {
      DetailView chosen = *present;
      chosen.View = *this->Plan->Detail;
      level.View = std::make_shared<const DetailView>(std::move(chosen));
    }
  }
  return levels.Get(level).Source;
}

//------------------------------------------------------------------------------
/** The share of this process in a mesh that it may have in common with others. */
std::shared_ptr<RaySource> ParallelFrame::Share(std::shared_ptr<RaySource> all) const
{
  const auto self = this->Facts.begin() + this->Process;
  if (!all || self->File == 0)
  {
    return all;
  }
  const auto isSame = [&](const PartFacts& other) { return other.File == self->File; };
  return std::make_shared<RayShare>(std::move(all),
    static_cast<std::size_t>(std::count_if(this->Facts.begin(), self, isSame)),
    static_cast<std::size_t>(std::count_if(this->Facts.begin(), this->Facts.end(), isSame)));
}

//------------------------------------------------------------------------------
RayStatistics ParallelFrame::Draw(RayScene& scene, LevelOfDetailCache* levels,
  const RaySource::Progress& progress, VolumeImage& image)
{
  const PartFacts& own = this->Facts[static_cast<std::size_t>(this->Process)];
  const bool intermixes = this->Frame->GetSettings().Intermixes;
  ParallelImage merged(this->Exchange, own.Width, own.Height, this->Plan->ImageProcess);
  if (std::any_of(this->Facts.begin(), this->Facts.end(),
        [](const PartFacts& part) { return part.HasGeometry; }))
  {
    merged.ShareDepths(own.HasGeometry ? AsSpan(this->Depths) : std::span<float>());
  }
  std::optional<ImageSetup> setup;
  std::unique_ptr<RayCaster> caster;
  const auto before = FrameClock::now();
  const FrameNotice notice(levels);
  this->Exchange.Together(
    [&]
    {
      setup.emplace(this->Frame->MakeSetup(nullptr, this->Plan->View, this->GetValues()));
      if (intermixes && !merged.GetDepths().empty())
      {
        LimitByZBuffer(this->Plan->View, this->Frame->GetRenderer()->GetActiveCamera(),
          this->Plan->Grid, merged.GetDepths(), own.Width, own.Height, setup->Limits);
      }
      if (own.HasMesh)
      {
        if (levels && !this->IsFirst() && this->Plan->Points > 0)
        {
          levels->WaitForLevels(progress);
          this->Level = this->FollowPlan(*levels, scene.GetRange());
        }
        caster =
          std::make_unique<RayCaster>(setup->View, setup->Table, setup->Limits, setup->Settings);
        const auto source = this->Share(this->Level ? this->Level : scene.GetSource());
        scene.Draw(*caster, this->Plan->View, progress, source.get());
      }
    });
  this->CastSeconds = SecondsSince(before);
  merged.Merge(caster.get(), setup->View, setup->Table, this->Plan->Grid);
  for (const std::uint64_t bytes : this->Exchange.Gather(this->Exchange.GetBytesSent()))
  {
    this->BytesSent += bytes;
  }
  if (!intermixes)
  {
    merged.HideBehindGeometry(this->FindCenterDepth());
  }
  this->Show(merged, image);
  RayStatistics statistics = caster ? caster->GetStatistics() : RayStatistics{};
  statistics.Tets *= this->Facts.size(); // about those of all
  return statistics;
}

//------------------------------------------------------------------------------
/** The depth of the middle of the volume. */
float ParallelFrame::FindCenterDepth() const
{
  std::vector<std::array<double, 6>> all;
  for (const PartFacts& part : this->Facts)
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
  this->Frame->GetVolume()->GetMatrix(matrix);
  matrix->MultiplyPoint(center.data(), center.data());
  return GetDepth(this->Frame->GetRenderer(), center.data());
}

//------------------------------------------------------------------------------
/** Shows what this process has to show. */
void ParallelFrame::Show(const ParallelImage& merged, VolumeImage& image)
{
  const Viewport& viewport = this->Frame->GetViewport();
  if (merged.GetImageProcess() < 0)
  {
    // Before the image, as VTK shows images without writing depths, and leaves it like that. So the
    // first volume of a frame does it for all, also where it shows nothing.
    merged.BringForward(AsSpan(this->Depths));
    this->Frame->GetRenderer()->GetRenderWindow()->SetZbufferData(viewport.X, viewport.Y,
      viewport.X + viewport.Width - 1, viewport.Y + viewport.Height - 1, this->Depths);
  }
  image.Take(merged.GetColors(), viewport);
  image.Show(*this->Frame, true);
}
}
