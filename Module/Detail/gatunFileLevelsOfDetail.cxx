// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileLevelsOfDetail.h"

#include "gatunChunkCache.h"
#include "gatunCoarseRaySource.h"
#include "gatunDetailWeights.h"
#include "gatunFileCuts.h"
#include "gatunFileRaySource.h"
#include "gatunRayChunks.h"

#include <algorithm>

namespace gatun
{
namespace
{
// Memory of a mesh for views for each point of its finest base mesh, about: merges, dependencies
// and places. The coarsest base mesh with at least so many points may have twice as many.
constexpr std::uint64_t BytesPerPoint = 2 * 80;

// Points of the base mesh that is decoded as a whole for views with an error or a region, at least.
constexpr std::uint64_t PointsForRest = 20000;
}

//------------------------------------------------------------------------------
FileLevelsOfDetail::FileLevelsOfDetail(
  std::shared_ptr<const FileReader> file, const RayValues& values)
  : FileLevelsOfDetail(std::make_shared<SharedFile>(std::move(file)), false, values)
{
}

FileLevelsOfDetail::FileLevelsOfDetail(std::shared_ptr<SharedFile> shared, const RayValues& values)
  : FileLevelsOfDetail(std::move(shared), true, values)
{
}

FileLevelsOfDetail::FileLevelsOfDetail(
  std::shared_ptr<SharedFile> file, bool isShared, const RayValues& values)
  : File(std::move(file))
  , IsShared(isShared)
  , Values(values)
{
  this->File->RequireHierarchy();
  CheckRayValues(*this->File->GetFile(), values);
}

FileLevelsOfDetail::~FileLevelsOfDetail() = default;

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::GetNumberOfPoints() const
{
  return this->File->GetFile()->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::GetFewestPoints() const
{
  return this->GetNumberOfPoints() - this->File->GetFile()->GetNumberOfMerges();
}

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::CountMerges(std::uint64_t points) const
{
  const auto all = this->GetNumberOfPoints();
  return all - std::clamp(points, this->GetFewestPoints(), all);
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> FileLevelsOfDetail::MakeSource(
  std::uint64_t points, std::uint64_t budget)
{
  const auto place = this->File->Find(this->CountMerges(points));
  if (this->IsShared)
  {
    auto parts = this->File->MakeView(place.File, false);
    if (place.Merges == 0)
    {
      return std::make_shared<FileRaySource>(std::move(parts), this->Values);
    }
    return std::make_shared<CoarseRaySource>(
      std::move(parts), *place.Tree, MergeCut(*place.Tree, place.Merges), this->Values);
  }
  if (place.Merges == 0)
  {
    return std::make_shared<FileRaySource>(place.File, this->Values, budget);
  }
  return std::make_shared<CoarseRaySource>(
    place.File, *place.Tree, MergeCut(*place.Tree, place.Merges), this->Values, budget);
}

//------------------------------------------------------------------------------
DetailLevel FileLevelsOfDetail::MakeUniform(std::uint64_t points, std::uint64_t budget)
{
  const auto place = this->File->Find(this->CountMerges(points));
  const std::uint64_t bytes =
    place.Merges > 0 ? CoarseRaySource::BytesPerPoint * place.File->GetNumberOfPoints() : 0;
  return { this->MakeSource(points, budget), points, bytes };
}

//------------------------------------------------------------------------------
/** The coarsest level with at least so many points. */
std::size_t FileLevelsOfDetail::FindLevel(std::uint64_t points) const
{
  const auto merges = this->CountMerges(points);
  std::size_t found = 0;
  for (std::size_t i = 0; i < this->File->GetNumberOfLevels(); ++i)
  {
    found = this->File->GetMergesOfLevel(i) <= merges ? i : found;
  }
  return found;
}

//------------------------------------------------------------------------------
/** The finest level that a view needs, from a given one on. */
std::size_t FileLevelsOfDetail::FindFinest(
  const DetailView& view, std::uint64_t points, bool isForRest, std::size_t coarse)
{
  // In motion, a quarter of the budget is for what is known of all points.
  const auto affordable = this->Budget->GetBytes() / 4 / BytesPerPoint;
  auto finest =
    std::min(this->FindLevel(isForRest ? FinestToUniform * points
                                       : std::min(FinestToUniform * points, affordable)),
      coarse);
  while (!isForRest && finest < coarse && !this->File->MayHaveDependencies(finest))
  {
    ++finest;
  }
  const FileReader& file = *this->File->GetFile();
  const double weight =
    DetailWeights(view.View, GetDiagonal(file.GetBounds())).Get(file.GetBounds());
  auto level = coarse;
  const auto isEnough = [&]
  {
    // The error of the merges that lead to a level is at most that of the next one.
    const auto tree = this->File->GetLevel(level).Tree;
    return !tree->GetMerges().empty() &&
      tree->GetMerges().front().Error * weight <= view.PixelError;
  };
  while (level > finest && !isEnough())
  {
    --level;
  }
  return level;
}

//------------------------------------------------------------------------------
std::shared_ptr<RayChunks> FileLevelsOfDetail::GetChunks(std::size_t level)
{
  this->Chunks.resize(this->File->GetNumberOfLevels());
  auto& chunks = this->Chunks[level];
  if (!chunks)
  {
    const auto file = this->File->GetLevel(level).File;
    auto parts = this->IsShared ? this->File->MakeView(file, false)
                                : std::make_shared<ChunkCache>(file, this->Budget);
    parts->SetKeepsChunks(false);
    chunks = std::make_shared<RayChunks>(std::move(parts), this->Values, true);
  }
  return chunks;
}

//------------------------------------------------------------------------------
/** Null if there are no dependencies. */
FileCuts* FileLevelsOfDetail::FindCuts(
  std::size_t fine, std::size_t coarse, const RaySource::Progress& progress)
{
  if (!this->Cuts || fine != this->Fine || coarse != this->Coarse)
  {
    this->Cuts.reset();
    auto dependencies = this->File->GetDependencies(*this->File->GetLevel(fine).File, progress);
    if (!dependencies)
    {
      return nullptr;
    }
    std::vector<FileCuts::Base> bases;
    for (auto level = fine; level <= coarse; ++level)
    {
      bases.push_back({ this->GetChunks(level), this->File->GetLevel(level).Tree });
    }
    this->Cuts =
      std::make_unique<FileCuts>(std::move(bases), std::move(dependencies), this->Budget, progress);
    this->Fine = fine;
    this->Coarse = coarse;
  }
  return this->Cuts.get();
}

//------------------------------------------------------------------------------
DetailLevel FileLevelsOfDetail::MakeLevel(
  const DetailRequest& request, std::uint64_t budget, const RaySource::Progress& progress)
{
  const auto all = this->GetNumberOfPoints();
  const auto points = std::clamp(request.Points, this->GetFewestPoints(), all);
  const bool isWhole = points == all && !(request.View && request.View->PixelError > 0);
  if (!request.View || isWhole)
  {
    return this->MakeUniform(points, budget);
  }
  if (!this->Budget)
  {
    this->Budget = this->IsShared ? this->File->GetBudget() : std::make_shared<CacheBudget>(budget);
  }
  const bool isForRest = points == all;
  const auto coarse = this->FindLevel(isForRest ? std::min(all, PointsForRest) : points);
  const auto fine = this->FindFinest(*request.View, points, isForRest, coarse);
  FileCuts* const cuts = this->FindCuts(fine, coarse, progress);
  if (!cuts)
  {
    return this->MakeUniform(points, budget);
  }
  return cuts->Make(*request.View, points);
}

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::EstimateTets(std::uint64_t points) const
{
  return this->File->EstimateCells(this->CountMerges(points));
}
}
