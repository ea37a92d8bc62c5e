// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileLevelsOfDetail.h"

#include "gatunBaseMeshes.h"
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
FileLevelsOfDetail::FileLevelsOfDetail(std::shared_ptr<SharedFile> file, const RayValues& values)
  : File(std::move(file))
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
DetailLevel FileLevelsOfDetail::MakeUniform(std::uint64_t points)
{
  const auto place = this->File->Find(this->CountMerges(points));
  auto parts = this->File->MakeView(place.File, false);
  if (place.Merges == 0)
  {
    return { std::make_shared<FileRaySource>(std::move(parts), this->Values), points };
  }
  return { std::make_shared<CoarseRaySource>(
             std::move(parts), *place.Tree, MergeCut(*place.Tree, place.Merges), this->Values),
    points, CoarseRaySource::BytesPerPoint * place.File->GetNumberOfPoints() };
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
  const auto affordable = this->File->GetBudget()->GetBytes() / 4 / BytesPerPoint;
  auto finest =
    std::min(this->FindLevel(isForRest ? FinestToUniform * points
                                       : std::min(FinestToUniform * points, affordable)),
      coarse);
  while (!isForRest && finest < coarse && !this->File->MayHaveDependencies(finest))
  {
    ++finest;
  }
  const Bounds box = this->File->GetFile()->GetBounds();
  const double weight = DetailWeights(view.View, GetDiagonal(box)).Get(box);
  return FindBaseMesh(*this->File, coarse, finest, { points, view.PixelError, weight });
}

//------------------------------------------------------------------------------
std::shared_ptr<RayChunks> FileLevelsOfDetail::GetChunks(std::size_t level)
{
  this->Chunks.resize(this->File->GetNumberOfLevels());
  auto& chunks = this->Chunks[level];
  if (!chunks)
  {
    const auto file = this->File->GetLevel(level).File;
    auto parts = this->File->MakeView(file, false);
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
    this->Cuts = std::make_unique<FileCuts>(
      std::move(bases), std::move(dependencies), this->File->GetBudget(), progress);
    this->Fine = fine;
    this->Coarse = coarse;
  }
  return this->Cuts.get();
}

//------------------------------------------------------------------------------
DetailLevel FileLevelsOfDetail::MakeLevel(
  const DetailRequest& wanted, const RaySource::Progress& progress)
{
  const auto [points, view] = this->Clamp(wanted);
  if (!view)
  {
    return this->MakeUniform(points);
  }
  const auto all = this->GetNumberOfPoints();
  const bool isForRest = points == all;
  const auto coarse = this->FindLevel(isForRest ? std::min(all, PointsForRest) : points);
  const auto fine = this->FindFinest(*view, points, isForRest, coarse);
  FileCuts* const cuts = this->FindCuts(fine, coarse, progress);
  return cuts ? cuts->Make(*view, points) : this->MakeUniform(points);
}

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::EstimateTets(std::uint64_t points) const
{
  return this->File->EstimateCells(this->CountMerges(points));
}
}
