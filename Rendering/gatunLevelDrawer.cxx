// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunLevelDrawer.h"

#include "gatunFileReader.h"
#include "gatunFrameClock.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace gatun
{
namespace
{
// Points of the coarsest level, which is decoded while somebody waits.
constexpr std::uint64_t FewestLevelPoints = 10000;

// Cells of a level that is prepared beyond what is visible.
constexpr std::uint64_t MostCells = 2000000;

// Part of the budget that transfers may use up.
constexpr double TransferAim = 0.9;

//------------------------------------------------------------------------------
/** The visible cells of each level. */
std::vector<std::uint64_t> CountCells(const std::vector<VisibleChunks>& views)
{
  std::vector<std::uint64_t> cells;
  for (const VisibleChunks& view : views)
  {
    cells.push_back(view.Cells);
  }
  return cells;
}
}

//------------------------------------------------------------------------------
void LevelDrawer::Clear()
{
  for (ChunkedSurface* const level : this->Levels)
  {
    this->Chunks.Buffers.Remove(level);
  }
  this->Levels.clear();
  this->HasLevels = false;
  this->Surface = {};
}

//------------------------------------------------------------------------------
void LevelDrawer::SetSurface(const DrawnSurface& surface)
{
  const auto changes =
    this->Levels.empty() ? std::nullopt : surface.Mesh->FindChanges(*this->Surface.Mesh);
  ChunkedSurface* const whole = this->Chunks.Buffers.Add(surface.Mesh);
  this->Levels.resize(std::max<std::size_t>(this->Levels.size(), 1));
  this->Chunks.Buffers.Replace(std::exchange(this->Levels.front(), whole), *whole, changes);
  this->Surface = surface;
  this->HasLevels = false;
}

//------------------------------------------------------------------------------
/** The base meshes of the file that are coarser than the surface, and halves beyond. */
void LevelDrawer::FindLevels()
{
  if (this->HasLevels)
  {
    return;
  }
  const FileReader& file = *this->Surface.Source.File->GetFile();
  const std::size_t drawn = this->GetWhole().Mesh->GetMerges();
  std::vector<std::size_t> wanted;
  if (file.HasMergeTree())
  {
    std::copy_if(file.GetLevels().begin(), file.GetLevels().end(), std::back_inserter(wanted),
      [drawn](std::uint32_t merges) { return merges > drawn; });
    const std::uint64_t all = file.GetNumberOfPoints();
    for (std::uint64_t points = (all - (wanted.empty() ? drawn : wanted.back())) / 2;
         points >= FewestLevelPoints / 2 && all - points <= file.GetNumberOfMerges(); points /= 2)
    {
      wanted.push_back(static_cast<std::size_t>(all - points));
    }
  }
  // Base meshes have no original order.
  PublishedFile source = this->Surface.Source;
  source.RestoreOrder = false;
  std::vector<ChunkedSurface*> before(this->Levels.begin() + 1, this->Levels.end());
  this->Levels.resize(1);
  for (const std::size_t merges : wanted)
  {
    const auto same = std::find_if(before.begin(), before.end(),
      [merges](const ChunkedSurface* level) { return level->Mesh->GetMerges() == merges; });
    if (same != before.end())
    {
      this->Levels.push_back(*same);
      before.erase(same);
    }
    else
    {
      this->Levels.push_back(this->Chunks.Buffers.Add(
        std::make_shared<const SurfaceLevel>(source, merges, this->Surface.What)));
    }
  }
  for (ChunkedSurface* const level : before)
  {
    this->Chunks.Buffers.Remove(level);
  }
  this->HasLevels = true;
}

//------------------------------------------------------------------------------
/** The visible chunks of a level, and those that may come into the view. */
std::vector<std::uint32_t> LevelDrawer::ListLikely(
  const ChunkedSurface& level, const VisibleChunks& view) const
{
  std::vector<std::uint32_t> chunks = view.Chunks;
  std::uint64_t cells = 0;
  for (std::size_t i = 0; i < level.Chunks.size(); ++i)
  {
    cells += level.Mesh->GetNumberOfCells(i);
  }
  for (std::uint32_t i = 0; i < level.Chunks.size() && cells <= MostCells; ++i)
  {
    if (std::find(view.Chunks.begin(), view.Chunks.end(), i) == view.Chunks.end() &&
      !level.Chunks[i].Cone.Known)
    {
      chunks.push_back(i);
    }
  }
  return chunks;
}

//------------------------------------------------------------------------------
/** The visible chunks of each level. */
std::vector<VisibleChunks> LevelDrawer::FindAllVisible(const SurfaceImage& image) const
{
  std::vector<VisibleChunks> views;
  for (const ChunkedSurface* const level : this->Levels)
  {
    views.push_back(this->Chunks.FindVisible(image, *level));
  }
  return views;
}

//------------------------------------------------------------------------------
/** The finest level that can be drawn at once, from one on; the coarsest if there is none. */
std::size_t LevelDrawer::FindReady(
  const SurfaceImage& image, const std::vector<VisibleChunks>& views, std::size_t from) const
{
  while (from + 1 < this->Levels.size() &&
    !this->Chunks.IsReady(image, *this->Levels[from], views[from]))
  {
    ++from;
  }
  return from;
}

//------------------------------------------------------------------------------
void LevelDrawer::DrawLevel(const SurfaceImage& image, std::size_t level, const VisibleChunks& view)
{
  this->Present = level;
  this->Chunks.DrawTimed(image, *this->Levels[level], view, level);
}

//------------------------------------------------------------------------------
bool LevelDrawer::DrawWhole(const SurfaceImage& image)
{
  const auto begin = FrameClock::now();
  const std::uint64_t decodedBefore = this->Chunks.GetCounts().Decoded;
  const VisibleChunks view = this->Chunks.FindVisible(image, this->GetWhole());
  this->Present = 0;
  this->Chunks.Draw(image, this->GetWhole(), view);
  vtkRenderWindow* const window = image.Renderer->GetRenderWindow();
  if (!image.Detail.JustInTime || image.IsSelection || window->GetAbortRender())
  {
    return false;
  }
  window->WaitForCompletion();
  if (this->Chunks.GetCounts().Decoded == decodedBefore)
  {
    this->Chunks.Times.Learn(0, view.Cells, SecondsSince(begin));
  }
  return true;
}

//------------------------------------------------------------------------------
bool LevelDrawer::PrepareMotion(const SurfaceImage& image)
{
  this->FindLevels();
  if (this->Levels.size() < 2)
  {
    return false;
  }
  const std::vector<VisibleChunks> views = this->FindAllVisible(image);
  this->Chunks.Complete(image, *this->Levels.back(), views.back());
  this->Chunks.Transfer(image, *this->Levels.back(), views.back(), this->MotionBudget);
  const std::size_t wanted =
    this->Chunks.Times.Choose(this->MotionBudget, CountCells(views), this->Levels.size());
  if (wanted == 0)
  {
    return false;
  }
  ChunkedSurface& level = *this->Levels[wanted];
  this->Chunks.Prepare(image, level, this->ListLikely(level, views[wanted]));
  return true;
}

//------------------------------------------------------------------------------
LevelDrawer::Plan LevelDrawer::MakePlan(const SurfaceImage& image, double budget)
{
  this->MotionBudget = budget;
  this->FindLevels();
  Plan plan;
  plan.Views = this->FindAllVisible(image);
  plan.Wanted = this->Chunks.Times.Choose(budget, CountCells(plan.Views), this->Present);
  plan.Shown = this->FindReady(image, plan.Views, plan.Wanted);
  plan.Seconds = this->Chunks.Times.Predict(plan.Shown, plan.Views[plan.Shown].Cells);
  return plan;
}

//------------------------------------------------------------------------------
/** Makes the level that is wanted ready, as far as there is time beside the one that is shown with
 * so many cells. */
void LevelDrawer::Advance(const SurfaceImage& image, std::size_t wanted, const VisibleChunks& view,
  std::size_t shown, std::uint64_t cells)
{
  ChunkedSurface& level = *this->Levels[wanted];
  this->Chunks.Prepare(image, level, this->ListLikely(level, view));
  const double seconds = this->Chunks.Times.Predict(shown, cells);
  this->Chunks.Transfer(image, level, view, TransferAim * this->MotionBudget - seconds);
}

//------------------------------------------------------------------------------
void LevelDrawer::DrawInMotion(const SurfaceImage& image, const Plan& plan, bool advances)
{
  std::size_t shown = plan.Shown;
  if (shown != plan.Wanted && advances)
  {
    this->Advance(image, plan.Wanted, plan.Views[plan.Wanted], shown, plan.Views[shown].Cells);
    shown = this->FindReady(image, plan.Views, plan.Wanted);
  }
  this->DrawLevel(image, shown, plan.Views[shown]);
}

//------------------------------------------------------------------------------
LevelChoice LevelDrawer::Propose(const SurfaceImage& image, double budget)
{
  const Plan plan = this->MakePlan(image, budget);
  return { static_cast<int>(plan.Wanted), static_cast<int>(plan.Shown) };
}

//------------------------------------------------------------------------------
void LevelDrawer::DrawShared(const SurfaceImage& image, const LevelChoice& choice)
{
  this->FindLevels();
  const auto last = this->Levels.size() - 1;
  const auto shown = std::min(last, static_cast<std::size_t>(choice.Shown));
  const auto wanted = std::min(last, static_cast<std::size_t>(std::max(0, choice.Wanted)));
  const VisibleChunks view = this->Chunks.FindVisible(image, *this->Levels[shown]);
  if (wanted != shown)
  {
    const VisibleChunks next = this->Chunks.FindVisible(image, *this->Levels[wanted]);
    this->Advance(image, wanted, next, shown, view.Cells);
  }
  this->DrawLevel(image, shown, view);
}
}
