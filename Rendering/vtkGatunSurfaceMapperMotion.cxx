// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Levels of detail of vtkGatunSurfaceMapper while somebody interacts.

#include "vtkGatunSurfaceMapperInternals.h"

#include "gatunFileReader.h"
#include "gatunFrameClock.h"

#include "vtkActor.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
// Points of the coarsest level, which is decoded while somebody waits.
constexpr std::uint64_t FewestLevelPoints = 10000;

// Cells of a level that is prepared beyond what is visible.
constexpr std::uint64_t MostCells = 2000000;

// Images after which a chunk is transferred even if it takes too long.
constexpr int MostWaiting = 10;

/** The visible cells of each level. */
template <typename Views>
std::vector<std::uint64_t> CountCells(const Views& views)
{
  std::vector<std::uint64_t> cells;
  for (const auto& view : views)
  {
    cells.push_back(view.Cells);
  }
  return cells;
}
}

//------------------------------------------------------------------------------
/** Seconds for an image in motion; 0 at rest. */
double vtkGatunSurfaceMapper::vtkInternals::GetBudget(const Image& image)
{
  // An actor within another one, as in ParaView, is allocated nothing.
  const double allocated =
    std::min(image.Actor->GetAllocatedRenderTime(), image.Renderer->GetAllocatedRenderTime());
  if (!image.Detail.JustInTime || !(allocated > 0 && allocated < gatun::LeastTimeAtRest))
  {
    return 0;
  }
  return image.Detail.TimeBudget > 0 ? image.Detail.TimeBudget : allocated;
}

//------------------------------------------------------------------------------
/** The base meshes of the file that are coarser than the surface, and halves beyond. */
void vtkGatunSurfaceMapper::vtkInternals::FindLevels()
{
  if (this->HasLevels)
  {
    return;
  }
  const gatun::FileReader& file = *this->Source.File->GetFile();
  const std::size_t drawn = this->Levels.front().Mesh->GetMerges();
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
  gatun::PublishedFile source = this->Source;
  source.RestoreOrder = false;
  std::vector<Level> levels;
  levels.push_back(std::move(this->Levels.front()));
  for (const std::size_t merges : wanted)
  {
    const auto same = std::find_if(this->Levels.begin() + 1, this->Levels.end(),
      [merges](const Level& level) { return level.Mesh && level.Mesh->GetMerges() == merges; });
    if (same != this->Levels.end())
    {
      levels.push_back(std::move(*same));
      same->Mesh = nullptr;
      same->Chunks.clear();
      continue;
    }
    Level& level = levels.emplace_back();
    level.Mesh = std::make_shared<const gatun::SurfaceLevel>(source, merges, this->What);
    level.Chunks.resize(level.Mesh->GetNumberOfChunks());
  }
  for (std::size_t i = 1; i < this->Levels.size(); ++i)
  {
    for (Chunk& chunk : this->Levels[i].Chunks)
    {
      this->Drop(chunk);
    }
  }
  this->Levels = std::move(levels);
  this->HasLevels = true;
}

//------------------------------------------------------------------------------
/** Whether a level can be drawn at once. */
bool vtkGatunSurfaceMapper::vtkInternals::IsReady(
  const Image& image, const Level& level, const View& view) const
{
  return std::all_of(view.Chunks.begin(), view.Chunks.end(),
    [&](std::uint32_t chunk)
    {
      const Chunk& self = level.Chunks[chunk];
      return self.Mapper && self.IsTransferred &&
        !self.Mapper->NeedsMesh(image.Renderer, image.Actor);
    });
}

//------------------------------------------------------------------------------
/** The visible chunks of a level, and those that may come into the view. */
std::vector<std::uint32_t> vtkGatunSurfaceMapper::vtkInternals::ListLikely(
  const Level& level, const View& view) const
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
/** Takes what is ready of a level, and has the rest decoded. */
void vtkGatunSurfaceMapper::vtkInternals::Prepare(
  const Image& image, Level& level, const std::vector<std::uint32_t>& chunks)
{
  std::vector<std::uint32_t> missing;
  for (const std::uint32_t chunk : chunks)
  {
    const auto& mapper = level.Chunks[chunk].Mapper;
    if (mapper && !mapper->NeedsMesh(image.Renderer, image.Actor))
    {
      continue;
    }
    const auto part = this->Preparer.Take(level.Mesh.get(), chunk);
    if (!part)
    {
      missing.push_back(chunk);
    }
    else if (part->Failure)
    {
      this->Failure = this->Failure ? this->Failure : part->Failure;
    }
    else
    {
      ++this->Decoded;
      this->Adopt(image, level, chunk, *part);
      this->Keep(image, level.Chunks[chunk]);
    }
  }
  this->Preparer.Prepare(level.Mesh, std::move(missing));
}

//------------------------------------------------------------------------------
/** Makes buffers of a level, as far as there is time. Returns the seconds that it took. */
double vtkGatunSurfaceMapper::vtkInternals::Transfer(
  const Image& image, Level& level, const View& view, double seconds)
{
  const auto begin = gatun::FrameClock::now();
  ++this->Waiting;
  for (const std::uint32_t chunk : view.Chunks)
  {
    Chunk& self = level.Chunks[chunk];
    if (!self.Mapper || self.IsTransferred || self.Mapper->NeedsMesh(image.Renderer, image.Actor))
    {
      continue;
    }
    const std::uint64_t cells = level.Mesh->GetNumberOfCells(chunk);
    const double left = seconds - gatun::SecondsSince(begin);
    if (this->Times.PredictTransfer(cells) > left && this->Waiting <= MostWaiting)
    {
      break;
    }
    const auto start = gatun::FrameClock::now();
    self.Mapper->Transfer(image.Renderer, image.Actor);
    self.IsTransferred = true;
    self.Frame = this->Frame;
    this->Keep(image, self);
    this->Times.LearnTransfer(cells, gatun::SecondsSince(start));
    this->Waiting = 0;
  }
  return gatun::SecondsSince(begin);
}

//------------------------------------------------------------------------------
/** What is visible of each level. */
std::vector<vtkGatunSurfaceMapper::vtkInternals::View>
vtkGatunSurfaceMapper::vtkInternals::FindAllVisible(const Image& image)
{
  std::vector<View> views;
  for (Level& level : this->Levels)
  {
    views.push_back(this->FindVisible(image, level));
  }
  return views;
}

//------------------------------------------------------------------------------
/** The finest level that can be drawn at once, from one on; the coarsest if there is none. */
std::size_t vtkGatunSurfaceMapper::vtkInternals::FindReady(
  const Image& image, const std::vector<View>& views, std::size_t from) const
{
  while (from + 1 < this->Levels.size() && !this->IsReady(image, this->Levels[from], views[from]))
  {
    ++from;
  }
  return from;
}

//------------------------------------------------------------------------------
/** Draws a level, and learns how long that takes. */
void vtkGatunSurfaceMapper::vtkInternals::DrawTimed(
  const Image& image, std::size_t shown, const View& view)
{
  const auto begin = gatun::FrameClock::now();
  const std::uint64_t decodedBefore = this->Decoded;
  this->Present = shown;
  this->DrawLevel(image, this->Levels[shown], view);
  image.Renderer->GetRenderWindow()->WaitForCompletion();
  if (this->Decoded == decodedBefore)
  {
    this->Times.Learn(shown, view.Cells, gatun::SecondsSince(begin));
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::DrawInMotion(const Image& image, double budget)
{
  this->MotionBudget = budget;
  this->FindLevels();
  const std::vector<View> views = this->FindAllVisible(image);
  const std::size_t wanted = this->Times.Choose(budget, CountCells(views), this->Present);
  std::size_t shown = this->FindReady(image, views, wanted);
  const double otherwise = this->Times.Predict(shown, views[shown].Cells);
  if (wanted > 0 && this->HasCuts(image) &&
    this->DrawCut(image, budget, otherwise, shown == wanted))
  {
    return;
  }
  if (shown != wanted && !this->Next.Cut)
  {
    Level& level = this->Levels[wanted];
    this->Prepare(image, level, this->ListLikely(level, views[wanted]));
    const double left = 0.9 * budget - this->Times.Predict(shown, views[shown].Cells);
    this->Transfer(image, level, views[wanted], left);
    shown = this->FindReady(image, views, wanted);
  }
  this->DrawTimed(image, shown, views[shown]);
}

//------------------------------------------------------------------------------
vtkGatunSurfaceMapper::vtkInternals::LevelChoice vtkGatunSurfaceMapper::vtkInternals::Propose(
  vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor)
{
  // VTK allocates the time later, and all of a window's to the renderers of an image.
  const double rate = renderer->GetRenderWindow()->GetDesiredUpdateRate();
  const Image image = this->MakeImage(mapper, renderer, actor);
  if (!image.Detail.JustInTime || !(rate > 1 / gatun::LeastTimeAtRest))
  {
    return {};
  }
  this->MotionBudget = image.Detail.TimeBudget > 0 ? image.Detail.TimeBudget : 1 / rate;
  this->FindLevels();
  const std::vector<View> views = this->FindAllVisible(image);
  const std::size_t wanted =
    this->Times.Choose(this->MotionBudget, CountCells(views), this->Present);
  return { static_cast<int>(wanted), static_cast<int>(this->FindReady(image, views, wanted)) };
}

//------------------------------------------------------------------------------
/** Draws the level that all processes draw, and makes ready the one that they want. */
void vtkGatunSurfaceMapper::vtkInternals::DrawShared(const Image& image)
{
  this->FindLevels();
  const auto last = this->Levels.size() - 1;
  const auto shown = std::min(last, static_cast<std::size_t>(this->Shared->Shown));
  const auto wanted = std::min(last, static_cast<std::size_t>(std::max(0, this->Shared->Wanted)));
  const View view = this->FindVisible(image, this->Levels[shown]);
  if (wanted != shown)
  {
    Level& level = this->Levels[wanted];
    const View next = this->FindVisible(image, level);
    this->Prepare(image, level, this->ListLikely(level, next));
    this->Transfer(
      image, level, next, 0.9 * this->MotionBudget - this->Times.Predict(shown, view.Cells));
  }
  this->DrawTimed(image, shown, view);
}

//------------------------------------------------------------------------------
/** Makes ready what the first image in motion is likely to need, after an image at rest. */
void vtkGatunSurfaceMapper::vtkInternals::PrepareMotion(
  const Image& image, const View& view, double seconds)
{
  if (seconds > 0)
  {
    this->Times.Learn(0, view.Cells, seconds);
  }
  this->FindLevels();
  if (this->Levels.size() < 2)
  {
    return;
  }
  const std::vector<View> views = this->FindAllVisible(image);
  Level& last = this->Levels.back();
  bool isComplete = false;
  while (!isComplete)
  {
    const auto missing = this->FindMissing(image, last, views.back().Chunks);
    const auto parts = this->DecodeAll(last, missing, false);
    isComplete = missing.empty();
    for (std::size_t i = 0; i < missing.size() && !isComplete; ++i)
    {
      // An error is told by the image that needs the chunk.
      isComplete = parts[i].Failure != nullptr;
      if (!isComplete)
      {
        this->Adopt(image, last, missing[i], parts[i]);
        this->Keep(image, last.Chunks[missing[i]]);
        // Where there is no room at all.
        isComplete = !last.Chunks[missing[i]].Mapper;
      }
    }
  }
  this->Transfer(image, last, views.back(), this->MotionBudget);
  const std::size_t wanted =
    this->Times.Choose(this->MotionBudget, CountCells(views), this->Levels.size());
  if (wanted > 0)
  {
    Level& level = this->Levels[wanted];
    this->Prepare(image, level, this->ListLikely(level, views[wanted]));
    if (!this->Shared)
    {
      this->OrderCut(image, this->MotionBudget);
    }
  }
}
