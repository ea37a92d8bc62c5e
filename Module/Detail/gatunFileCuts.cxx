// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileCuts.h"

#include "gatunCoarseLayout.h"
#include "gatunCoarseRaySource.h"
#include "gatunDetailWeights.h"
#include "gatunError.h"
#include "gatunFileReader.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace gatun
{
namespace
{
constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

[[noreturn]] void ThrowUnlike(const FileReader& file)
{
  throw Error(ErrorCode::Corrupt, file.GetPath() + ": the trees of base meshes do not fit");
}

/** The points that no merge has, ascending. */
std::vector<std::uint32_t> FindUnmerged(const MergeTree& tree)
{
  std::vector<bool> isMerged(tree.GetNumberOfPoints(), false);
  for (const Merge& merge : tree.GetMerges())
  {
    isMerged[merge.Point] = true;
    isMerged[merge.Into] = true;
  }
  std::vector<std::uint32_t> unmerged;
  for (std::uint32_t point = 0; point < isMerged.size(); ++point)
  {
    if (!isMerged[point])
    {
      unmerged.push_back(point);
    }
  }
  return unmerged;
}

/** For each point of a tree, the point of a base mesh that it is merged into; the number of points
 * of the base mesh if that has no more merges. */
std::vector<std::uint32_t> FindNext(
  const MergeTree& fine, const MergeTree& coarse, const FileReader& file)
{
  if (coarse.GetMerges().size() > fine.GetMerges().size())
  {
    ThrowUnlike(file);
  }
  const auto before = fine.GetMerges().size() - coarse.GetMerges().size();
  std::vector<std::uint32_t> numbers(fine.GetNumberOfPoints(), None);
  const auto set = [&](std::uint32_t point, std::uint32_t number)
  {
    if (numbers[point] != None && numbers[point] != number)
    {
      ThrowUnlike(file);
    }
    numbers[point] = number;
  };
  for (std::size_t i = 0; i < coarse.GetMerges().size(); ++i)
  {
    set(fine.GetMerges()[before + i].Point, coarse.GetMerges()[i].Point);
    set(fine.GetMerges()[before + i].Into, coarse.GetMerges()[i].Into);
  }
  auto next = fine.FindAncestors(before);
  for (auto& point : next)
  {
    point = std::min(numbers[point], coarse.GetNumberOfPoints());
  }
  return next;
}

/** The points of a file, and the values around them. */
std::vector<VolumeDetail::Place> FindPlaces(RayChunks& chunks, const RaySource::Progress& progress)
{
  const FileReader& file = *chunks.GetFile();
  std::vector<VolumeDetail::Place> places(file.GetNumberOfPoints());
  // A point without tetrahedra is nowhere that matters.
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::fill(places.begin(), places.end(), VolumeDetail::Place{ { nan, nan, nan, nan }, {} });
  const auto count = file.GetChunks().size();
  for (std::uint32_t chunk = 0; chunk < count; ++chunk)
  {
    if (progress && !progress(static_cast<double>(chunk) / static_cast<double>(count)))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
    const auto block = chunks.Get(chunk);
    std::vector<std::uint32_t> points;
    CoarseLayout::EachRun(file, chunk,
      [&](std::uint32_t first, std::uint32_t last)
      {
        for (auto point = first; point < last; ++point)
        {
          points.push_back(point);
        }
      });
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      places[points[i]].Point = block->Points[i];
    }
    IncludeValues(block->Tets, block->Points, block->CellValues,
      [&](std::uint32_t corner) { return &places[points[corner]]; });
  }
  return places;
}
}

//------------------------------------------------------------------------------
FileCuts::FileCuts(std::vector<Base> bases, std::shared_ptr<const MergeDependencies> dependencies,
  std::shared_ptr<CacheBudget> budget, const RaySource::Progress& progress)
  : Budget(std::move(budget))
{
  for (Base& base : bases)
  {
    this->Levels.push_back({ std::move(base), {}, {} });
  }
  for (std::size_t i = 0; i + 1 < this->Levels.size(); ++i)
  {
    this->Levels[i].Next = FindNext(*this->Levels[i].Of.Tree, *this->Levels[i + 1].Of.Tree,
      *this->Levels[i + 1].Of.Chunks->GetFile());
  }
  for (Level& level : this->Levels)
  {
    level.Unmerged = FindUnmerged(*level.Of.Tree);
  }
  const Base& coarsest = this->Levels.back().Of;
  const auto count = coarsest.Tree->GetNumberOfPoints();
  std::vector<std::uint32_t> placeOf(this->Levels.front().Of.Tree->GetNumberOfPoints());
  std::iota(placeOf.begin(), placeOf.end(), 0u);
  for (std::size_t i = 0; i + 1 < this->Levels.size(); ++i)
  {
    const auto& next = this->Levels[i].Next;
    const auto end = this->Levels[i + 1].Of.Tree->GetNumberOfPoints();
    for (auto& place : placeOf)
    {
      place = place < next.size() ? next[place] : end;
    }
  }
  for (auto& place : placeOf)
  {
    place = std::min(place, count);
  }
  const FileReader& file = *this->Levels.front().Of.Chunks->GetFile();
  this->Detail = std::make_unique<VolumeDetail>(
    CutChooser(this->Levels.front().Of.Tree, std::move(dependencies), file.GetNumberOfPoints()),
    FindPlaces(*coarsest.Chunks, progress), std::move(placeOf), this->Levels.back().Unmerged,
    GetDiagonal(file.GetBounds()));
}

FileCuts::~FileCuts() = default;

//------------------------------------------------------------------------------
std::vector<std::vector<bool>> FileCuts::FindTooCoarse(const MergeCut& cut) const
{
  std::vector<std::vector<bool>> flags;
  flags.emplace_back(this->Levels.front().Of.Tree->GetNumberOfPoints() + 1, false);
  const auto all = cut.GetDone().size();
  for (std::size_t i = 0; i + 1 < this->Levels.size(); ++i)
  {
    const MergeTree& tree = *this->Levels[i].Of.Tree;
    const MergeTree& coarser = *this->Levels[i + 1].Of.Tree;
    const auto& next = this->Levels[i].Next;
    const std::vector<bool>& fine = flags.back();
    std::vector<bool> coarse(coarser.GetNumberOfPoints() + 1, false);
    for (std::size_t point = 0; point < next.size(); ++point)
    {
      if (fine[point])
      {
        coarse[next[point]] = true;
      }
    }
    const auto first = all - tree.GetMerges().size();
    const auto last = all - coarser.GetMerges().size();
    for (auto merge = first; merge < last; ++merge)
    {
      if (!cut.GetDone()[merge])
      {
        coarse[next[tree.GetMerges()[merge - first].Point]] = true;
      }
    }
    // Points without merges stay.
    if (fine.back())
    {
      coarse.back() = true;
    }
    for (const auto point : this->Levels[i + 1].Unmerged)
    {
      coarse[point] = coarse.back();
    }
    flags.push_back(std::move(coarse));
  }
  return flags;
}

//------------------------------------------------------------------------------
DetailLevel FileCuts::Make(const DetailView& view, std::uint64_t points)
{
  const MergeCut cut = this->Detail->Choose(view, points);
  const auto tooCoarse = this->FindTooCoarse(cut);
  const auto all = cut.GetDone().size();
  std::vector<CoarsePart> parts;
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < this->Levels.size(); ++i)
  {
    const Level& level = this->Levels[i];
    const MergeTree& tree = *level.Of.Tree;
    bytes += CoarseRaySource::BytesPerPoint * tree.GetNumberOfPoints();
    CoarseMask mask;
    if (i > 0)
    {
      mask.TooCoarse = tooCoarse[i];
    }
    if (i + 1 < this->Levels.size())
    {
      mask.NextTooCoarse.resize(level.Next.size());
      for (std::size_t point = 0; point < level.Next.size(); ++point)
      {
        mask.NextTooCoarse[point] = tooCoarse[i + 1][level.Next[point]];
      }
    }
    const auto first = static_cast<std::ptrdiff_t>(all - tree.GetMerges().size());
    parts.push_back({ level.Of.Chunks, &tree,
      MergeCut(tree, std::vector<bool>(cut.GetDone().begin() + first, cut.GetDone().end())),
      std::move(mask) });
  }
  const auto source =
    std::make_shared<CoarseRaySource>(std::move(parts), this->Budget, this->Last.lock().get());
  this->Last = source;
  return { source, cut.GetAncestors().size() - cut.GetNumberOfMerges(), bytes };
}
}
